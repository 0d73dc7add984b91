import { computed, signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { capital, sentence } from "../format";
import { feed, keyOf } from "../live/room-client";
import { at, events, moment } from "../live/store";
import { ago } from "../live/words";
import { Told } from "../messages/told";
import { open } from "../store";
import { board } from "../tasks/board";
import { go } from "../timebar/past";
import type { FeedEntry } from "../wire/room-messages";
import { t, translated } from "../messages/language";
import { PLAYS, Still } from "./still";

const TOPICS = {
  all: "all^lines",
  people: "People",
  things: "Things",
  drone: "Drone",
  tasks: "Tasks",
} as const;
type Topic = keyof typeof TOPICS;
const topic = signal<Topic>("all");

const PAGE = 50;
/** What is heard in one moment is asked for once [ms]. */
const SOON = 150;
/** A moment is shown with what it brought about [s]. */
const AFTER = 0.5;
/** Ages are told this exactly [s]. */
const EXACT = 10;
const now = computed(() => EXACT * Math.floor(moment.value / EXACT));

/** What happened in room and house, by person, thing, flight and task; `limit` is for a few. */
export function Feed({ limit = 0 }: { limit?: number }) {
  const [entries, show] = useState<FeedEntry[] | null>(null);
  const [trouble, tell] = useState("");
  const of = limit ? "all" : topic.value;
  const newest = events.value.at(-1);
  useEffect(() => {
    let isWanted = true;
    const answered = (found: FeedEntry[] | null, words: string): void => {
      if (!isWanted) return;
      if (found) show(found);
      tell(words);
    };
    const asking = setTimeout(() => {
      feed(of, limit || PAGE, at.value)
        .then((answer) => answered(answer.entries, ""))
        .catch((error: Error) => answered(null, error.message));
    }, SOON);
    return () => {
      isWanted = false;
      clearTimeout(asking);
    };
  }, [of, limit, at.value, newest && keyOf(newest), board.value?.ended[0]?.id]);
  return (
    <section class="feed" aria-label={t("Lately")}>
      {limit > 0 ? (
        <div class="row">
          <h2>{t("Lately")}</h2>
          <button type="button" onClick={() => open("tasks")}>
            {t("more")}
          </button>
        </div>
      ) : (
        <div class="chips" role="group" aria-label={t("Which lines")}>
          {(Object.keys(TOPICS) as Topic[]).map((one) => (
            <button
              type="button"
              key={one}
              aria-pressed={of === one}
              onClick={() => (topic.value = one)}
            >
              {capital(t(TOPICS[one]))}
            </button>
          ))}
        </div>
      )}
      {trouble && <p role="status">△ {sentence(translated(trouble))}</p>}
      {entries?.length === 0 && <p class="quiet empty">{sentence(t("nothing yet"))}</p>}
      <ol>
        {entries?.map((one) => (
          <Entry key={`${one.of} ${one.thing} ${one.began_at}`} entry={one} />
        ))}
      </ol>
    </section>
  );
}

function Entry({ entry }: { entry: FeedEntry }) {
  return (
    <li data-of={entry.of} data-alarms={entry.alarms}>
      <button
        type="button"
        title={t("Show the room as it was then")}
        onClick={() => {
          open("live");
          go(entry.at + AFTER);
        }}
      >
        <strong>
          <Told words={capital(translated(entry.name))} />
        </strong>
        <time>{ago(now.value - entry.at)}</time>
        <span>
          {entry.alarms && "△ "}
          <Told words={translated(entry.words)} />
        </span>
      </button>
      {entry.pictures.length > 0 && (
        <span class="stills">
          {entry.pictures.map((id) => (
            <a key={id} href={`#clip/${id}`} aria-label={t("Clip")} {...PLAYS}>
              <Still id={id} />
            </a>
          ))}
        </span>
      )}
    </li>
  );
}
