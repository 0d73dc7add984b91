// The line at the top: the server's verdict, or what this page can say without its server.
import { computed } from "@preact/signals";
import { contact, lineLives, silence, verdict } from "./store";
import type { HeadlineShape } from "./wire/messages";

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
    return lost("Opened in another tab", "this one only watches the past");
  if (contact.value === "shut out") return lost("Session ended", "use a fresh link");
  const told = verdict.value;
  if (isConnecting.value) return lost("Connecting");
  if (!lineLives.value)
    return lost("No contact with the server", told ? `for ${Math.round(silence.value)} s` : "");
  if (!told) return lost("Waiting for the pilot");
  return { shape: told.shape, text: told.headline, detail: told.detail };
});

/** What must be read before anything else on the screen, or "". */
export const banner = computed(() => {
  if (contact.value === "elsewhere")
    return "This console was opened in another tab; that one is live.";
  if (contact.value === "shut out")
    return "This browser's session has ended. Ask for a fresh link.";
  if (isConnecting.value) return "";
  const told = verdict.value;
  if (lineLives.value) return told?.banner ?? "";
  if (!told) return "No contact with the server: nothing is known of the drone.";
  const since = `No word from the server for ${Math.round(silence.value)} s`;
  const then = `what is shown is of then. What held then: ${told.if_contact_lost}`;
  return `${since}: ${then}. STOP from this page may not arrive.`;
});
