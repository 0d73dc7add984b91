// Read by the build, too.

/** How long a short name is. */
export const SHORT = 5;
const ALL = 36 ** SHORT;

/** A short name of an English template: the build writes these into a language's file. */
export function short(english: string): string {
  let hash = 0;
  for (const letter of english) hash = Math.imul(hash ^ letter.codePointAt(0)!, 0x1000193);
  return ((hash >>> 0) + ALL).toString(36).slice(-SHORT);
}
