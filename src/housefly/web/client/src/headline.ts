// The line at the top: the server's verdict, or what this page can say without its server.
import { computed } from "@preact/signals";
import { nameOf, situations, things, trouble } from "./live/store";
import { isWorry, worthSaying } from "./live/words";
import { capital, sentence } from "./format";
import { contact, lineLives, silence, verdict } from "./store";
import type { HeadlineShape } from "./wire/messages";
import { t, translated } from "./messages/language";

export type Shape = HeadlineShape;

export interface Headline {
  shape: Shape;
  text: string;
  detail: string;
}

const lost = (text: string, detail = ""): Headline => ({ shape: "lost", text, detail });

/** Until the first verdict: an open line alone says nothing of the drone. */
export const isConnecting = computed(
  () => contact.value === "connecting" || (contact.value === "open" && !verdict.value),
);

export const headline = computed<Headline>(() => {
  if (contact.value === "elsewhere")
    return lost(t("Opened in another tab"), t("this one only watches the past"));
  if (contact.value === "shut out") return lost(t("Session ended"), t("use a fresh link"));
  const told = verdict.value;
  if (isConnecting.value) return lost(t("Connecting"));
  if (!lineLives.value)
    return lost(
      t("No contact with the server"),
      told ? t("for {n} s", { n: Math.round(silence.value) }) : "",
    );
  if (!told) return lost(t("Waiting for the pilot"));
  return {
    shape: told.shape,
    text: translated(told.headline),
    detail: (told.shape === "ready" && household()) || translated(told.detail),
  };
});

/** How the people and things at home are, while the drone rests; "" where nobody knows. */
function household(): string {
  if (things.value.size === 0 || trouble.value) return "";
  const worry = worthSaying(situations.value).find((one) => isWorry(one.kind));
  if (!worry) return t("Everything is quiet.");
  const [name, words] = [nameOf(worry.thing), translated(worry.words)];
  return words.toLowerCase().includes(name.toLowerCase())
    ? sentence(words)
    : `${capital(name)}: ${words}`;
}

/** What must be read before anything else on the screen, or "". */
export const banner = computed(() => {
  if (contact.value === "elsewhere")
    return t("This console was opened in another tab; that one is live.");
  if (contact.value === "shut out")
    return t("This browser's session has ended. Ask for a fresh link.");
  if (isConnecting.value) return "";
  const told = verdict.value;
  if (lineLives.value) return translated(told?.banner ?? "");
  if (!told) return t("No contact with the server: nothing is known of the drone.");
  const values = { n: Math.round(silence.value), then: translated(told.if_contact_lost) };
  const since = t("No word from the server for {n} s: what is shown is of then.", values);
  const then = t("What held then: {then}. STOP from this page may not arrive.", values);
  return `${since} ${then}`;
});
