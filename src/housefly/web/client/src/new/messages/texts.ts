// The texts of the page of a new site in the language of the device; see `messages/speech.ts`.
import { speakBy, text, type Values } from "../../messages/speech";
import type { Key } from "./en";

export const t: (key: Key, values?: Values) => string = text;

speakBy({
  ja: async () => (await import("./ja-speech")).JA,
  de: async () => (await import("./de-speech")).DE,
});
