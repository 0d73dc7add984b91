import { signal } from "@preact/signals";
import { lazyPart } from "../lazy-part";
import { Sensors } from "../live/sensors";
import { Battery } from "../panels/battery";
import { Log } from "../panels/log";
import { Readings } from "../panels/readings";
import { replaying } from "../replay/replay";
import { looking } from "../preflight";
import { hasDrone, lineLives, panel, verdict } from "../store";
import { sentence } from "../format";
import { Sim } from "../sim/sim";
import { Told } from "../messages/told";
import { t, translated } from "../messages/language";

/** As many as fill the side of a large screen. */
const LINES = 12;

const details = signal(false);
const Feed = lazyPart(async () => (await import("../later")).Feed);
const AfterCard = lazyPart(async () => (await import("../later")).AfterCard);

/** What happened, beside the scene; battery, figures and the raw log behind Details. */
export function Side() {
  return (
    <aside class="side" aria-label={t("Drone and house")}>
      {hasDrone.value && <Reasons />}
      <Sim />
      {details.value ? (
        <section class="card details" aria-label={t("Details")} tabIndex={0} data-scrolls>
          <div class="row">
            <h2>{t("Details")}</h2>
            <Turn />
          </div>
          {hasDrone.value && (
            <>
              <Battery />
              <Readings />
            </>
          )}
          <Sensors />
          <Log />
        </section>
      ) : replaying.value ? (
        <Log />
      ) : (
        <section class="card lately" tabIndex={0} aria-label={t("What happened")} data-scrolls>
          <AfterCard />
          <Feed limit={LINES} />
          <Turn />
        </section>
      )}
      <button type="button" class="shut" onClick={() => (panel.value = "")}>
        {t("Close")}
      </button>
    </aside>
  );
}

/** From what happened to the engineer's figures, and back. */
function Turn() {
  return (
    <button type="button" class="turn" onClick={() => (details.value = !details.value)}>
      {details.value ? t("Close") : t("Details")}
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
