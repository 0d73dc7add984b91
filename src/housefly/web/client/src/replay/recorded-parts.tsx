import { computed, signal, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { capital, minutes } from "../format";
import { clock } from "../live/words";
import { clipAddress, clips } from "../tasks/tasks-client";
import type { ClipInfo } from "../wire/task-messages";
import { recordedLine, recordedSecond, recordedWords } from "./recorded-state";
import { closeFlight, moment, pace, playing, replay, replaying } from "./replay";
import { t, translated } from "../messages/language";
import { Told } from "../messages/told";

/** Across the map, so that nobody takes a recording for the present. */
export function RecordedBanner() {
  if (!replaying.value) return null;
  return (
    <p class="past-banner recorded-banner">
      <strong>{t("Recorded, not live")}</strong>
      <span class="when">{clock(recordedSecond.value)}</span>
      <span class="doing">{recordedWords.value}</span>
      <button type="button" onClick={() => closeFlight()}>
        {t("Back to live")}
      </button>
    </p>
  );
}

const MARK = { info: "·", warning: "△", fault: "✕" };

/** The lines of the log up to the moment that is shown, newest first; the rest is to come. */
export function RecordedLog() {
  const flight = replay.value;
  if (!flight) return null;
  const last = recordedLine.value;
  return (
    <section class="card log recorded-log" aria-label={t("Log of the recording")}>
      <h2>{t("Log, recorded")}</h2>
      <ol tabIndex={0} data-scrolls>
        {flight.notes
          .slice(0, last + 1)
          .reverse()
          .map((one, k) => (
            <li key={last - k} data-severity={one.severity}>
              <time>{minutes(one.t)}</time>
              <span class="mark" aria-label={t(one.severity)}>
                {MARK[one.severity]}
              </span>
              <Told words={capital(translated(one.text))} />
            </li>
          ))}
      </ol>
    </section>
  );
}

const found = signal<ClipInfo[]>([]);
const OFF_MAX = 0.4;

const time = computed(() => (replay.value?.flight.started_at ?? 0) + moment.value);
const clip = computed(() =>
  found.value.find(
    (one) => one.began_at <= time.value && time.value <= one.began_at + one.duration,
  ),
);

async function findClips(from: number, until: number): Promise<void> {
  try {
    const wanted = { since: from.toFixed(1), until: until.toFixed(1), limit: "50" };
    found.value = (await clips(wanted)).clips.filter((one) => one.kind === "clip");
  } catch {
    found.value = []; // no tasks keep clips here
  }
}

/** The clip of the moment that is shown, or in words that there is none. */
export function RecordedPicture() {
  const flight = replay.value;
  useEffect(() => {
    found.value = [];
    if (flight) {
      const { started_at, duration } = flight.flight;
      void findClips(started_at - 60, started_at + duration);
    }
  }, [flight]);
  const shown = clip.value;
  return (
    <section class="view video recorded-picture" aria-label={t("Recorded picture")}>
      {shown ? (
        <Film key={shown.id} clip={shown} />
      ) : (
        <p class="veil">{t("No picture of this moment was kept.")}</p>
      )}
      {shown && <strong class="tag">{t("Recorded")}</strong>}
    </section>
  );
}

/** The clip at the moment that is shown. */
function Film({ clip: shown }: { clip: ClipInfo }) {
  const video = useRef<HTMLVideoElement>(null);
  useSignalEffect(() => {
    const film = video.current;
    const wanted = time.value - shown.began_at;
    if (!film) return;
    film.playbackRate = pace.value;
    if (Math.abs(film.currentTime - wanted) > OFF_MAX * pace.value) film.currentTime = wanted;
    if (playing.value && film.paused) void film.play().catch(() => undefined);
    if (!playing.value && !film.paused) film.pause();
  });
  return <video ref={video} src={clipAddress(shown.id)} muted playsInline />;
}
