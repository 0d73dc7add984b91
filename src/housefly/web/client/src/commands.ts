// Everything a person can ask of the drone: when it is possible, and why not.
import { computed, type ReadonlySignal } from "@preact/signals";
import { goal, forgetGoal, planned } from "./goal";
import { sentence } from "./format";
import { createHold } from "./hold";
import { explain, refusal } from "./preflight";
import {
  contact,
  cut,
  flying,
  iFly,
  inContact,
  nameOf,
  notice,
  room,
  state,
  stopped,
  viewers,
} from "./store";
import type { OrderKind } from "./wire/messages";
import { ask, stop as sendStop } from "./wire/socket";

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
  () => contact.value === "open",
  () => "No contact with the server.",
);
const hasPilot = unless(
  () => inContact.value,
  () => "No contact with the pilot.",
);
const mayFly = unless(
  () => iFly.value,
  () =>
    viewers.value.pilot === null
      ? "Nobody has control: take it first."
      : `${nameOf(viewers.value.pilot)} has control. You watch.`,
);
const notStopped = unless(
  () => !stopped.value,
  () => "Stopped: hold Resume first.",
);
const notCut = unless(
  () => !cut.value,
  () => "Motors are cut: hold Reset first.",
);
const inTheAir = unless(
  () => flying.value,
  () => "The drone is on the ground.",
);
const onTheGround = unless(
  () => !flying.value,
  () => "The drone is already flying.",
);
const droneHeard = unless(
  () => state.value?.status != null && state.value.status !== "unknown",
  () => "The drone does not answer yet.",
);
const hasGoal = unless(
  () => goal.value !== null,
  () => "Choose a place, or point on the map.",
);
const hasPath = unless(
  () => goal.value === null || planned.value !== null,
  () => goal.value?.note || (goal.value?.plan ? goal.value.plan.reason : "Looking for a path …"),
);

const checked = unless(
  () => refusal.value === "",
  () => sentence(`Not ready: ${refusal.value}`),
);

const ready = firstOf(hasLine, hasPilot, mayFly, notCut, notStopped, droneHeard);

async function send(order: OrderKind, withGoal = false): Promise<void> {
  const aim = withGoal ? goal.value : null;
  const target = aim ? (aim.place ? { place: aim.place } : { goal: aim.point }) : {};
  notice.value = "";
  const answer = await ask({ type: "order", order, ...target });
  if (answer.type === "refused") notice.value = answer.reason;
  if (aim && answer.type === "accepted") forgetGoal();
}

export async function stop(): Promise<void> {
  notice.value = await sendStop();
}

export const takeOff = createHold(
  HOLD,
  firstOf(ready, onTheGround, checked),
  () => void send("take_off"),
);
export const service = createHold(
  HOLD,
  firstOf(ready, checked, hasGoal, hasPath),
  () => void send("service", true),
);
export const go = createHold(
  HOLD,
  firstOf(ready, checked, hasGoal, hasPath),
  () => void send("go", true),
);
export const resume = createHold(
  HOLD,
  firstOf(
    hasLine,
    hasPilot,
    mayFly,
    unless(
      () => stopped.value,
      () => "Only after STOP.",
    ),
  ),
  () => void send("resume"),
);
export const reset = createHold(HOLD, firstOf(hasLine, hasPilot, mayFly), () => void send("reset"));
export const cutMotors = createHold(HOLD_CUT, firstOf(hasLine, mayFly), () => void send("cut"));
export const takeControl = createHold(HOLD, firstOf(hasLine), () => void takeOver(true));

export const landObjection = firstOf(hasLine, inTheAir);
export const hoverObjection = firstOf(ready, inTheAir);
export const homeObjection = firstOf(ready, inTheAir);

function press(objection: Reason, order: OrderKind): void {
  if (objection.value) explain(objection);
  else void send(order);
}

export function land(): void {
  press(landObjection, "land");
}

export function hover(): void {
  press(hoverObjection, "hover");
}

export function home(): void {
  press(homeObjection, "home");
}

export async function takeOver(held: boolean): Promise<void> {
  const answer = await ask({ type: "lease", action: "take", held });
  notice.value = answer.type === "refused" ? answer.reason : "";
}

/** The first thing that keeps the person from sending the drone, in words. */
export const hint = computed(() => {
  if (service.objection.value) return service.objection.value;
  const floor = room.value?.limits.battery_floor ?? 0;
  const charge = state.value?.battery ?? 1;
  return charge < floor + 0.05 ? "The battery is too low for a flight." : "";
});
