/** Wall-clock time [ms], finer than Date.now(), the same in the page and in its workers. */
export const wallClock = (): number => performance.timeOrigin + performance.now();
