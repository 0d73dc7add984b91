import { language, type Language } from "./numbers";
import { choose, LANGUAGES } from "./speech";

/** What the field is called: in English, too, for whoever cannot read the language it shows. */
const NAMES: Record<Language, string> = {
  en: "Language · 言語 · Sprache",
  ja: "言語 · Language",
  de: "Sprache · Language",
};

/** The language of the page on this device. */
export function LanguageChoice() {
  return (
    <label class="field">
      <span>{NAMES[language.value]}</span>
      <select
        value={language.value}
        onChange={(event) => choose(event.currentTarget.value as Language)}
      >
        {Object.entries(LANGUAGES).map(([name, title]) => (
          <option key={name} value={name} lang={name}>
            {title}
          </option>
        ))}
      </select>
    </label>
  );
}
