// Whether somebody who sees this page for the first time is shown around, and by which step.
import { computed, effect, signal } from "@preact/signals";
import { lazyPart } from "../lazy-part";
import { bellRings } from "../scene/bell";
import { said } from "../said";
import { flying, iFly, lineLives, panel, screen, verdict } from "../store";
import { asked } from "../tasks/board";

const KEY = "housefly hints";
const SEEN = "seen";
export const HINTS = 3;

/** A program that drives a browser has no first time. */
const isNew = (localStorage.getItem(KEY) ?? (navigator.webdriver ? SEEN : "")) !== SEEN;

/** The hint that is shown or waits, 0 to 2; 3 when all were. */
export const step = signal(isNew ? 0 : HINTS);
/** Whether somebody asked for them: then a watcher sees them, too. */
const wanted = signal(false);

/** Nobody is shown around while anything flies, fails, rings or waits for an answer. */
const isQuiet = computed(
  () =>
    lineLives.value &&
    verdict.value?.may_take_off === true &&
    verdict.value.stop.progress === "none" &&
    !flying.value &&
    !bellRings.value &&
    asked.value.length === 0,
);
const isDue = computed(
  () =>
    step.value < HINTS &&
    (iFly.value || wanted.value) &&
    isQuiet.value &&
    screen.value === "live" &&
    panel.value === "" &&
    !said.value,
);

export function nextHint(): void {
  step.value += 1;
  if (step.value >= HINTS) endHints();
}

export function endHints(): void {
  step.value = HINTS;
  wanted.value = false;
  localStorage.setItem(KEY, SEEN);
}

/** Show them again, from the first. */
export function showHints(): void {
  wanted.value = true;
  step.value = 0;
  panel.value = "";
}

// Whoever flies knows the way.
effect(() => {
  if (flying.value && iFly.value && step.peek() < HINTS) endHints();
});

const Bubble = lazyPart(async () => (await import("../later")).Bubble);

/** The hint of now, if one is due. */
export function Hints() {
  return isDue.value ? <Bubble /> : null;
}
