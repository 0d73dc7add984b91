import { standing } from "../preflight";
import { events } from "../store";
import { serverNow } from "../wire/clock";
import type { EventView, Severity } from "../wire/messages";

const MARK: Record<Severity, string> = { info: "·", warning: "△", fault: "✕" };
const SHOWN = 100;

/** What happened, newest first; every line arrives, whatever the line is like. */
export function Log() {
  const shown = events.value.slice(-SHOWN).reverse();
  return (
    <section class="card log" aria-label="Event log">
      <h2>Log</h2>
      <ul class="notes" aria-label="What holds now">
        {standing.value.map((note) => (
          <li key={note}>
            <span class="mark">△</span> {note}
          </li>
        ))}
      </ul>
      <ol tabIndex={0} data-scrolls>
        {shown.map((event) => (
          <li key={event.number} data-severity={event.severity}>
            <time>{clock(event)}</time>
            <span class="mark" aria-label={event.severity}>
              {MARK[event.severity]}
            </span>
            <span>{event.text.charAt(0).toUpperCase() + event.text.slice(1)}</span>
          </li>
        ))}
      </ol>
    </section>
  );
}

function clock(event: EventView): string {
  return new Date(Date.now() - 1000 * (serverNow() - event.at)).toTimeString().slice(0, 8);
}
