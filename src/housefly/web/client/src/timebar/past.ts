// The room's past on the time bar.
import { signal } from "@preact/signals";
import { showAt } from "../live/room-client";
import { at, hubNow } from "../live/store";

/** The right end of the bar, fixed while the past is shown [Unix time, s]. */
export const endOf = signal(0);

/** Show the room at a time in the past [Unix time, s]; null is now. */
export function go(time: number | null): void {
  if (time !== null && (at.peek() === null || time > endOf.peek()))
    endOf.value = Math.max(hubNow.peek(), time);
  showAt(time);
}
