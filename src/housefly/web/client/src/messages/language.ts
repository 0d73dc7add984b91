// The texts of the console in the language of the device; see `speech.ts`.
import type { Key } from "./en";
import { speakBy, text, type Speech as AnySpeech, type Values } from "./speech";

export type Speech = AnySpeech<Key>;

export const t: (key: Key, values?: Values) => string = text;

speakBy({
  ja: async () => (await import("./ja")).JA,
  de: async () => (await import("./de")).DE,
});

export { decimal, language, type Language } from "./numbers";
export { choose, ideasToAsk, LANGUAGES, tongue, translated } from "./speech";
