// For screen readers: the state politely, at most once a second; faults and lost contact at once.
import { computed, effect, signal } from "@preact/signals";
import { contact, events, flying, inContact, state } from "../store";
import { headline } from "../headline";

const PERIOD = 1000;
const polite = signal("");

let spokenAt = 0;
let timer = 0;

effect(() => {
  const words = headline.value.text;
  clearTimeout(timer);
  timer = window.setTimeout(
    () => {
      spokenAt = Date.now();
      polite.value = words;
    },
    Math.max(0, spokenAt + PERIOD - Date.now()),
  );
});

const lastFault = computed(
  () => events.value.filter((event) => event.severity === "fault").at(-1)?.text ?? "",
);

const LOST = "No contact: a drone that is flying hovers or lands by itself.";

/** The warning across the screen when what it shows is the past. */
export function Announcer() {
  const lost =
    !inContact.value &&
    contact.value !== "connecting" &&
    (state.value !== null || contact.value === "lost");
  return (
    <>
      <p class="spoken" role="status">
        {polite.value}
      </p>
      <p class="spoken" role="alert">
        {lastFault.value}
      </p>
      <p class="banner" role="alert" data-flying={flying.value} hidden={!lost}>
        {lost ? words() : ""}
      </p>
    </>
  );
}

function words(): string {
  if (contact.value === "elsewhere")
    return "This console was opened in another tab; that one is live.";
  if (contact.value === "shut out")
    return "This browser's session has ended. Ask for a fresh link.";
  return LOST;
}
