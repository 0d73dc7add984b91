// Everything a person can ask of the drone: when it is possible, and why not, by the verdict.
import { computed, type ReadonlySignal } from "@preact/signals";
import { goal, forgetGoal, planned } from "./goal";
import { createHold } from "./hold";
import { explain, refuse, remember } from "./said";
import { iFly, lineLives, me, notice, room, state, stopPress, verdict } from "./store";
import type { OrderKind } from "./wire/messages";
import { ask, stop as sendStop } from "./wire/socket";
import { t, translated } from "./messages/language";

const HOLD = 0.6;
const HOLD_CUT = 1.0;

type Reason = ReadonlySignal<string>;

function firstOf(...reasons: Reason[]): Reason {
  return computed(() => reasons.map((reason) => reason.value).find((words) => words !== "") ?? "");
}

function unless(condition: () => boolean, words: () => string): Reason {
  return computed(() => (condition() ? "" : words()));
}

const hasLine = unless(
  () => lineLives.value,
  () => t("No contact with the server."),
);
const mayFly = unless(
  () => iFly.value,
  () =>
    verdict.value?.control
      ? t("{who} has control. You watch.", { who: verdict.value.control })
      : t("Nobody has control: take it first."),
);
const hasGoal = unless(
  () => goal.value !== null,
  () => t("Choose a place, or point on the map."),
);
const hasPath = unless(
  () => goal.value === null || planned.value !== null,
  () => goal.value?.note ||
    (goal.value?.plan ? translated(goal.value.plan.reason) : t("Looking for a path …")),
);

/** Why an order would come to nothing, by the server's verdict. */
function objectionTo(order: OrderKind): Reason {
  return computed(
    () =>
      translated(verdict.value?.orders.find((one) => one.order === order)?.words ?? "") ||
      (verdict.value ? "" : t("No contact with the pilot.")),
  );
}

async function send(order: OrderKind, from: Element | null, withGoal = false): Promise<void> {
  const aim = withGoal ? goal.value : null;
  const target = aim ? (aim.place ? { place: aim.place } : { goal: aim.point }) : {};
  notice.value = "";
  remember(order, from);
  const answer = await ask({ type: "order", order, ...target });
  if (answer.type === "refused") refuse(translated(answer.reason), from);
  if (aim && answer.type === "accepted") forgetGoal();
}

/** STOP: the bar says that it was pressed, then what the server knows of it. */
export async function stop(): Promise<void> {
  stopPress.value = { state: "sending", words: "" };
  const trouble = await sendStop();
  stopPress.value = trouble
    ? { state: "failed", words: translated(trouble) }
    : { state: "", words: "" };
}

export const takeOff = createHold(
  HOLD,
  firstOf(hasLine, mayFly, objectionTo("take_off")),
  (from) => void send("take_off", from),
);
export const service = createHold(
  HOLD,
  firstOf(hasLine, mayFly, objectionTo("service"), hasGoal, hasPath),
  (from) => void send("service", from, true),
);
export const go = createHold(
  HOLD,
  firstOf(hasLine, mayFly, objectionTo("go"), hasGoal, hasPath),
  (from) => void send("go", from, true),
);
export const resume = createHold(
  HOLD,
  firstOf(hasLine, mayFly, objectionTo("resume")),
  (from) => void send("resume", from),
);
export const reset = createHold(
  HOLD,
  firstOf(hasLine, mayFly, objectionTo("reset")),
  (from) => void send("reset", from),
);
export const cutMotors = createHold(
  HOLD_CUT,
  firstOf(hasLine, mayFly),
  (from) => void send("cut", from),
);
export const serviceObjection = firstOf(hasLine, mayFly, objectionTo("service"));
/** Look at a place and come back, whatever goal is on the map. */
export async function lookAt(place: string, from: Element | null, look_s = 5): Promise<void> {
  remember("service", from);
  const answer = await ask({ type: "order", order: "service", place, look_s });
  if (answer.type === "refused") refuse(translated(answer.reason), from);
}
/** Home from where it landed: every check of a take-off counts, as for any place. */
export const flyHome = createHold(HOLD, serviceObjection, (from) => void lookAt("home", from, 0));
export const takeControl = createHold(HOLD, firstOf(hasLine), (from) => void takeOver(true, from));

export const landObjection = firstOf(hasLine, objectionTo("land"));
export const hoverObjection = firstOf(hasLine, mayFly, objectionTo("hover"));
export const homeObjection = firstOf(hasLine, mayFly, objectionTo("home"));

/** Home on a button is held; the key H is pressed. */
export const homeHeld = createHold(HOLD, homeObjection, (from) => void send("home", from));

type From = Element | null;

function press(objection: Reason, order: OrderKind, from: From): void {
  if (objection.value) explain(objection, from);
  else void send(order, from);
}

export function land(from: From = null): void {
  press(landObjection, "land", from);
}

export function hover(from: From = null): void {
  press(hoverObjection, "hover", from);
}

export function home(from: From = null): void {
  press(homeObjection, "home", from);
}

export async function takeOver(held: boolean, from: From = null): Promise<void> {
  const answer = await ask({ type: "lease", action: "take", held });
  if (answer.type === "refused") refuse(translated(answer.reason), from);
}

// Kept over a reload: phones discard pages that they froze.
const HAD_KEY = "housefly had control";
let had = sessionStorage.getItem(HAD_KEY) !== null;
let gave = false;

/** Whoever gives control away knows it; whoever loses it must be told. */
export function givesControl(): void {
  gave = true;
}

const holder = computed(() => verdict.value?.control);
verdict.subscribe((told) => {
  if (!told || me.peek() === 0) return;
  const mine = told.pilot === me.peek();
  if (had && !mine && !gave) {
    const words = told.control
      ? t("You lost control; {who} has it now", { who: told.control })
      : t("This page was silent and lost control; nobody has it: take it again");
    refuse(words, document.querySelector(".who [aria-expanded]"), holder);
  }
  if (mine) gave = false;
  if (had === mine) return;
  had = mine;
  if (mine) sessionStorage.setItem(HAD_KEY, "");
  else sessionStorage.removeItem(HAD_KEY);
});

const goalObjection = firstOf(hasGoal, hasPath);
/** What the goal lacks, in words; why nothing may fly stands at the top and on the large button. */
export const hint = computed(() => {
  if (serviceObjection.value) return "";
  if (goalObjection.value) return goalObjection.value;
  const floor = room.value?.limits.battery_floor ?? 0;
  const charge = state.value?.battery ?? 1;
  return charge < floor + 0.05 ? t("The battery is too low for a flight.") : "";
});
