// Numbers as text.
import { decimal, language } from "./messages/numbers";

export function milliseconds(seconds: number): string {
  return seconds < 0.9995 ? `${Math.round(seconds * 1000)} ms` : `${decimal(seconds, 1)} s`;
}

export function minutes(seconds: number): string {
  const whole = Math.max(0, Math.round(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** The words with a capital and a full stop, unless they end otherwise. */
export function sentence(words: string): string {
  const capital = words.charAt(0).toUpperCase() + words.slice(1);
  if (/[.…?!。？！]$/.test(capital)) return capital;
  return capital + (language.value === "ja" ? "。" : ".");
}

export const percent = (share: number): string => `${Math.round(100 * share)} %`;
