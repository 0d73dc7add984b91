// Read by the build, too.

/** A short name of an English template: the build writes these into a language's file. */
export function short(english: string): string {
  let hash = 0;
  for (const letter of english) hash = Math.imul(hash ^ letter.codePointAt(0)!, 0x1000193);
  return (hash >>> 0).toString(36);
}
