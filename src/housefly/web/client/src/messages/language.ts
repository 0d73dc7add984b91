// The texts of the console in the language of the device; see `speech.ts`.
import type { Key } from "./en";
import { speakBy, text, type Values } from "./speech";

export const t: (key: Key, values?: Values) => string = text;

speakBy({
  ja: async () => (await import("./ja-speech")).JA,
  de: async () => (await import("./de-speech")).DE,
});

export { decimal, language, type Language } from "./numbers";
export { choose, ideasToAsk, LANGUAGES, tongue, translated } from "./speech";
