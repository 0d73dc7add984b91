import { useEffect } from "preact/hooks";
import { signal } from "@preact/signals";
import { PLAYS, Still } from "../feed/still";
import { minutes, sentence } from "../format";
import { clock } from "../live/words";
import type { Key } from "../messages/en";
import { board, unixNow } from "./board";
import { findClips, findOlder, found, more, openClip, trouble } from "./clip-store";
import { TakeAway } from "./take-away";
import type { ClipInfo } from "../wire/task-messages";
import { t, translated } from "../messages/language";

const SPANS: [Key, number][] = [
  ["any time", 0],
  ["today", 86400],
  ["this week", 7 * 86400],
  ["this month", 30 * 86400],
];
const FILTERS = ["person", "place", "thing"] as const;

/** Whoever has not typed for so long is answered [ms]. */
const PAUSE = 300;
let typing = 0;

const wanted = signal<Record<string, string>>({});
const span = signal(0);

function look(): void {
  const since = span.value ? { since: Math.max(0, unixNow.value - span.value).toFixed(0) } : {};
  void findClips({ ...wanted.value, ...since });
}

const count = (): string => {
  const n = found.value.length;
  return more.value ? t("{n} or more clips.", { n }) : t("{n} clip.|{n} clips.", { n });
};

/** The clips and snapshots, by who, where, what and when. */
export function Clips() {
  // Whatever ended may have left a clip.
  useEffect(look, [board.value?.ended[0]?.id]);
  return (
    <>
      <form
        class="filters"
        aria-label={t("Which clips")}
        onSubmit={(event) => {
          event.preventDefault();
          look();
        }}
      >
        {FILTERS.map((name) => (
          <label class="field" key={name}>
            {t(name)}
            <input
              type="search"
              maxLength={200}
              placeholder={t("any")}
              value={wanted.value[name] ?? ""}
              onInput={(event) => {
                // Kept while it is typed: news of the house draw this form anew at any time.
                wanted.value = { ...wanted.value, [name]: event.currentTarget.value };
                clearTimeout(typing);
                typing = window.setTimeout(look, PAUSE);
              }}
            />
          </label>
        ))}
        <label class="field">
          {t("time")}
          <select
            onChange={(event) => {
              span.value = Number(event.currentTarget.value);
              look();
            }}
          >
            {SPANS.map(([words, seconds]) => (
              <option key={words} value={seconds} selected={span.value === seconds}>
                {t(words)}
              </option>
            ))}
          </select>
        </label>
      </form>
      <p role="status" class={trouble.value ? "" : "spoken"}>
        {trouble.value ? `△ ${sentence(translated(trouble.value))}` : count()}
      </p>
      {found.value.length === 0 && !trouble.value && (
        <p class="quiet empty film">{t("There is no such clip.")}</p>
      )}
      <ul class="clips">
        {found.value.map((clip) => (
          <li key={clip.id}>
            <button type="button" onClick={() => openClip(clip.id)} {...PLAYS}>
              <Still id={clip.id} isPhoto={clip.kind !== "clip"} />
              <strong>{subjectOf(clip)}</strong>
              <span class="quiet">
                {clock(clip.began_at)}
                {clip.kind === "clip" ? `, ${minutes(clip.duration)}` : `, ${t("snapshot")}`}
                {clip.cut_off && `, ${t("cut off")}`}
              </span>
            </button>
          </li>
        ))}
      </ul>
      <div class="row">
        {more.value && (
          <button type="button" onClick={() => void findOlder()}>
            {t("Older clips")}
          </button>
        )}
        <TakeAway clips={found.value} label={t("Save all of these")} />
      </div>
    </>
  );
}

/** What a clip shows, in a few words. */
export function subjectOf(clip: ClipInfo): string {
  const shown = [...clip.people, clip.thing, clip.place].filter((name) => name !== "");
  return shown.length ? shown.join(", ") : clip.service || clip.kind;
}
