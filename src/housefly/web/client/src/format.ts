// Numbers as text.
export function milliseconds(seconds: number): string {
  return seconds < 0.9995 ? `${Math.round(seconds * 1000)} ms` : `${seconds.toFixed(1)} s`;
}

export function minutes(seconds: number): string {
  const whole = Math.max(0, Math.round(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** The words with a capital and a full stop, unless they end otherwise. */
export function sentence(words: string): string {
  const capital = words.charAt(0).toUpperCase() + words.slice(1);
  return /[.…?!]$/.test(capital) ? capital : `${capital}.`;
}

export const percent = (share: number): string => `${Math.round(100 * share)} %`;
