import { signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { minutes, sentence } from "../format";
import { clock } from "../live/words";
import { board } from "./board";
import { openClip } from "./clip-store";
import { Steps } from "./open-tasks";
import { clips, history } from "./tasks-client";
import { TakeAway } from "./take-away";
import { details, MARKS, outcome, rehearsed, why } from "./words";
import type { ClipInfo, TaskStatus } from "../wire/task-messages";

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
    trouble.value = more.value ? "" : "that is all";
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
      {tasks.length === 0 && <p class="quiet">No task has ended yet.</p>}
      <ul class="ended">
        {tasks.map((task) => (
          <li key={task.id} data-outcome={outcome(task)}>
            <details onToggle={(event) => show(task.id, event.currentTarget.open)}>
              <summary>
                <span class="mark" aria-hidden="true">
                  {MARKS[outcome(task)]}
                </span>
                <span class="what">
                  <strong>{task.title}</strong>
                  <span class="quiet">
                    {" "}
                    {clock(task.asked_at)} · {task.state}
                    {task.clips.length > 0 && " · ▣"}
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
            Older tasks
          </button>
        )}
        <span role="status">{trouble.value && sentence(trouble.value)}</span>
      </div>
    </>
  );
}

function flight(task: TaskStatus): string {
  if (task.took_off_at !== null)
    return `${clock(task.took_off_at)}, in the air for ${minutes(task.flown ?? 0)}.`;
  if (task.started_at === null) return "It did not begin.";
  return task.flown === null ? "" : "It did not fly.";
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
      <dt>Trigger</dt>
      <dd>{sentence(why(task) + (given ? `: ${given}` : ""))}</dd>
      <dt>Decision</dt>
      <dd>
        {task.rehearsal ? rehearsed(task.rehearsal) : "It was not rehearsed."}
        {task.code !== "ok" && <span class="quiet"> ({task.code})</span>}
      </dd>
      <dt>Flight</dt>
      <dd>
        {flight(task)}
        {task.started_at !== null && <Steps steps={task.steps} />}
        {task.recording && (
          <p>
            Recorded: <code>housefly replay {task.recording}</code>
          </p>
        )}
      </dd>
      <dt>Clip</dt>
      <dd>
        {kept.length === 0 && (task.clips.length === 0 ? "None." : "None is kept any more.")}
        <span class="chips">
          {kept.map((clip) => (
            <button type="button" key={clip.id} onClick={() => openClip(clip.id)}>
              {clip.kind === "clip" ? `▣ Show clip, ${minutes(clip.duration)}` : "▢ Show snapshot"}
            </button>
          ))}
          <TakeAway clips={kept} label="Save all" />
        </span>
      </dd>
      <dt>Outcome</dt>
      <dd>
        {sentence(task.words || task.state)}
        {task.report.map((line) => (
          <p key={line}>{sentence(line)}</p>
        ))}
      </dd>
    </dl>
  );
}
