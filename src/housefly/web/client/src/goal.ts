// The goal that is being chosen: a ghost on the map with its path, until somebody holds "send".
import { computed, signal } from "@preact/signals";
import { sentence } from "./format";
import { cellOf, centreOf, letterAt } from "./map/grid";
import { notice, room, state, type Point } from "./store";
import { ask } from "./wire/socket";
import type { PlaceView, PlanAnswer } from "./wire/messages";
import { decimal, t, translated } from "./messages/language";

export interface Goal {
  /** Name of a place, or "" for a point on the map. */
  place: string;
  title: string;
  point: Point;
  /** Where the person pointed, when that point is blocked and the goal was moved. */
  asked: Point | null;
  note: string;
  plan: PlanAnswer | null;
}

/** Title of a goal that is nothing but a point. */
export const POINT = "this point";

export const goal = signal<Goal | null>(null);

/** Whether the goal can be flown to, as far as the planner knows. */
export const planned = computed(() => goal.value?.plan?.path ?? null);

let newest = 0;

export function choosePlace(place: PlaceView): void {
  goal.value = {
    place: place.name,
    title: place.title,
    point: place.viewpoint,
    asked: null,
    note: "",
    plan: null,
  };
  void preview();
}

const CENTIMETRES = 100;
const rounded = (metres: number): number => Math.round(CENTIMETRES * metres) / CENTIMETRES;

export function choosePoint(point: Point, title = POINT): void {
  const view = room.value;
  if (!view) return;
  goal.value = {
    place: "",
    title,
    point: [rounded(point[0]), rounded(point[1])],
    asked: null,
    note: "",
    plan: null,
  };
  void preview();
}

export function forgetGoal(): void {
  newest += 1;
  goal.value = null;
}

/** Ask again for the path, for example because the drone has moved. */
export async function preview(): Promise<void> {
  const asked = goal.value;
  if (!asked) return;
  notice.value = "";
  const turn = ++newest;
  const answer = await ask(
    asked.place ? { type: "plan", place: asked.place } : { type: "plan", goal: asked.point },
  );
  if (turn !== newest) return;
  if (answer.type === "plan") settle(asked, answer.answer);
  else if (answer.type === "refused") goal.value = { ...asked, note: translated(answer.reason) };
}

function settle(asked: Goal, plan: PlanAnswer): void {
  if (plan.path || !plan.suggestion || asked.asked) {
    goal.value = { ...asked, plan, note: plan.path ? asked.note : translated(plan.reason) };
    return;
  }
  const away = Math.hypot(plan.suggestion[0] - asked.point[0], plan.suggestion[1] - asked.point[1]);
  const d = decimal(away, 1);
  const moved = t("The goal was moved {d} m, to the nearest free point.", { d });
  const note = `${sentence(translated(plan.reason))} ${moved}`;
  goal.value = {
    place: "",
    title: asked.place ? POINT : asked.title,
    point: plan.suggestion,
    asked: asked.point,
    note,
    plan: null,
  };
  void preview();
}

/** Move the ghost to the next free cell in a direction of the world (x, y are -1, 0 or 1). */
export function nudge(x: number, y: number): void {
  const view = room.value;
  if (!view) return;
  const drone = state.value?.position;
  const from: Point = goal.value?.point ?? (drone ? [drone[0], drone[1]] : view.home);
  let [i, j] = cellOf(view.grid, from);
  do {
    i += x;
    j += y;
  } while (
    letterAt(view.grid, i, j) !== "." &&
    i >= 0 &&
    j >= 0 &&
    i < view.grid.width &&
    j < view.grid.height
  );
  if (letterAt(view.grid, i, j) === ".") choosePoint(centreOf(view.grid, [i, j]));
}
