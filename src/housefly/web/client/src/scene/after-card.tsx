import { computed, signal } from "@preact/signals";
import { PLAYS, Still } from "../feed/still";
import { capital, sentence } from "../format";
import { Told } from "../messages/told";
import { flying } from "../store";
import { board, unixNow } from "../tasks/board";
import { again } from "../tasks/questions";
import type { TaskStatus } from "../wire/task-messages";
import { t, translated } from "../messages/language";

/** For how long what came of a flight is shown [s]. */
const SHOWN = 600;

const read = signal(0);

/** The task that flew last and kept pictures, until it was read. */
const last = computed<TaskStatus | null>(() => {
  if (flying.value) return null;
  const one = (board.value?.ended ?? []).find((task) => task.flown !== null);
  const isNew = one && one.id > read.value && unixNow.value - (one.ended_at ?? 0) < SHOWN;
  return isNew && one.clips.length > 0 ? one : null;
});

/** What came of the last flight: its picture, its words, and the way to more. */
export function AfterCard() {
  const task = last.value;
  if (!task) return null;
  const close = (): void => void (read.value = task.id);
  const clip = task.clips.at(-1)!;
  return (
    <article class="after card" aria-label={t("What came of it")}>
      <a class="still" href={`#clip/${clip}`} aria-label={t("See the clip")} {...PLAYS}>
        <Still id={clip} />
      </a>
      <p>
        <strong>
          <Told words={capital(translated(task.title))} />
        </strong>{" "}
        <Told words={sentence(translated(task.words))} />
      </p>
      <div class="row">
        <a class="button" href={`#clip/${clip}`}>
          {t("See the clip")}
        </a>
        <button type="button" onClick={() => void again(task).then(close)}>
          {t("Ask again")}
        </button>
        <button type="button" aria-label={t("Close")} onClick={close}>
          ×
        </button>
      </div>
    </article>
  );
}
