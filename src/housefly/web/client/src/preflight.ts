// Whether the drone may take off, in words, and what else a person should know before it does.
import { computed } from "@preact/signals";
import { sentence } from "./format";
import { flying, lineLives, verdict } from "./store";
import { t, translated } from "./messages/language";

/** Whether the checks are not in yet, as after each landing: nothing is wrong so far. */
export const looking = computed(() => verdict.value?.reasons[0]?.code === "checks");

/** The one line about readiness, and beside it what forbids nothing but should be known. */
export const readiness = computed(() => {
  const told = verdict.value;
  if (!lineLives.value || !told)
    return { ready: false, text: t("Not known: no contact with the server"), known: [] };
  const known = told.known.map(translated);
  if (flying.value) return { ready: true, text: t("In flight"), known };
  if (looking.value) return { ready: true, text: sentence(translated(told.detail)), known };
  const why = translated(told.reasons[0]?.words ?? "");
  const text = why ? t("Not ready: {why}", { why }) : t("Ready");
  const mend = translated(told.reasons[0]?.mend ?? "");
  return { ready: told.may_take_off, text, mend, known };
});
