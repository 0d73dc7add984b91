import { computed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { minutes } from "../format";
import { askEvents } from "../live/room-client";
import { at, events, hubNow, span } from "../live/store";
import type { Key } from "../messages/en";
import { ago, clock } from "../live/words";
import { lazyPart } from "../lazy-part";
import { flying } from "../store";
import {
  askFlights,
  flights,
  liveAgain,
  openFlight,
  replay,
  replayObjection,
  trouble,
} from "../replay/replay";
import type { FlightView } from "../wire/room-messages";
import { endOf, go } from "./past";
import { t, translated } from "../messages/language";

const Recording = lazyPart(async () => (await import("../later")).Recording);

const SPANS: [number, Key][] = [
  [600, "10 min"],
  [3600, "1 h"],
  [21600, "6 h"],
  [86400, "1 day"],
  [604800, "1 week"],
];
const STEPS = 600;
const LANDED_FOR = 3000;

/** Time at the foot of the scene: now, the room's past, and the flights as blocks. */
export function TimeBar() {
  useEffect(() => void askFlights(), []);
  useEffect(() => {
    // A flight is kept when it is over.
    if (flying.value) return undefined;
    const timer = setTimeout(() => void askFlights(), LANDED_FOR);
    return () => clearTimeout(timer);
  }, [flying.value]);
  const flight = replay.value;
  return (
    <section class="card time-bar" aria-label={t("Time")} data-recorded={flight !== null}>
      {flight ? <Recording flight={flight} /> : <Present />}
      <p class="trouble" role="alert">
        {liveAgain.value
          ? t("Live again: {why}", { why: liveAgain.value })
          : translated(trouble.value)}
      </p>
    </section>
  );
}

/** Time moves on by so many steps from end to end of the bar: about a pixel each. */
const PIXELS = 1000;
/** The right end of the bar [Unix time, s]. */
const rightEnd = computed(() => {
  if (at.value !== null) return endOf.value;
  const step = span.value / PIXELS;
  return step * Math.ceil(hubNow.value / step);
});

/** The room's past on a slider, and the flights in it; the right end is now. */
function Present() {
  const past = at.value !== null;
  const right = rightEnd.value;
  const value = past ? Math.max(-span.value, at.value! - right) : 0;
  const words = past ? `${clock(at.value!)}, ${ago(hubNow.value - at.value!)}` : t("now");
  const share = (time: number): number => 100 * (1 - (right - time) / span.value);
  const within = (time: number): boolean => time > right - span.value && time <= right;
  return (
    <>
      <button
        type="button"
        class="now"
        aria-disabled={!past}
        aria-pressed={!past}
        onClick={() => go(null)}
      >
        {past ? t("Back to live") : t("● Live")}
      </button>
      <div class="track slider">
        <div class="blocks">
          {(flights.value ?? [])
            .filter((one) => within(one.started_at + one.duration))
            .map((one) => (
              <Block key={one.id} flight={one} left={share(one.started_at)} span={span.value} />
            ))}
        </div>
        <div class="marks" aria-hidden="true">
          {events.value
            .filter((event) => within(event.at))
            .map((event) => (
              <i
                key={`${event.at} ${event.kind} ${event.thing}`}
                style={{ left: `${share(event.at)}%` }}
              />
            ))}
        </div>
        <input
          type="range"
          aria-label={t("Time shown")}
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
      <HowFar />
    </>
  );
}

function HowFar() {
  return (
    <select
      aria-label={t("How far back")}
      value={span.value}
      onChange={(event) => {
        span.value = Number(event.currentTarget.value);
        void askEvents().catch(() => undefined);
      }}
    >
      {SPANS.map(([seconds, name]) => (
        <option key={seconds} value={seconds}>
          {t(name)}
        </option>
      ))}
    </select>
  );
}

const LEAST = 0.8;

const WORST: Record<FlightView["worst"], Key | ""> = {
  info: "",
  warning: ", with warnings",
  fault: ", with faults",
};

function Block({ flight, left, span }: { flight: FlightView; left: number; span: number }) {
  const width = Math.max(LEAST, (100 * flight.duration) / span);
  const values = {
    time: clock(flight.started_at),
    goal: flight.goal,
    span: minutes(flight.duration),
  };
  const name = flight.goal
    ? t("Flight at {time} to {goal}, {span} long", values)
    : t("Flight at {time}, {span} long", values);
  const worst = WORST[flight.worst];
  return (
    <button
      type="button"
      class="block"
      data-worst={flight.worst}
      style={{
        left: `min(${Math.max(0, left)}%, calc(100% - 24px))`,
        width: `${Math.min(width, width + left)}%`,
      }}
      aria-label={t("{name}: look at it again", { name: name + (worst && t(worst)) })}
      title={name}
      aria-disabled={replayObjection.value !== ""}
      onClick={() => void openFlight(flight.id)}
    />
  );
}
