// What this console knows of the tasks, as signals; wire/socket.ts writes the first.
import { computed, signal } from "@preact/signals";
import { contact } from "../store";
import { now } from "../wire/clock";
import type { TasksMessage } from "../wire/messages";
import type { PersonQuestion, TaskStatus } from "../wire/task-messages";

export const told = signal<TasksMessage | null>(null);

export const board = computed(() => told.value?.board ?? null);
/** Whether what the board says is the present. */
export const running = computed(() => contact.value === "open" && (told.value?.running ?? false));
/** Whether it is known that nobody keeps the board. */
export const silent = computed(
  () => contact.value === "open" && told.value !== null && !told.value.running,
);

/** The server's Unix time [s], ticking five times a second. */
export const unixNow = computed(() => {
  const heard = told.value;
  return heard?.board ? heard.board.at + (now.value - heard.heard_at) : Date.now() / 1000;
});

export interface Asked {
  task: TaskStatus;
  question: PersonQuestion;
}

/** What waits for a person, in the order in which the tasks fly. */
export const asked = computed<Asked[]>(() => {
  if (!running.value) return [];
  return (board.value?.tasks ?? []).flatMap((task) =>
    task.question ? [{ task, question: task.question }] : [],
  );
});

const LATELY = 30;
const ENDED_BADLY = ["refused", "failed", "expired"];
const SAID_BY_A_PERSON = ["declined", "cancelled"];

/** Tasks that have just ended otherwise than somebody wanted. */
export const endedBadly = computed<TaskStatus[]>(() => {
  if (!running.value) return [];
  return (board.value?.ended ?? []).filter(
    (task) =>
      ENDED_BADLY.includes(task.state) &&
      !SAID_BY_A_PERSON.includes(task.code) &&
      unixNow.value - (task.ended_at ?? 0) < LATELY,
  );
});

export const records = computed(() => running.value && (board.value?.records ?? false));
