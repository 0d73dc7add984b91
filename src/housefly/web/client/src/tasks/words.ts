// Tasks as people say them.
import { capital, sentence } from "../format";
import type { Key } from "../messages/en";
import { nameOf } from "../live/store";
import type { RehearsalReport, Said, TaskStage, TaskStatus } from "../wire/task-messages";
import { t, translated } from "../messages/language";

/** Where a task was asked for; of the others their name says it. */
const SURFACES: Partial<Record<TaskStatus["surface"], Key>> = {
  "mqtt": "over MQTT",
  "webhook": "by a webhook",
  "assistant": "by an assistant",
};

/** Who wanted a task, where, and what caused it. */
export function why(task: TaskStatus): string {
  const who = task.asked_by ? t("asked for by {who}", { who: task.asked_by }) : t("asked for");
  const place = SURFACES[task.surface];
  const where = place ? ` ${t(place)}` : "";
  const cause = task.cause ? t(", because of {cause}", { cause: causeOf(task.cause) }) : "";
  return who + where + cause;
}

const SPOKEN: Record<string, Key> = {
  "bell pressed": "The bell rings",
  "webhook bell": "The bell rings",
  "person fallen": "Somebody may have fallen",
};

/** Whether people have words for what caused a task: "The bell rings". */
export const isSpoken = (task: TaskStatus): boolean => partsOf(task.cause)[0]! in SPOKEN;

/** What has happened and what would be done about it, as a question. */
export function proposal(task: TaskStatus): string {
  const known = SPOKEN[partsOf(task.cause)[0]!];
  const spoken = known ? t(known) : causeOf(task.cause);
  return `${sentence(spoken)} ${translated(task.title).replace(/\?$/, "")}?`;
}

/** The kind and the thing in an id of an event or rule: `rule:bell bell pressed/doorbell/…`. */
const partsOf = (cause: string): string[] => cause.replace(/^rule:\S+\s/, "").split("/");

/** What such an id says: "bell pressed". */
export function happened(cause: string): string {
  const [kind = "", thing = ""] = partsOf(cause);
  // A time is only there to tell one call from another.
  return thing && !kind.includes(thing) && isNaN(Number(thing)) ? `${kind} (${thing})` : kind;
}

/** The same in the language of the page. */
export const causeOf = (cause: string): string => translated(happened(cause));

export type Outcome = "waits" | "runs" | "well" | "badly" | "ended";

const OUTCOMES: Record<TaskStage, Outcome> = {
  "waiting for a yes": "waits",
  "queued": "waits",
  "running": "runs",
  "paused": "waits",
  "suspended": "waits",
  "done": "well",
  "failed": "badly",
  "cancelled": "ended",
  "refused": "ended",
  "expired": "ended",
};
export const outcome = (task: TaskStatus): Outcome => OUTCOMES[task.state];

export const MARKS: Record<Outcome, string> = {
  waits: "○",
  runs: "▶",
  well: "✓",
  badly: "✕",
  ended: "–",
};

/** The place, thing or person that a task is about, or "": documents name that first. */
export function details(task: TaskStatus): string {
  const about = Object.values(task.parameters).find((one) => one && typeof one === "string");
  return capital(nameOf(`${about ?? ""}`));
}

const CLOSED = "Who walks there may close the way for a moment: ask again when it is free.";

/** Why something does not fly; a way that is closed now need not stay so. */
export function withAdvice(words: Said, code: string): string {
  const told = sentence(translated(words));
  return code === "no_way" ? `${told} ${t(CLOSED)}` : told;
}

/** What a rehearsal found. */
export function rehearsed(report: RehearsalReport): string {
  return report.may_fly
    ? sentence(translated(report.words))
    : withAdvice(report.words, report.code);
}
