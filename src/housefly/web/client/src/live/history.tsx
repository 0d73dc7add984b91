import { signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { askEvents, keyOf, showAt } from "./room-client";
import { at, events, hubNow, moment, only, picture, span, things, trouble } from "./store";
import { ago, clock, happened, kindOf } from "./words";

const SPANS: [number, string][] = [
  [120, "2 min"],
  [600, "10 min"],
  [3600, "1 h"],
  [21600, "6 h"],
  [86400, "1 day"],
  [604800, "1 week"],
];
const STEPS = 600;
const LISTED = 200;
/** An event is shown with what it brought about [s]. */
const AFTER = 0.5;

/** The right end of the slider, fixed while the past is shown. */
const end = signal(0);

function go(time: number | null): void {
  if (time !== null && (at.value === null || time > end.value))
    end.value = Math.max(hubNow.value, time);
  showAt(time);
}

/** Moves the whole map to another time; the right end is now. */
export function History() {
  const past = at.value !== null;
  const right = past ? end.value : hubNow.value;
  const value = past ? Math.max(-span.value, at.value! - right) : 0;
  const words = past ? `${clock(at.value!)}, ${ago(hubNow.value - at.value!)}` : "now";
  const marks = events.value.filter((event) => event.at > right - span.value && event.at <= right);
  return (
    <section class="card history" aria-label="History" data-past={past}>
      <strong class="when">{past ? words : `Now, ${clock(moment.value)}`}</strong>
      <button type="button" class="now" aria-disabled={!past} onClick={() => go(null)}>
        Now
      </button>
      <select
        aria-label="How far back"
        value={span.value}
        onChange={(event) => {
          span.value = Number(event.currentTarget.value);
          void askEvents();
        }}
      >
        {SPANS.map(([seconds, name]) => (
          <option key={seconds} value={seconds}>
            {name}
          </option>
        ))}
      </select>
      <div class="slider">
        <div class="marks" aria-hidden="true">
          {marks.map((event) => (
            <i
              key={keyOf(event)}
              style={{ left: `${100 * (1 - (right - event.at) / span.value)}%` }}
            />
          ))}
        </div>
        <input
          type="range"
          aria-label="Time shown"
          aria-valuetext={words}
          min={-span.value}
          max={0}
          step={span.value / STEPS}
          value={value}
          onInput={(event) => {
            const back = Number(event.currentTarget.value);
            go(back < 0 ? right + back : null);
          }}
        />
      </div>
    </section>
  );
}

/** Across the map, so that nobody takes the past for the present. */
export function PastBanner() {
  if (at.value === null) return null;
  return (
    <p class="past-banner" role="status">
      <strong>{picture.value ? "The past" : "Fetching the past"}</strong>
      <span>
        {clock(at.value)}, {ago(hubNow.value - at.value)}
      </span>
      <button type="button" onClick={() => go(null)}>
        Back to now
      </button>
    </p>
  );
}

/** What happened, newest first; a press shows the room as it was then. */
export function Events({ children }: { children: ComponentChildren }) {
  const whose = [...things.value.values()].filter(
    (one) => ["person", "robot", "object"].includes(kindOf(one)) || one.age !== null,
  );
  const shown = events.value.slice(-LISTED).reverse();
  return (
    <section class="card happened" aria-label="What happened">
      <div class="row">
        <h2>What happened</h2>
        <select
          aria-label="Only of"
          value={only.value}
          onChange={(event) => {
            only.value = event.currentTarget.value;
            askEvents().catch((error: Error) => (trouble.value = error.message));
          }}
        >
          <option value="">everything</option>
          {whose.map((one) => (
            <option key={one.thing} value={one.thing}>
              {one.name}
            </option>
          ))}
        </select>
      </div>
      {children}
      <ol tabIndex={0} data-scrolls>
        {shown.map((event) => (
          <li key={keyOf(event)}>
            <button
              type="button"
              aria-current={at.value === event.at + AFTER}
              title="Show the room as it was then"
              onClick={() => go(event.at + AFTER)}
            >
              <time>{clock(event.at)}</time>
              <span>{happened(event)}</span>
            </button>
          </li>
        ))}
      </ol>
      {shown.length === 0 && <p class="quiet">Nothing in this time.</p>}
    </section>
  );
}
