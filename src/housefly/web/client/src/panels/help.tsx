import { KEYS, letters, useLetters } from "../keymap";
import { showHints } from "../hints/hints";
import type { Key } from "../messages/en";
import { LanguageChoice } from "../messages/language-choice";
import { panel } from "../store";
import { t } from "../messages/language";

/** All keys. Not modal: STOP stays within reach. */
export function Help() {
  if (panel.value !== "help") return null;
  return (
    <section class="sheet" role="dialog" aria-label={t("Keys")}>
      <h2>{t("Keys")}</h2>
      <div class="row">
        <LanguageChoice />
        <button type="button" class="quiet-button" onClick={showHints}>
          {t("Show the first steps again")}
        </button>
      </div>
      <table>
        <tbody>
          {KEYS.map((key) => (
            <tr key={key.shown}>
              <th scope="row">
                <kbd>{t(key.shown as Key)}</kbd>
              </th>
              <td>{t(key.does as Key)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="quiet">
        {t("Space stops the drone even while you type, as long as it flies.")}{" "}
        {t("On the ground it types a space, or presses the button that has the focus.")}
      </p>
      <label class="choice">
        <input
          type="checkbox"
          checked={letters.value}
          onChange={(event) => useLetters(event.currentTarget.checked)}
        />
        {t("Letters and ? are keys")}
      </label>
      <button type="button" class="quiet-button" onClick={() => (panel.value = "")}>
        {t("Close")}
      </button>
    </section>
  );
}
