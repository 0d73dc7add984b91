// Which language a page speaks. English is in the code; the others are fetched when chosen.
import { batch, signal } from "@preact/signals";
import type { Said } from "../wire/messages";
import { language, localNumber, type Language } from "./numbers";
import { short } from "./short";

/** English template to the same in another language; the names in braces are the same in both. */
export type Templates = Readonly<Record<string, string>>;

/** What a language's file gives; English texts and templates are known by their `short` there. */
export interface Speech {
  /** What the page itself says. */
  texts: Templates;
  /** What the server says by a template. */
  templates: Templates;
  /** What one may ask here; English ideas come with the names of the room. */
  ideas?: string[];
}

/** What fetches the files of a page's other languages. */
export type Speeches = Record<Exclude<Language, "en">, () => Promise<Speech>>;

const KEPT = "housefly language";
const AGAIN = 3000;
/** How long the pages of the server alone know what was chosen [s]. */
const COOKIE_AGE = 400 * 86400;
/** How many untranslated sentences are remembered as such. */
const FOREIGN_KEPT = 500;

export const LANGUAGES: Record<Language, string> = { en: "English", ja: "日本語", de: "Deutsch" };

const speech = signal<Speech | null>(null);
let speeches: Speeches;
let wanted: Language = "en";

const isLanguage = (tag: string | null): tag is Language => tag !== null && tag in LANGUAGES;

/** What was chosen on this device, or the first language of the browser that the page speaks. */
function preferred(): Language {
  const chosen = localStorage.getItem(KEPT);
  if (isLanguage(chosen)) tellServer(chosen);
  const tags = [chosen, ...navigator.languages.map((tag) => tag.slice(0, 2).toLowerCase())];
  return tags.find(isLanguage) ?? "en";
}

/** Speak the language of this device with a page's own files. */
export function speakBy(files: Speeches): void {
  speeches = files;
  void speak(preferred());
}

/** Speak a language as soon as its texts are there; until then, and without contact, the old. */
async function speak(name: Language): Promise<void> {
  wanted = name;
  try {
    const found = name === "en" ? null : await speeches[name]();
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
  tellServer(name);
  void speak(name);
}

/** The pages that the server writes alone, such as the login, are in that language too. */
function tellServer(name: Language): void {
  document.cookie = `housefly-language=${name}; path=/; samesite=strict; max-age=${COOKIE_AGE}`;
}

export type Values = Record<string, string | number>;

/**
 * A text of the page: the English one is its key. `one|many` are chosen by the value n; `{name}` is
 * replaced by a value, numbers as people write them; what follows a ^ tells two meanings apart.
 */
export function text(key: string, values: Values = {}): string {
  const forms = (speech.value?.texts[short(key)] ?? key).replace(/\^.*/, "").split("|");
  const isMany = forms.length > 1 && pluralOf(Number(values["n"])) !== "one";
  return forms[Number(isMany)]!.replace(/\{(\w+)\}/g, (_, name: string) => {
    const value = values[name]!;
    return typeof value === "number" ? localNumber(String(value)) : value;
  });
}

const pluralOf = (count: number): string => new Intl.PluralRules(language.value).select(count);

export const ideasToAsk = (): string[] | undefined => speech.value?.ideas;

const foreign = new Set<string>();
/** Without the capital and the full stop that the page may have given it. */
const bare = (words: string): string => words.toLowerCase().replace(/\.$/, "");

const PLACE = /\{\w+\}/g;

/** What the server says, in the language of the page, or as it is where nobody has put it so. */
export function translated(said: Said): string {
  const [english, ...values] = typeof said === "string" ? [said] : said;
  const own = speech.value?.templates[short(english)];
  const words = values.length ? filled(own ?? english, english, values) : (own ?? english);
  if (own == null && words) {
    if (foreign.size >= FOREIGN_KEPT) foreign.clear();
    foreign.add(bare(words));
  }
  return words;
}

function filled(own: string, english: string, values: (Said | { n: string })[]): string {
  const names: string[] = english.match(PLACE)!;
  return own.replace(PLACE, (name) => {
    const one = values[names.indexOf(name)] as { n?: string };
    return one.n ? localNumber(one.n) : translated(one as Said);
  });
}

/** The `lang` of an element that shows `translated` words: English where they still are. */
export const tongue = (words: string): "en" | undefined =>
  speech.value && foreign.has(bare(words)) ? "en" : undefined;
