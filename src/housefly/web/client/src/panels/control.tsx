import { givesControl, takeControl, takeOver } from "../commands";
import { HoldButton } from "../controls/hold-button";
import { ThisDevice } from "../device/this-device";
import { refuse } from "../said";
import { flying, iFly, me, panel, toggle, verdict, viewers } from "../store";
import { ask, myName, rename } from "../wire/socket";
import { t, translated } from "../messages/language";

/** Who is here, who has control, and how it changes hands. */
export function Control() {
  if (panel.value !== "control") return null;
  return (
    <section class="sheet" role="dialog" aria-label={t("Control")}>
      <h2>{t("Control")}</h2>
      <p class="quiet">
        {t("One person has control.")}{" "}
        {t("Everybody else watches, and can still stop or land the drone.")}
      </p>
      <label class="field">
        {t("Your name")}
        <input
          type="text"
          maxLength={24}
          defaultValue={myName()}
          placeholder={t("Viewer {n}", { n: me.value })}
          onChange={(event) => rename(event.currentTarget.value.trim())}
        />
      </label>
      <ul class="people">
        {viewers.value.viewers.map((one) => (
          <li key={one.id}>
            <span>
              {one.name}
              {one.id === me.value && ` ${t("(you)")}`}
            </span>
            {verdict.value?.pilot === one.id && <strong>{t("has control")}</strong>}
            {iFly.value && one.id !== me.value && (
              <button type="button" class="quiet-button" onClick={() => void lease("give", one.id)}>
                {t("Hand over")}
              </button>
            )}
          </li>
        ))}
      </ul>
      <div class="row">
        <Take />
        <button type="button" class="quiet-button" onClick={() => toggle("invite")}>
          {t("Invite")}
        </button>
        <button type="button" class="quiet-button" onClick={() => (panel.value = "")}>
          {t("Close")}
        </button>
      </div>
      <ThisDevice />
    </section>
  );
}

function Take() {
  if (iFly.value) {
    return (
      <button type="button" class="quiet-button" onClick={() => void lease("release", 0)}>
        {t("Release control")}
      </button>
    );
  }
  if (flying.value && verdict.value?.pilot != null) {
    return (
      <HoldButton hold={takeControl} class="secondary" label={t("Take over control")}>
        <span>{t("Take over")}</span>
        <small aria-hidden="true">{t("hold")}</small>
      </HoldButton>
    );
  }
  return (
    <button type="button" class="quiet-button" onClick={() => void takeOver(false)}>
      {t("Take control")}
    </button>
  );
}

async function lease(action: "release" | "give", to: number): Promise<void> {
  givesControl();
  const answer = await ask({ type: "lease", action, to });
  if (answer.type === "refused") refuse(translated(answer.reason), null);
}
