import { flying, lineLives, panel, preflight, verdict } from "../store";
import { capital, sentence } from "../format";
import { looking, readiness } from "../preflight";
import { Told } from "../messages/told";
import type { FlightObjection, PreflightCheck } from "../wire/messages";
import { t, tongue, translated } from "../messages/language";

const toggle = (): void => void (panel.value = panel.value === "checks" ? "" : "checks");

/** Whether the drone may take off: one line on every screen that unfolds to all checks. */
export function Readiness() {
  const n = preflight.value.checks.length;
  const { ready, known } = readiness.value;
  return (
    <div class="readiness" data-quiet={ready && known.length === 0}>
      <button type="button" aria-expanded={panel.value === "checks"} onClick={toggle}>
        <Line />
        <span class="more">
          <span>{n > 0 ? t("{n} check|{n} checks", { n }) : t("more")}</span> ▾
        </span>
      </button>
    </div>
  );
}

function Line() {
  const { ready, text, mend, known } = readiness.value;
  return (
    <span class="line">
      <strong data-ready={ready}>
        {!flying.value && !looking.value && (ready ? "✓ " : "✕ ")}
        {text}
      </strong>
      {mend && <span class="mend">{capital(mend)}</span>}
      {known.map((note) => (
        <span key={note} class="known" lang={tongue(note)}>
          △ {note}
        </span>
      ))}
    </span>
  );
}

/** All checks, those that need a look first. Not modal: STOP stays within reach. */
export function Checks() {
  const { checks } = preflight.value;
  const told = verdict.value;
  if (panel.value !== "checks" || !told) return null;
  const codes = checks.map((one) => one.code);
  const reasons = flying.value ? [] : told.reasons.filter((one) => !codes.includes(one.code));
  return (
    <section class="sheet checks" role="dialog" aria-label={t("Checks before take-off")}>
      <div class="row">
        <h2>{flying.value ? t("In flight") : t("Before take-off")}</h2>
        <button type="button" class="quiet-button" onClick={toggle}>
          {t("Close")}
        </button>
      </div>
      <p class="without">
        <strong>
          {lineLives.value ? t("If contact is lost now:") : t("As contact was lost:")}{" "}
        </strong>
        <Told words={sentence(translated(told.if_contact_lost))} />
      </p>
      <ul>
        {reasons.map((one) => (
          <Reason key={one.code} one={one} />
        ))}
        {[...checks]
          .sort((a, b) => rank(a) - rank(b))
          .map((one) => (
            <Check key={one.code} one={one} />
          ))}
      </ul>
    </section>
  );
}

const MARKS = ["✕", "△", "✓"];
const WORDS = ["no take-off", "look", "well"] as const;

function rank(check: PreflightCheck): number {
  return check.passed ? 2 : check.required ? 0 : 1;
}

function Reason({ one }: { one: FlightObjection }) {
  return (
    <li data-rank={0}>
      <span class="mark" aria-label={t(WORDS[0])}>
        {MARKS[0]}
      </span>
      <span class="what">
        <Told words={translated(one.words)} />
      </span>
      <p>
        <strong>
          <Told words={translated(one.mend)} />
        </strong>
      </p>
    </li>
  );
}

function Check({ one }: { one: PreflightCheck }) {
  const k = rank(one);
  return (
    <li data-rank={k}>
      <span class="mark" aria-label={t(WORDS[k]!)}>
        {MARKS[k]}
      </span>
      <span class="what">
        <Told words={translated(one.passed ? one.title : one.fault)} />
      </span>
      <span class="value">
        <Told words={translated(one.value)} />
      </span>
      <span class="quiet">
        <Told words={translated(one.limit)} />
      </span>
      <p>
        <Told words={translated(one.why)} />
        {!one.passed && (
          <strong>
            <Told words={translated(one.mend)} />
          </strong>
        )}
      </p>
    </li>
  );
}
