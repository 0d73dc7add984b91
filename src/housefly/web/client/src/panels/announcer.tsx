// For screen readers: the state politely, at most once a second; faults and lost contact at once.
import { computed, effect, signal } from "@preact/signals";
import { events } from "../store";
import { headline } from "../headline";
import { tongue, translated } from "../messages/language";

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

const lastFault = computed(() =>
  translated(events.value.filter((event) => event.severity === "fault").at(-1)?.text ?? ""),
);

/** What is heard and not seen. */
export function Announcer() {
  return (
    <>
      <p class="spoken" role="status" lang={tongue(polite.value)}>
        {polite.value}
      </p>
      <p class="spoken" role="alert" lang={tongue(lastFault.value)}>
        {lastFault.value}
      </p>
    </>
  );
}
