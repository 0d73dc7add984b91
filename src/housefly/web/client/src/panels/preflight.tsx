import { flying, panel, preflight } from "../store";
import { readiness } from "../preflight";
import type { PreflightCheck } from "../wire/messages";

const toggle = (): void => void (panel.value = panel.value === "checks" ? "" : "checks");

/** Whether the drone may take off: one line on every screen that unfolds to all checks. */
export function Readiness() {
  const { checks } = preflight.value;
  return (
    <div class="readiness">
      <button
        type="button"
        aria-expanded={panel.value === "checks"}
        aria-disabled={checks.length === 0}
        onClick={() => checks.length > 0 && toggle()}
      >
        <Line />
        {checks.length > 0 && (
          <span class="more">
            <span>{checks.length} checks</span> ▾
          </span>
        )}
      </button>
    </div>
  );
}

function Line() {
  const { ready, text, known } = readiness.value;
  return (
    <span class="line">
      <strong data-ready={ready}>
        {!flying.value && (ready ? "✓ " : "✕ ")}
        {text}
      </strong>
      {known.map((note) => (
        <span key={note} class="known">
          △ {note}
        </span>
      ))}
    </span>
  );
}

/** All checks, those that need a look first. Not modal: STOP stays within reach. */
export function Checks() {
  const { checks } = preflight.value;
  if (panel.value !== "checks" || checks.length === 0) return null;
  return (
    <section class="sheet checks" role="dialog" aria-label="Checks before take-off">
      <div class="row">
        <h2>Before take-off</h2>
        <button type="button" class="quiet-button" onClick={toggle}>
          Close
        </button>
      </div>
      <ul>
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
const WORDS = ["no take-off", "look", "well"];

function rank(check: PreflightCheck): number {
  return check.passed ? 2 : check.required ? 0 : 1;
}

function Check({ one }: { one: PreflightCheck }) {
  const k = rank(one);
  return (
    <li data-rank={k}>
      <span class="mark" aria-label={WORDS[k]}>
        {MARKS[k]}
      </span>
      <span class="what">{one.passed ? one.title : one.fault}</span>
      <span class="value">{one.value}</span>
      <span class="quiet">{one.limit}</span>
      <p>
        {one.why}
        {!one.passed && <strong>{one.mend}</strong>}
      </p>
    </li>
  );
}
