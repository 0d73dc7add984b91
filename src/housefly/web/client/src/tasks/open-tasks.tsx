import { signal } from "@preact/signals";
import { sentence } from "../format";
import { ago } from "../live/words";
import { Told } from "../messages/told";
import { board, running, unixNow } from "./board";
import { change } from "./tasks-client";
import { details, MARKS, outcome, rehearsed, why } from "./words";
import type { TaskStatus, TaskStepState, TaskStepStatus } from "../wire/task-messages";
import { t, translated } from "../messages/language";

const trouble = signal({ task: 0, words: "" });

type Change = "cancel" | "pause" | "continue";

async function order(task: number, what: Change): Promise<void> {
  trouble.value = { task: 0, words: "" };
  try {
    await change(task, what);
  } catch (error) {
    trouble.value = { task, words: (error as Error).message };
  }
}

/** What flies and what waits, in the order in which it flies. */
export function OpenTasks() {
  const tasks = board.value?.tasks ?? [];
  return (
    <section class="card now" aria-label={t("Now")}>
      <div class="row">
        <h2>{t("Now")}</h2>
        <span class="quiet">
          <Told words={running.value ? translated(board.value?.drone ?? "") : ""} />
        </span>
      </div>
      {tasks.length === 0 && <p class="quiet">{t("Nothing is asked for.")}</p>}
      <ol data-old={!running.value}>
        {tasks.map((task) => (
          <Task key={task.id} task={task} />
        ))}
      </ol>
    </section>
  );
}

function Task({ task }: { task: TaskStatus }) {
  const given = details(task);
  const kind = outcome(task);
  // The card of its question says the rest.
  const waits = task.state === "waiting for a yes";
  return (
    <li data-outcome={kind} aria-label={t("Task {n}", { n: task.id })}>
      <div class="row">
        <strong>
          <span class="mark" aria-hidden="true">
            {MARKS[kind]}
          </span>{" "}
          <Told words={translated(task.title)} />
        </strong>
        {given && <span>{given}</span>}
        <span class="stage">{t(task.state)}</span>
      </div>
      <p class="quiet">
        {why(task)}, {ago(unixNow.value - task.asked_at)}
      </p>
      {task.words && !waits && (
        <p>
          <Told words={sentence(translated(task.words))} />
        </p>
      )}
      {task.rehearsal && !waits && (
        <p class="quiet">
          <Told words={rehearsed(task.rehearsal)} />
        </p>
      )}
      {!waits && <Steps steps={task.steps} />}
      <div class="row orders">
        {task.state === "running" && <Order task={task.id} what="pause" words={t("Pause")} />}
        {task.state === "paused" && <Order task={task.id} what="continue" words={t("Go on")} />}
        <Order task={task.id} what="cancel" words={t("Cancel")} />
      </div>
      {trouble.value.task === task.id && (
        <p role="alert">△ {sentence(translated(trouble.value.words))}</p>
      )}
    </li>
  );
}

function Order({ task, what, words }: { task: number; what: Change; words: string }) {
  return (
    <button
      type="button"
      aria-label={t("{words}: task {n}", { words, n: task })}
      aria-disabled={!running.value}
      onClick={() => void order(task, what)}
    >
      {words}
    </button>
  );
}

const STEP_MARKS: Record<TaskStepState, string> = {
  waiting: "○",
  running: "▶",
  done: "✓",
  failed: "✕",
  skipped: "–",
};

/** How far a task is. */
export function Steps({ steps }: { steps: TaskStepStatus[] }) {
  if (steps.length === 0) return null;
  return (
    <ol class="steps" aria-label={t("Steps")}>
      {steps.map((step, k) => (
        <li
          key={`${k} ${step.name}`}
          data-state={step.state}
          aria-current={step.state === "running" ? "step" : undefined}
        >
          <span class="mark" aria-hidden="true">
            {STEP_MARKS[step.state]}
          </span>
          <span class="spoken">{t(step.state)}: </span>
          <Told words={translated(step.words || step.name)} />
        </li>
      ))}
    </ol>
  );
}
