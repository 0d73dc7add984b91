import { useEffect } from "preact/hooks";
import { signal } from "@preact/signals";
import { minutes, sentence } from "../format";
import { clock } from "../live/words";
import { board, unixNow } from "./board";
import { findClips, findOlder, found, more, openClip, trouble } from "./clip-store";
import { TakeAway } from "./take-away";
import type { ClipInfo } from "../wire/task-messages";

const SPANS: [string, number][] = [
  ["any time", 0],
  ["today", 86400],
  ["this week", 7 * 86400],
  ["this month", 30 * 86400],
];
const FILTERS = ["person", "place", "thing"] as const;

const wanted = signal<Record<string, string>>({});
const span = signal(0);

function look(): void {
  const since = span.value ? { since: Math.max(0, unixNow.value - span.value).toFixed(0) } : {};
  void findClips({ ...wanted.value, ...since });
}

const count = (): string => `${found.value.length}${more.value ? " or more" : ""}`;

/** The clips and snapshots, by who, where, what and when. */
export function Clips() {
  // Whatever ended may have left a clip.
  useEffect(look, [board.value?.ended[0]?.id]);
  return (
    <>
      <form
        class="filters"
        aria-label="Which clips"
        onSubmit={(event) => {
          event.preventDefault();
          look();
        }}
      >
        {FILTERS.map((name) => (
          <label class="field" key={name}>
            {name}
            <input
              type="search"
              maxLength={200}
              placeholder="any"
              value={wanted.value[name] ?? ""}
              onInput={(event) => {
                // Kept while it is typed: news of the house draw this form anew at any time.
                wanted.value = { ...wanted.value, [name]: event.currentTarget.value };
              }}
              onChange={look}
            />
          </label>
        ))}
        <label class="field">
          time
          <select
            onChange={(event) => {
              span.value = Number(event.currentTarget.value);
              look();
            }}
          >
            {SPANS.map(([words, seconds]) => (
              <option key={words} value={seconds} selected={span.value === seconds}>
                {words}
              </option>
            ))}
          </select>
        </label>
      </form>
      <p role="status" class={trouble.value ? "" : "spoken"}>
        {trouble.value ? `△ ${sentence(trouble.value)}` : `${count()} clips.`}
      </p>
      {found.value.length === 0 && !trouble.value && <p class="quiet">There is no such clip.</p>}
      <ul class="clips">
        {found.value.map((clip) => (
          <li key={clip.id}>
            <button type="button" onClick={() => openClip(clip.id)}>
              <strong>
                {clip.kind === "clip" ? "▣" : "▢"} {subjectOf(clip)}
              </strong>
              <span class="quiet">
                {clock(clip.began_at)}
                {clip.kind === "clip" ? `, ${minutes(clip.duration)}` : ", snapshot"}
                {clip.cut_off && ", cut off"}
              </span>
            </button>
          </li>
        ))}
      </ul>
      <div class="row">
        {more.value && (
          <button type="button" onClick={() => void findOlder()}>
            Older clips
          </button>
        )}
        <TakeAway clips={found.value} label="Save all of these" />
      </div>
    </>
  );
}

/** What a clip shows, in a few words. */
export function subjectOf(clip: ClipInfo): string {
  const shown = [...clip.people, clip.thing, clip.place].filter((name) => name !== "");
  return shown.length ? shown.join(", ") : clip.service || clip.kind;
}
