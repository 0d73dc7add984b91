// Numbers as text.
import { decimal, language } from "./messages/numbers";

export function milliseconds(seconds: number): string {
  return seconds < 0.9995 ? `${Math.round(seconds * 1000)} ms` : `${decimal(seconds, 1)} s`;
}

export function minutes(seconds: number): string {
  const whole = Math.max(0, Math.round(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

export const capital = (words: string): string => words.charAt(0).toUpperCase() + words.slice(1);

/** The words with a capital and a full stop, unless they end otherwise. */
export function sentence(words: string): string {
  const begun = capital(words);
  if (/[.…?!。？！]$/.test(begun)) return begun;
  return begun + (language.value === "ja" ? "。" : ".");
}

export const percent = (share: number): string => `${Math.round(100 * share)} %`;
