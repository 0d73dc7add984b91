// Read by the build, too.

/** Digits of a short name, to the base of 36. */
export const DIGITS = 5;

/** A short name of an English template, a number: the build writes these into a language's file. */
export function short(english: string): number {
  let hash = 0;
  for (const letter of english) hash = Math.imul(hash ^ letter.codePointAt(0)!, 0x1000193);
  return (hash >>> 0) % 36 ** DIGITS;
}
