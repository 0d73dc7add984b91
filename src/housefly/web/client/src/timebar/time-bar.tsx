import { useEffect } from "preact/hooks";
import { minutes } from "../format";
import { askEvents } from "../live/room-client";
import { at, events, hubNow, span } from "../live/store";
import { ago, clock } from "../live/words";
import { flying } from "../store";
import {
  askFlights,
  closeFlight,
  flights,
  liveAgain,
  moment,
  openFlight,
  pace,
  pause,
  play,
  playing,
  replay,
  replayObjection,
  show,
  trouble,
} from "../replay/replay";
import type { FlightReplay, FlightView } from "../wire/room-messages";
import { endOf, go } from "./past";

const SPANS: [number, string][] = [
  [600, "10 min"],
  [3600, "1 h"],
  [21600, "6 h"],
  [86400, "1 day"],
  [604800, "1 week"],
];
const STEPS = 600;
const LANDED_FOR = 3000;
const PACES = [1, 2, 4, 8];

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
    <section class="card time-bar" aria-label="Time" data-recorded={flight !== null}>
      {flight ? <Recording flight={flight} /> : <Present />}
      <p class="trouble" role="alert">
        {liveAgain.value ? `Live again: ${liveAgain.value}` : trouble.value}
      </p>
    </section>
  );
}

/** The room's past on a slider, and the flights in it; the right end is now. */
function Present() {
  const past = at.value !== null;
  const right = past ? endOf.value : hubNow.value;
  const value = past ? Math.max(-span.value, at.value! - right) : 0;
  const words = past ? `${clock(at.value!)}, ${ago(hubNow.value - at.value!)}` : "now";
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
        {past ? "Back to live" : "● Live"}
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
      <select
        aria-label="How far back"
        value={span.value}
        onChange={(event) => {
          span.value = Number(event.currentTarget.value);
          void askEvents().catch(() => undefined);
        }}
      >
        {SPANS.map(([seconds, name]) => (
          <option key={seconds} value={seconds}>
            {name}
          </option>
        ))}
      </select>
    </>
  );
}

const LEAST = 0.8;
/** Bands of a larger share of the flight have their name on them. */
const NAMED = 0.07;

function Block({ flight, left, span }: { flight: FlightView; left: number; span: number }) {
  const width = Math.max(LEAST, (100 * flight.duration) / span);
  const goal = flight.goal ? ` to ${flight.goal}` : "";
  const name = `Flight at ${clock(flight.started_at)}${goal}, ${minutes(flight.duration)} long`;
  const worst = { info: "", warning: ", with warnings", fault: ", with faults" }[flight.worst];
  return (
    <button
      type="button"
      class="block"
      data-worst={flight.worst}
      style={{
        left: `min(${Math.max(0, left)}%, calc(100% - 24px))`,
        width: `${Math.min(width, width + left)}%`,
      }}
      aria-label={`${name}${worst}: look at it again`}
      title={name}
      aria-disabled={replayObjection.value !== ""}
      onClick={() => void openFlight(flight.id)}
    />
  );
}

/** One flight on the whole bar: what the drone did as bands, the lines of its log as marks. */
function Recording({ flight }: { flight: FlightReplay }) {
  const { duration } = flight.flight;
  const share = (time: number): string => `${(100 * time) / Math.max(duration, 0.1)}%`;
  return (
    <>
      <button type="button" class="now" onClick={() => closeFlight()}>
        Back to live
      </button>
      <button
        type="button"
        class="play"
        aria-label={playing.value ? "Pause" : "Play"}
        onClick={() => (playing.value ? pause() : play())}
      >
        {playing.value ? "❚❚" : "▶"}
      </button>
      <div class="track slider">
        <div class="bands" aria-hidden="true">
          {flight.stages.map((stage, k) => (
            <span
              key={k}
              data-phase={stage.phase.split(" ")[0]}
              data-safety={stage.safety}
              style={{
                left: share(stage.t),
                width: share((flight.stages[k + 1]?.t ?? duration) - stage.t),
              }}
            >
              {((flight.stages[k + 1]?.t ?? duration) - stage.t) / duration > NAMED && stage.phase}
            </span>
          ))}
        </div>
        <div class="marks" aria-hidden="true">
          {flight.notes.map((note, k) => (
            <i key={k} data-severity={note.severity} style={{ left: share(note.t) }} />
          ))}
        </div>
        <Scrub duration={duration} />
      </div>
      <Elapsed duration={duration} />
      <select
        aria-label="How fast"
        value={pace.value}
        onChange={(event) => (pace.value = Number(event.currentTarget.value))}
      >
        {PACES.map((one) => (
          <option key={one} value={one}>
            {one} ×
          </option>
        ))}
      </select>
    </>
  );
}

function Scrub({ duration }: { duration: number }) {
  return (
    <input
      type="range"
      aria-label="Moment of the recording"
      aria-valuetext={`${minutes(moment.value)} of ${minutes(duration)}`}
      min={0}
      max={duration}
      step={0.05}
      value={moment.value}
      onInput={(event) => show(Number(event.currentTarget.value))}
    />
  );
}

function Elapsed({ duration }: { duration: number }) {
  return (
    <span class="elapsed">
      {minutes(moment.value)} / {minutes(duration)}
    </span>
  );
}

