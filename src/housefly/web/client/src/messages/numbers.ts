// The language that is spoken now, and its numbers.
import { signal } from "@preact/signals";

export type Language = "en" | "ja" | "de";

export const language = signal<Language>("en");

/** Digits as people read them: a decimal comma in German. */
export const localNumber = (digits: string): string =>
  language.value === "de" ? digits.replace(".", ",") : digits;

export const decimal = (value: number, digits: number): string =>
  localNumber(value.toFixed(digits));
