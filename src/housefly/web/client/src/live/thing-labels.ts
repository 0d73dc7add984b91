// What stands beside the mark of a thing, and where it covers no other mark's words.
import { placed, type Box } from "../map/label-spots";
import { namesOf } from "../map/labels";
import type { Projection } from "../map/projection";
import { at, moment, situations, type Seen } from "./store";
import { percent } from "../format";
import { room } from "../store";
import { ago, isWorry, kindOf, worthSaying } from "./words";
import { t, translated } from "../messages/language";

export const MOVES = ["person", "robot", "object"];
const OLD = 10;
/** On a narrow map [px] that is not near [px/m] only names and worries have room. */
const NARROW = 500;
const NEAR = 50;
/** Of what is at least as likely, and no worry, its figure is not said: the answer has it. */
const SURE = 0.75;
const SPARED: Line["kind"][] = ["content", "situation"];

export interface Line {
  kind: "name" | "age" | "content" | "situation" | "worry";
  text: string;
}

export interface Words {
  lines: Line[];
  said: string;
  age: number | null;
  x: number;
  y: number;
}

/** What the names of the room cover, before anything that moves is named. */
export const takenByNames = (to: Projection): Box[] =>
  room.value ? namesOf(room.value, to) : [];

/**
 * Words for each thing, placed in turn, and the room they take added to `taken`: what moves
 * chooses first; what stands still, and what is said beside names, gives way.
 */
export function wordsOf(
  drawn: Seen[],
  inside: Map<string, Seen[]>,
  to: Projection,
  taken: Box[],
): Map<string, Words> {
  const still = (one: Seen): number => (MOVES.includes(kindOf(one)) ? 0 : 1);
  const words = new Map<string, Words>();
  const inTurn = [...drawn].sort((a, b) => still(a) - still(b));
  taken.push(...inTurn.map((one) => markOf(one, to)));
  for (const one of inTurn) {
    const age = ageOf(one);
    const all = linesOf(one, age, inside.get(one.thing) ?? []);
    const shown = roomFor(one, all, to, taken);
    // What is seen comes first, as who speaks to the machine says it.
    const rest = all.filter((line) => !shown.lines.includes(line));
    const said = [...shown.lines, ...rest].map((line) => line.text).join(", ");
    words.set(one.thing, { said, age, ...shown });
  }
  return words;
}

/** Time since a thing was seen at the moment that is shown [s]; null of one never seen. */
export function ageOf(thing: Seen): number | null {
  return thing.seenAt === null ? null : Math.max(0, moment.value - thing.seenAt);
}

export function personRadius(scale: number): number {
  return Math.max(9, 0.24 * scale);
}

function reachOf(thing: Seen, to: Projection): number {
  return kindOf(thing) === "person" ? personRadius(to.scale) : 11;
}

function markOf(thing: Seen, to: Projection): Box {
  const [u, v] = to.at([thing.position![0], thing.position![1]]);
  const reach = reachOf(thing, to) - 1; // words beside it may touch its edge
  return { x0: u - reach, y0: v - reach, x1: u + reach, y1: v + reach };
}

/** The lines that have room, and where they stand; those who move keep their names anyway. */
function roomFor(
  thing: Seen,
  all: Line[],
  to: Projection,
  taken: Box[],
): Pick<Words, "lines" | "x" | "y"> {
  const isTight = to.width < NARROW && to.scale < NEAR;
  const few = all.filter((line) => !SPARED.includes(line.kind));
  const least = all.filter((line) => line.kind === "name" || line.kind === "worry");
  const choices = isTight ? [few, least] : [all, few, least];
  const found = placed(
    {
      at: to.at([thing.position![0], thing.position![1]]),
      reach: reachOf(thing, to),
      choices: choices.map((lines) => lines.map((line) => line.text)),
      isKept: MOVES.includes(kindOf(thing)),
    },
    to,
    taken,
  );
  if (!found) return { lines: [], x: 0, y: 0 };
  return { lines: choices[found.choice]!, ...found.spot };
}

/** What is said of a thing, the same on the plan and in space. */
export function linesOf(thing: Seen, age: number | null, contents: Seen[]): Line[] {
  const kind = kindOf(thing);
  const lines: Line[] = [{ kind: "name", text: thing.name }];
  for (const held of at.value === null ? worthSaying(situations.value) : []) {
    if (held.thing !== thing.thing || held.kind === "person present") continue;
    const known = translated(held.words);
    const doubted = `${known}, ${percent(held.confidence)}`;
    lines.push(
      isWorry(held.kind)
        ? { kind: "worry", text: `△ ${doubted}` }
        : { kind: "situation", text: held.confidence < SURE ? doubted : known },
    );
  }
  if (contents.length)
    lines.push({
      kind: "content",
      text: t(kind === "person" ? "has {names}" : "in it: {names}", {
        names: contents.map((one) => one.name).join(", "),
      }),
    });
  if (age === null && MOVES.includes(kind)) lines.push({ kind: "age", text: t("never seen") });
  if (age !== null && age > OLD && MOVES.includes(kind))
    lines.push({ kind: "age", text: ago(age) });
  return lines;
}
