import { computed, signal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { HoldButton } from "../controls/hold-button";
import { capital, minutes, percent, sentence } from "../format";
import { createHold } from "../hold";
import { bellAsks, bellRings } from "../scene/bell";
import { BellCard } from "../scene/bell-card";
import { Told } from "../messages/told";
import { refuse } from "../said";
import { open } from "../store";
import { asked, endedBadly, unixNow, type Asked } from "./board";
import { reply, request } from "./tasks-client";
import type { TaskStatus } from "../wire/task-messages";
import { isSpoken, proposal, rehearsed, why, withAdvice } from "./words";
import { t, translated } from "../messages/language";

const HOLD = 0.6;
const SETTLED = 700;
const SHOWN = 2;
/** The question whose yes starts a flight; those of a task that flies already do not. */
const CONFIRMATION = "confirm";
const HARMLESS = ["no", "ignore", "not now"];

/** Why an answer was not taken, and to the question of which task. */
const trouble = signal({ task: 0, words: "" });
/** Ends of tasks that were read. */
const read = signal<ReadonlySet<number>>(new Set());
const free = computed(() => "");

const close = (task: TaskStatus): void => void (read.value = new Set([...read.value, task.id]));

/** Ask for the same; the question whether it may fly comes before the flight. */
export const again = (task: TaskStatus): Promise<void> =>
  request(task.service, task.parameters, "ask").then(
    () => close(task),
    (error: Error) => refuse(translated(error.message), null),
  );

/** What waits for a person, and what went wrong, as cards: on every screen, clear of STOP. */
export function Questions({ over }: { over: boolean }) {
  const waiting = asked.value;
  const ended = endedBadly.value.filter((one) => !read.value.has(one.id)).slice(0, SHOWN);
  const more = over ? waiting.length - SHOWN : 0;
  const rings = over && bellAsks.value;
  if (waiting.length + ended.length === 0 && !rings) return null;
  return (
    <section
      class={`questions ${over ? "over" : ""}`}
      aria-label={t("Questions")}
      data-event={bellRings.value}
    >
      {rings && <BellCard />}
      {(over ? waiting.slice(0, SHOWN) : waiting).map((one) => (
        <Card key={`${one.task.id} ${one.question.id}`} one={one} />
      ))}
      {ended.map((task) => (
        <p class="ended-badly" role="alert" key={task.id}>
          <span>
            <strong>
              △ <Told words={translated(task.title)} />:
            </strong>{" "}
            <Told words={withAdvice(task.words || task.state, task.code)} />
          </span>
          <button type="button" onClick={() => void again(task)}>
            {t("Try again")}
          </button>
          <button type="button" onClick={() => close(task)}>
            {t("Close")}
          </button>
        </p>
      ))}
      {more > 0 && (
        <button type="button" onClick={() => open("tasks")}>
          {t("{n} more question|{n} more questions", { n: more })}
        </button>
      )}
    </section>
  );
}

/** What a question belongs to and who wanted it, as far as the question does not say so. */
function behind(task: TaskStatus): string {
  const parts = [translated(task.title), isSpoken(task) ? "" : why(task)];
  return capital(parts.filter(Boolean).join(" · "));
}

function Card({ one: { task, question } }: { one: Asked }) {
  const caused = question.id === CONFIRMATION && task.cause !== "";
  // While a task is paused, its times stand still.
  const ends = task.state === "paused" ? null : question.until;
  const left = ends === null ? null : ends - unixNow.value;
  return (
    <article class="question" aria-label={t("Question of task {n}", { n: task.id })}>
      <p class="words" role="alert">
        <Told words={caused ? proposal(task) : sentence(translated(question.words))} />
      </p>
      {!caused && <p class="quiet">{behind(task)}</p>}
      <div class="choices">
        {question.choices.map((choice, k) => (
          <Choice
            key={choice}
            task={task.id}
            question={question.id}
            choice={choice}
            first={k === 0}
            harmless={
              question.id !== CONFIRMATION ||
              choice === question.otherwise ||
              HARMLESS.includes(choice.toLowerCase())
            }
          />
        ))}
      </div>
      <details class="quiet">
        <summary>{question.id === CONFIRMATION ? <InShort task={task} /> : t("Details")}</summary>
        {caused && !isSpoken(task) && <p>{sentence(why(task))}</p>}
        {task.rehearsal?.may_fly && (
          <p>
            <Told words={rehearsed(task.rehearsal)} />
          </p>
        )}
        {left !== null && (
          <p>
            {t("Without an answer it counts as “{choice}” in {time}.", {
              choice: translated(question.otherwise),
              time: minutes(left),
            })}
          </p>
        )}
      </details>
      {trouble.value.task === task.id && (
        <p role="alert">△ {sentence(translated(trouble.value.words))}</p>
      )}
    </article>
  );
}

/** What the rehearsal found, below the answers: it comes late, and no pressed button may move. */
function InShort({ task: { rehearsal } }: { task: TaskStatus }) {
  const { may_fly, duration, charge } = rehearsal ?? {};
  return (
    <span class="rehearsal" data-may={may_fly}>
      {!rehearsal ? (
        t("Rehearsing …")
      ) : may_fly && duration != null && charge != null ? (
        t("About {time}, up to {p} of the charge", {
          time: minutes(duration),
          p: percent(charge),
        })
      ) : (
        <Told words={rehearsed(rehearsal)} />
      )}
    </span>
  );
}

interface Answer {
  task: number;
  question: string;
  choice: string;
  first: boolean;
  harmless: boolean;
}

/** What may start a flight is held, so that no stray touch does. */
function Choice({ task, question, choice, first, harmless }: Answer) {
  const shownAt = useMemo(() => performance.now(), [task, question]);
  const answer = (): void => {
    trouble.value = { task: 0, words: "" };
    reply(task, question, choice).catch((error: Error) => {
      trouble.value = { task, words: error.message };
    });
  };
  const hold = useMemo(() => createHold(HOLD, free, answer), [task, question, choice]);
  const words = capital(translated(choice));
  if (harmless)
    return (
      <button
        type="button"
        class="secondary"
        // Whoever meant what was there before the card meant no answer.
        onClick={() => performance.now() - shownAt > SETTLED && answer()}
      >
        {words}
      </button>
    );
  return (
    <HoldButton hold={hold} class={first ? "primary" : "secondary"} label={words}>
      <span>{words}</span>
      <small aria-hidden="true">{t("hold")}</small>
    </HoldButton>
  );
}
