// Whether the drone may take off, in words, and what else a person should know before it does.
import { computed, signal, type ReadonlySignal } from "@preact/signals";
import { flying, inContact, link, preflight, state } from "./store";
import type { PreflightCheck } from "./wire/messages";

/** What is wrong at this moment: notes of the pilot's wires, notes and complaints of the drone. */
export const standing = computed(() => {
  const wires = link.value?.link.notes ?? [];
  // The drone's link tells the drone's notes, too.
  const own = (state.value?.notes ?? []).filter((note) => !wires.some((one) => one.includes(note)));
  return [...wires, ...own, ...(state.value?.faults ?? [])];
});

/** Why the pilot would refuse a take-off; "" when it would not, and in flight. */
export const refusal = computed(() => {
  if (flying.value || preflight.value.ready) return "";
  return failing.value?.fault ?? "the checks before a take-off are not in yet";
});

const failing = computed(() =>
  preflight.value.checks.find((check) => check.required && !check.passed),
);

/** The one line about readiness, and beside it what forbids nothing but should be known. */
export const readiness = computed(() => {
  const { checks } = preflight.value;
  const warnings = checks.filter((one) => !one.required && !one.passed);
  if (flying.value) return { ready: true, text: "In flight", known: standing.value };
  const why = inContact.value ? refusal.value : "no contact with the pilot";
  const found = inContact.value && failing.value ? told(failing.value) : why;
  return {
    ready: !why,
    text: why ? `Not ready: ${found}` : "Ready",
    known: checks.length ? warnings.map(told) : standing.value,
  };
});

const told = (check: PreflightCheck): string => `${check.fault} (${check.value})`;

const RECENTLY = 8000;

interface Refused {
  objection: ReadonlySignal<string>;
  words: string;
}

const refused = signal<Refused | null>(null);
let timer = 0;

/** Say for a while, as long as it holds, why a button did nothing. */
export function explain(objection: ReadonlySignal<string>): void {
  refused.value = { objection, words: objection.value };
  clearTimeout(timer);
  timer = window.setTimeout(() => (refused.value = null), RECENTLY);
}

/** Why the button that was just pressed did nothing, or "". */
export const explanation = computed(() => {
  const last = refused.value;
  return last?.objection.value === last?.words ? (last?.words ?? "") : "";
});
