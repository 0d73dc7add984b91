// Who stands in space: where, how sure that is, and what is said of them; the same as on the plan.
import { computed } from "@preact/signals";
import { showsThings } from "../live/layers";
import { at, shown, situations, things, trouble, type Seen } from "../live/store";
import { ageOf, linesOf, type Line } from "../live/thing-labels";
import { fade } from "../live/things";
import { kindOf } from "../live/words";
import { state } from "../store";

export type Posture = "upright" | "sitting" | "lying";

export interface ShownPerson {
  id: string;
  place: [number, number, number];
  yaw: number;
  posture: Posture;
  /** 1 of who is seen now, less of who was seen long ago. */
  strength: number;
  lines: Line[];
}

/** What situations say of a posture; who is not said to sit or lie is drawn upright. */
const POSTURES: [RegExp, Posture][] = [
  [/\b(lies|lying|fell|fallen)\b/, "lying"],
  [/\bsitting\b/, "sitting"],
];

function postureOf(thing: Seen): Posture {
  const held = at.value === null ? situations.value.filter((one) => one.thing === thing.thing) : [];
  const fits = POSTURES.find(([words]) => held.some((one) => words.test(one.kind)));
  return fits?.[1] ?? "upright";
}

function remembered(): ShownPerson[] {
  const all = shown.value;
  return all
    .filter((one) => kindOf(one) === "person" && one.position)
    .map((one) => ({
      id: one.thing,
      place: one.position!,
      yaw: one.yaw ?? 0,
      posture: postureOf(one),
      strength: fade(ageOf(one)),
      lines: linesOf(
        one,
        ageOf(one),
        all.filter((other) => other.inside === one.thing),
      ),
    }));
}

/** Whom tracking itself sees; without the room's memory there is nobody else. */
function tracked(): ShownPerson[] {
  return (state.value?.others ?? [])
    .filter((one) => !one.size[0])
    .map((one) => ({
      id: one.name,
      place: [one.position[0], one.position[1], 0],
      yaw: one.yaw,
      posture: "upright",
      strength: 1,
      lines: [{ kind: "name", text: one.name }],
    }));
}

export const shownPeople = computed<ShownPerson[]>(() => {
  const isHeard = things.value.size > 0 && !trouble.value;
  if (at.value === null && !isHeard) return tracked();
  return showsThings.value ? remembered() : [];
});

/** What is drawn of them, as text: an age that goes up by a second draws nothing anew. */
export const shownFigures = computed(() =>
  JSON.stringify(shownPeople.value.map((one) => ({ ...one, lines: [] }))),
);
