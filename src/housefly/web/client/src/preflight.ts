// Whether the drone may take off, in words, and what else a person should know before it does.
import { computed } from "@preact/signals";
import { flying, lineLives, verdict } from "./store";

/** The one line about readiness, and beside it what forbids nothing but should be known. */
export const readiness = computed(() => {
  const told = verdict.value;
  if (!lineLives.value || !told)
    return { ready: false, text: "Not known: no contact with the server", known: [] };
  if (flying.value) return { ready: true, text: "In flight", known: told.known };
  const why = told.reasons[0]?.words;
  return { ready: told.may_take_off, text: why ? `Not ready: ${why}` : "Ready", known: told.known };
});
