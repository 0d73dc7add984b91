import { minutes } from "../format";
import type { Key } from "../messages/en";
import { closeFlight, moment, pace, pause, play, playing, show } from "../replay/replay";
import type { FlightReplay } from "../wire/room-messages";
import { t } from "../messages/language";

const PACES = [1, 2, 4, 8];
/** Bands of a larger share of the flight have their name on them. */
const NAMED = 0.07;

/** One flight on the whole bar: what the drone did as bands, the lines of its log as marks. */
export function Recording({ flight }: { flight: FlightReplay }) {
  const { duration } = flight.flight;
  const share = (time: number): string => `${(100 * time) / Math.max(duration, 0.1)}%`;
  return (
    <>
      <button type="button" class="now" onClick={() => closeFlight()}>
        {t("Back to live")}
      </button>
      <button
        type="button"
        class="play"
        aria-label={playing.value ? t("Pause") : t("Play")}
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
              {((flight.stages[k + 1]?.t ?? duration) - stage.t) / duration > NAMED &&
                t(`${stage.phase}^phase` as Key)}
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
        aria-label={t("How fast")}
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
      aria-label={t("Moment of the recording")}
      aria-valuetext={t("{time} of {span}", {
        time: minutes(moment.value),
        span: minutes(duration),
      })}
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
