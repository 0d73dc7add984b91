import { signal } from "@preact/signals";
import { Sensors } from "../live/sensors";
import { Battery } from "../panels/battery";
import { Log } from "../panels/log";
import { Readings } from "../panels/readings";
import { looking } from "../preflight";
import { hasDrone, lineLives, panel, verdict } from "../store";
import { sentence } from "../format";
import { Sim } from "../sim/sim";
import { Told } from "../messages/told";
import { t, translated } from "../messages/language";

const details = signal(false);

/** What a person should know beside the scene; the engineer's figures behind Details. */
export function Side() {
  return (
    <aside class="side" aria-label={t("Drone and house")}>
      {hasDrone.value && <Reasons />}
      {hasDrone.value && <Battery />}
      <Sim />
      {details.value ? (
        <section class="card details" aria-label={t("Details")} tabIndex={0} data-scrolls>
          <div class="row">
            <h2>{t("Details")}</h2>
            <Turn />
          </div>
          {hasDrone.value && <Readings />}
          <Sensors />
        </section>
      ) : (
        <Log>
          <Turn />
        </Log>
      )}
      <button type="button" class="shut" onClick={() => (panel.value = "")}>
        {t("Close")}
      </button>
    </aside>
  );
}

/** From the log to the engineer's figures, and back. */
function Turn() {
  return (
    <button type="button" class="turn" onClick={() => (details.value = !details.value)}>
      {details.value ? t("Log") : t("Details")}
    </button>
  );
}

/** Each thing that forbids a take-off with its mend, or what the drone does if contact is lost. */
function Reasons() {
  const told = verdict.value;
  if (!told || !lineLives.value) return null;
  if (told.may_be_airborne)
    return (
      <p class="card contact">
        {t("If contact is lost:")} <Told words={sentence(translated(told.if_contact_lost))} />
      </p>
    );
  if (told.reasons.length === 0 || looking.value) return null;
  return (
    <ul class="card reasons" aria-label={t("What is to be mended")}>
      {told.reasons.map((one) => (
        <li key={one.code}>
          ✕ <Told words={translated(one.words)} />
          {one.mend && (
            <small class="quiet">
              {" "}
              <Told words={translated(one.mend)} />
            </small>
          )}
        </li>
      ))}
    </ul>
  );
}
