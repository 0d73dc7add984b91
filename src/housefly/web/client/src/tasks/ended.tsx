import { signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { PLAYS, Still } from "../feed/still";
import { minutes, sentence } from "../format";
import { clock } from "../live/words";
import { Told } from "../messages/told";
import { board } from "./board";
import { openClip } from "./clip-store";
import { Steps } from "./open-tasks";
import { clips, history } from "./tasks-client";
import { TakeAway } from "./take-away";
import { details, MARKS, outcome, rehearsed, why } from "./words";
import type { ClipInfo, TaskStatus } from "../wire/task-messages";
import { t, translated } from "../messages/language";

const PAGE = 50;

const older = signal<TaskStatus[]>([]);
/** Whether there may be older ones. */
const more = signal(true);
const trouble = signal("");

const unfolded = signal<ReadonlySet<number>>(new Set());

function show(task: number, open: boolean): void {
  const now = new Set(unfolded.value);
  if (open) now.add(task);
  else now.delete(task);
  unfolded.value = now;
}

async function askOlder(): Promise<void> {
  try {
    const { tasks } = await history(older.value.at(-1)?.id ?? 0, PAGE);
    older.value = [...older.value, ...tasks];
    more.value = tasks.length === PAGE;
    trouble.value = more.value ? "" : t("that is all");
  } catch (error) {
    trouble.value = (error as Error).message;
  }
}

/** Ended tasks: what caused each, what was decided, how it flew, what is kept, what came of it. */
export function Ended() {
  const newest = board.value?.ended ?? [];
  const known = new Set([...newest, ...(board.value?.tasks ?? [])].map((one) => one.id));
  const tasks = [...newest, ...older.value.filter((one) => !known.has(one.id))];
  return (
    <>
      {tasks.length === 0 && <p class="quiet empty">{t("No task has ended yet.")}</p>}
      <ul class="ended">
        {tasks.map((task) => (
          <li key={task.id} data-outcome={outcome(task)}>
            <details onToggle={(event) => show(task.id, event.currentTarget.open)}>
              <summary {...PLAYS}>
                <span class="mark" aria-hidden="true">
                  {MARKS[outcome(task)]}
                </span>
                {task.clips.length > 0 && <Still id={task.clips[0]!} />}
                <span class="what">
                  <strong>
                    <Told words={translated(task.title)} />
                  </strong>
                  <span class="quiet">
                    {" "}
                    {clock(task.asked_at)} · {t(task.state)}
                  </span>
                </span>
              </summary>
              {unfolded.value.has(task.id) && <Chain task={task} />}
            </details>
          </li>
        ))}
      </ul>
      <div class="row">
        {more.value && tasks.length > 0 && (
          <button type="button" onClick={() => void askOlder()}>
            {t("Older tasks")}
          </button>
        )}
        <span role="status">{trouble.value && sentence(translated(trouble.value))}</span>
      </div>
    </>
  );
}

function flight(task: TaskStatus): string {
  if (task.took_off_at !== null)
    return t("{time}, in the air for {span}.", {
      time: clock(task.took_off_at),
      span: minutes(task.flown ?? 0),
    });
  if (task.started_at === null) return t("It did not begin.");
  return task.flown === null ? "" : t("It did not fly.");
}

function Chain({ task }: { task: TaskStatus }) {
  const given = details(task);
  const [kept, keep] = useState<ClipInfo[]>([]);
  useEffect(() => {
    clips({ task: String(task.id) })
      .then((answer) => keep(answer.clips))
      .catch(() => undefined);
  }, [task.clips.length]);
  return (
    <dl class="chain">
      <dt>{t("Trigger")}</dt>
      <dd>{sentence(why(task) + (given ? `: ${given}` : ""))}</dd>
      <dt>{t("Decision")}</dt>
      <dd>
        {task.rehearsal ? rehearsed(task.rehearsal) : t("It was not rehearsed.")}
      </dd>
      <dt>{t("Flight")}</dt>
      <dd>
        {flight(task)}
        {task.started_at !== null && <Steps steps={task.steps} />}
        {task.recording && (
          <p>
            {t("Recorded:")} <code>housefly replay {task.recording}</code>
          </p>
        )}
      </dd>
      <dt>{t("Clip")}</dt>
      <dd>
        {kept.length === 0 && 
          (task.clips.length === 0 ? t("None.") : t("None is kept any more."))}
        <span class="chips">
          {kept.map((clip) => (
            <button type="button" key={clip.id} onClick={() => openClip(clip.id)}>
              {clip.kind === "clip"
                ? `▣ ${t("Show clip, {time}", { time: minutes(clip.duration) })}`
                : `▢ ${t("Show snapshot")}`}
            </button>
          ))}
          <TakeAway clips={kept} label={t("Save all")} />
        </span>
      </dd>
      <dt>{t("Outcome")}</dt>
      <dd>
        <Told words={sentence(translated(task.words || task.state))} />
        {task.report.map((line) => (
          <p key={line}>
            <Told words={sentence(translated(line))} />
          </p>
        ))}
      </dd>
    </dl>
  );
}
