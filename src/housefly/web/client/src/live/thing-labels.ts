// What stands beside the mark of a thing, and where it covers no other mark's words.
import { blockOf, namesOf, overlap, type Box } from "../map/labels";
import type { Projection } from "../map/projection";
import { at, moment, situations, type Seen } from "./store";
import { percent } from "../format";
import { room } from "../store";
import { ago, isWorry, kindOf, worthSaying } from "./words";
import { t, translated } from "../messages/language";

export const LINE = 13;
export const MOVES = ["person", "robot", "object"];
const OLD = 10;
/** On a narrow map [px] that is not near [px/m] only names and worries have room. */
const NARROW = 500;
const NEAR = 50;
const SPARED: Line["kind"][] = ["content", "situation"];
const OUTSIDE_COST = 1e4;

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

/** Words for each thing, placed in turn: what moves chooses first, what stands still gives way. */
export function wordsOf(
  drawn: Seen[],
  inside: Map<string, Seen[]>,
  to: Projection,
): Map<string, Words> {
  const taken: Box[] = room.value ? namesOf(room.value, to) : [];
  const still = (one: Seen): number => (MOVES.includes(kindOf(one)) ? 0 : 1);
  const words = new Map<string, Words>();
  for (const one of [...drawn].sort((a, b) => still(a) - still(b))) {
    const age = ageOf(one);
    const all = linesOf(one, age, inside.get(one.thing) ?? []);
    const isTight = to.width < NARROW && to.scale < NEAR;
    const lines = isTight ? all.filter((line) => !SPARED.includes(line.kind)) : all;
    const said = all.map((line) => line.text).join(", ");
    words.set(one.thing, { lines, said, age, ...spotOf(one, lines, to, taken) });
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

function spotOf(
  thing: Seen,
  lines: Line[],
  to: Projection,
  taken: Box[],
): { x: number; y: number } {
  const [u, v] = to.at([thing.position![0], thing.position![1]]);
  const reach = kindOf(thing) === "person" ? personRadius(to.scale) : 11;
  const texts = lines.map((line) => line.text);
  const side = blockOf(texts, 0, 0).x1 + reach;
  const middle = 4 - ((lines.length - 1) * LINE) / 2;
  const spots = [
    { x: 0, y: reach + LINE },
    { x: 0, y: -reach - 5 - (lines.length - 1) * LINE },
    { x: side, y: middle },
    { x: -side, y: middle },
  ];
  const costs = spots.map(({ x, y }) => {
    const block = blockOf(texts, u + x, v + y);
    return (
      overlap(block, taken) +
      (block.x0 < 0 || block.x1 > to.width || block.y0 < 0 || block.y1 > to.height
        ? OUTSIDE_COST
        : 0)
    );
  });
  const best = spots[costs.indexOf(Math.min(...costs))]!;
  taken.push(blockOf(texts, u + best.x, v + best.y), {
    x0: u - reach,
    y0: v - reach,
    x1: u + reach,
    y1: v + reach,
  });
  return best;
}

/** What is said of a thing, the same on the plan and in space. */
export function linesOf(thing: Seen, age: number | null, contents: Seen[]): Line[] {
  const kind = kindOf(thing);
  const lines: Line[] = [{ kind: "name", text: thing.name }];
  for (const held of at.value === null ? worthSaying(situations.value) : []) {
    if (held.thing !== thing.thing || held.kind === "person present") continue;
    const words = `${translated(held.kind).replace(/^person /, "")}, ${percent(held.confidence)}`;
    lines.push(
      isWorry(held.kind)
        ? { kind: "worry", text: `△ ${words}` }
        : { kind: "situation", text: words },
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
