// Which language the page speaks. English is in the code; the others are fetched when chosen.
import { batch, signal } from "@preact/signals";
import type { Key } from "./en";
import { language, localNumber, type Language } from "./numbers";

/** What a language's file gives. */
export interface Speech {
  texts: Record<Key, string>;
  /** What the server says in English, in this language; null where no template fits. */
  told(english: string): string | null;
}

const KEPT = "housefly language";
const AGAIN = 3000;
/** How many untranslated sentences are remembered as such. */
const FOREIGN_KEPT = 500;

export const LANGUAGES: Record<Language, string> = { en: "English", ja: "日本語", de: "Deutsch" };

const SPEECHES: Record<Exclude<Language, "en">, () => Promise<Speech>> = {
  ja: async () => (await import("./ja")).JA,
  de: async () => (await import("./de")).DE,
};

const speech = signal<Speech | null>(null);
let wanted: Language = "en";

const isLanguage = (tag: string | null): tag is Language => tag !== null && tag in LANGUAGES;

/** What was chosen on this device, or the first language of the browser that the page speaks. */
function preferred(): Language {
  const chosen = localStorage.getItem(KEPT);
  const tags = [chosen, ...navigator.languages.map((tag) => tag.slice(0, 2).toLowerCase())];
  return tags.find(isLanguage) ?? "en";
}

/** Speak a language as soon as its texts are there; until then, and without contact, the old. */
async function speak(name: Language): Promise<void> {
  wanted = name;
  try {
    const found = name === "en" ? null : await SPEECHES[name]();
    if (wanted !== name) return;
    batch(() => {
      speech.value = found;
      language.value = name;
    });
    document.documentElement.lang = name;
  } catch {
    setTimeout(() => wanted === name && void speak(name), AGAIN);
  }
}

export function choose(name: Language): void {
  localStorage.setItem(KEPT, name);
  void speak(name);
}

type Values = Record<string, string | number>;

/**
 * A text of the page: the English one is its key. `one|many` are chosen by the value n; `{name}` is
 * replaced by a value, numbers as people write them; what follows a ^ tells two meanings apart.
 */
export function t(key: Key, values: Values = {}): string {
  const forms = (speech.value?.texts[key] ?? key).replace(/\^.*/, "").split("|");
  const isMany = forms.length > 1 && pluralOf(Number(values["n"])) !== "one";
  return forms[Number(isMany)]!.replace(/\{(\w+)\}/g, (_, name: string) => {
    const value = values[name]!;
    return typeof value === "number" ? localNumber(String(value)) : value;
  });
}

const pluralOf = (count: number): string => new Intl.PluralRules(language.value).select(count);

const foreign = new Set<string>();
/** Without the capital and the full stop that the page may have given it. */
const bare = (words: string): string => words.toLowerCase().replace(/\.$/, "");

/** What the server says, in the language of the page, or as it is where nobody has put it so. */
export function translated(english: string): string {
  const own = speech.value?.told(english) ?? null;
  if (own !== null || !speech.value || !english) return own ?? english;
  if (foreign.size >= FOREIGN_KEPT) foreign.clear();
  foreign.add(bare(english));
  return english;
}

/** The `lang` of an element that shows `translated` words: English where they still are. */
export const tongue = (words: string): "en" | undefined =>
  speech.value && foreign.has(bare(words)) ? "en" : undefined;

void speak(preferred());

export { decimal, language, type Language } from "./numbers";
