// A sentence that was asked, and its answer: the same on the live scene and among the tasks.
import { computed, effect, signal } from "@preact/signals";
import { createHold } from "../hold";
import { board, running, unixNow } from "./board";
import { request, say } from "./tasks-client";
import type { SentenceAnswer } from "../wire/task-messages";
import { t } from "../messages/language";

export const said = signal("");
export const answer = signal<SentenceAnswer | null>(null);
export const trouble = signal("");
/** When the answer came [s]: it is about then. */
export const answeredAt = signal(0);

const SHOWN = 60;
let turn = 0;

export async function ask(words: string): Promise<void> {
  if (!words.trim()) return;
  const mine = ++turn;
  said.value = words;
  answer.value = null;
  trouble.value = "";
  try {
    const found = await say(words.trim());
    if (mine !== turn) return;
    answeredAt.value = unixNow.value;
    answer.value = found;
  } catch (error) {
    if (mine === turn) trouble.value = (error as Error).message;
  }
}

/** Nothing is asked any more; an answer that still comes is not wanted. */
export function forget(): void {
  turn += 1;
  said.value = "";
  answer.value = null;
  trouble.value = "";
}

// An answer is of the moment when it came, and is put away after a while, or as soon as its task
// goes on; an offer waits.
effect(() => {
  const { task, offer } = answer.value ?? {};
  const now = board.value;
  const isOld = unixNow.value - answeredAt.value > SHOWN;
  const same = now?.tasks.find((one) => one.id === task?.id)?.state === task?.state;
  const goesOn = now && now.at > answeredAt.value && !same;
  if (answer.value && !offer && (isOld || goesOn)) forget();
});

const HOLD = 0.6;
export const servicesRun = computed(() =>
  running.value ? "" : t("The services are not running."),
);
export const accept = createHold(HOLD, servicesRun, () => void take());

/** Take what an answer offers: "it was seen long ago, shall I go and look?" */
async function take(): Promise<void> {
  const offer = answer.value?.offer;
  if (!offer) return;
  try {
    const { tasks } = await request(offer.service, offer.parameters);
    answer.value = { ...answer.value!, offer: null, words: tasks[0]?.words ?? "" };
  } catch (error) {
    trouble.value = (error as Error).message;
  }
}
