import { showHints } from "../hints/hints";
import { LanguageChoice } from "../messages/language-choice";
import { mayGoDark } from "../wake-lock";
import { install, installing } from "./install";
import { notifies, permission, switchOff, switchOn } from "./notify";
import { canSound } from "./sounds";
import { t } from "../messages/language";

/** What this phone or computer does for whoever holds it: rings, stays awake, has an app. */
export function ThisDevice() {
  const how = installing();
  return (
    <section class="device" aria-label={t("This device")}>
      <h3>{t("This device")}</h3>
      <LanguageChoice />
      <button type="button" class="quiet-button" onClick={showHints}>
        {t("Show the first steps again")}
      </button>
      <label class="choice">
        <input
          type="checkbox"
          checked={notifies.value}
          onChange={(event) => (event.currentTarget.checked ? void switchOn() : switchOff())}
        />
        {t("Ring for the doorbell and for faults")}
      </label>
      {notifies.value && <p class="quiet">{ringing()}</p>}
      {how === "offered" && (
        <button type="button" class="quiet-button" onClick={() => void install()}>
          {t("Install as an app")}
        </button>
      )}
      {how === "by hand" && <p class="quiet">{t("As an app: Share, then Add to Home Screen.")}</p>}
      {mayGoDark.value && (
        <p class="quiet">
          {t("This browser does not keep the screen on while the drone flies.")}
        </p>
      )}
    </section>
  );
}

function ringing(): string {
  const here = canSound.value
    ? t("It sounds while the page is open.")
    : t("It sounds from your next touch on, while the page is open.");
  const beside =
    permission.value === "granted"
      ? t("It notifies beside other pages.")
      : permission.value === "denied"
        ? t("Notifications are forbidden: its settings in the browser allow them.")
        : "";
  return `${here} ${beside}`;
}
