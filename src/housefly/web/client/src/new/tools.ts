// Which step is open, which item, and what a touch of the plan does there.
import { batch, signal } from "@preact/signals";
import type { Point } from "../store";
import type { SiteDraft } from "../wire/draft-messages";
import { act, change, known } from "./draft";
import { millimetres, rectangleOf, rounded, snapped, squared } from "./geometry";
import type { Key } from "./messages/en";
import { t } from "./messages/texts";
import { without, type Item, type Kind } from "./items";
import { slug, unused } from "./unique-names";

/** Where the markers of a drone that stands on the floor are, as the dialog has it [m]. */
const BODY_HEIGHT = 0.05;

export type Step =
  | "room"
  | "objects"
  | "pad"
  | "places"
  | "zones"
  | "tracking"
  | "frame"
  | "drone"
  | "save";
export type Tool = "move" | "wall" | "box" | "erase";

export interface Preset {
  name: Key;
  length: number;
  width: number;
  top: number;
}

export const PRESETS: Preset[] = [
  { name: "table", length: 1.6, width: 0.8, top: 0.75 },
  { name: "chair", length: 0.5, width: 0.5, top: 0.9 },
  { name: "sofa", length: 2.0, width: 0.9, top: 0.8 },
  { name: "bed", length: 2.0, width: 0.9, top: 0.5 },
  { name: "shelf", length: 0.8, width: 0.4, top: 1.8 },
  { name: "cupboard", length: 1.0, width: 0.5, top: 2.0 },
  { name: "box", length: 0.5, width: 0.5, top: 0.5 },
];

/** What the plan offers to touch, by step. */
export const TOUCHED: Record<Step, readonly Kind[]> = {
  room: [],
  objects: ["walls", "furniture"],
  pad: ["pad"],
  places: ["places"],
  zones: ["zones"],
  tracking: [],
  frame: ["frame_points"],
  drone: [],
  save: [],
};

const STEP_OF: Record<string, Step> = {
  walls: "objects",
  furniture: "objects",
  bounds: "room",
  height: "room",
  name: "room",
  flight_height: "room",
  frame_points: "frame",
  pad_yaw: "pad",
};

const opened = location.hash.slice(1);
export const step = signal<Step>(opened in TOUCHED ? (opened as Step) : "room");
export const chosen = signal<Item | null>(null);
export const tool = signal<Tool>("box");
export const preset = signal<Preset>(PRESETS[0]!);

export function openStep(next: Step): void {
  batch(() => {
    step.value = next;
    chosen.value = next === "pad" && known.value.pad ? { kind: "pad", index: 0 } : null;
  });
  history.replaceState(null, "", `#${next}`); // a reload comes back to it
}

/** Open the step, and the item, that a key of the draft is about. */
export function openKey(key: string): void {
  const [head, index] = key.split(".");
  const next = STEP_OF[head!] ?? (head! in TOUCHED ? (head as Step) : null);
  if (!next || (step.value === next && !index)) return;
  batch(() => {
    if (step.value !== next) openStep(next);
    const kind = head as Kind;
    if (index && TOUCHED[next].includes(kind)) chosen.value = { kind, index: Number(index) };
  });
}

/** Open an item; what was drawn before can be moved from then on. */
export function choose(item: Item | null): void {
  batch(() => {
    chosen.value = item;
    if (item) tool.value = "move";
  });
}

/** Whether a drag moves what it begins on; otherwise it draws, also from wall to wall. */
export function moves(): boolean {
  return step.value !== "objects" || tool.value === "move";
}

export function remove(item: Item): void {
  batch(() => {
    chosen.value = null;
    change(without(known.value, item));
  });
}

// --- what a drag over free floor draws, and a tap adds

/** What is drawn between two points; null where a drag means nothing. */
export function drawn(from: Point, to: Point): { from: Point; to: Point; kind: Kind } | null {
  const all = known.value;
  if (step.value === "objects" && tool.value === "wall") {
    const start = snapped(all, from);
    return { from: start, to: squared(all, start, to), kind: "walls" };
  }
  const corners = { from: snapped(all, from), to: snapped(all, to) };
  if (step.value === "zones") return { ...corners, kind: "zones" };
  return step.value === "objects" && tool.value !== "move"
    ? { ...corners, kind: "furniture" }
    : null;
}

export function finishDrawing(from: Point, to: Point): void {
  const line = drawn(from, to);
  if (!line || (line.from[0] === line.to[0] && line.from[1] === line.to[1])) return;
  const area = rectangleOf(line.from, line.to);
  if (line.kind === "walls") addWall(line.from, line.to);
  else if (area[0] === area[2] || area[1] === area[3]) return;
  else if (line.kind === "zones") addZone(area);
  else if (tool.value === "erase") void act("/draft/erase", { rectangle: area });
  else addBox(area);
}

/** A tap on free floor. */
export function tap(point: Point): void {
  const all = known.value;
  const at = snapped(all, point);
  if (step.value === "pad") {
    change({ pad: at });
    chosen.value = { kind: "pad", index: 0 };
  } else if (step.value === "places") addPlace(at);
  else if (step.value === "frame") addFramePoint(at);
  else chosen.value = null;
}

/** Add an item and open it; the tool stays, so that the next one can be drawn. */
function add<K extends "walls" | "furniture" | "places" | "zones" | "frame_points">(
  kind: K,
  one: SiteDraft[K][number],
): void {
  const all = known.value[kind] as object[];
  batch(() => {
    change({ [kind]: [...all, one] });
    chosen.value = { kind, index: all.length };
  });
}

export function addWall(start: Point, end: Point): void {
  add("walls", { start, end, thickness: 0.1, bottom: 0, top: null });
}

export function addBox([x0, y0, x1, y1]: [number, number, number, number]): void {
  const { name, top } = preset.value;
  add("furniture", {
    name: unused(t(name), known.value.furniture.map((one) => one.name)),
    x: millimetres((x0 + x1) / 2),
    y: millimetres((y0 + y1) / 2),
    length: millimetres(x1 - x0),
    width: millimetres(y1 - y0),
    top,
    bottom: 0,
    yaw: 0,
    thing: name,
  });
}

export function addPlace([x, y]: Point): void {
  const all = known.value.places;
  const title = unused(t("Place"), all.map((one) => one.title));
  const name = slug(title, all.map((one) => one.name));
  add("places", { name, x, y, title, look_at: null });
}

function addZone(rectangle: [number, number, number, number]): void {
  add("zones", { rectangle, reason: t("kept free") });
}

export function addFramePoint([x, y]: Point): void {
  const name = t("point {k}", { k: known.value.frame_points.length + 1 });
  add("frame_points", { name, on_map: [x, y, BODY_HEIGHT], seen: [0, 0, 0] });
}

/** A new item in the middle of the room, for those who have no pointer. */
export function addInTheMiddle(kind: Kind): void {
  const all = known.value;
  const [x0, y0, x1, y1] = all.bounds ?? [0, 0, 1, 1];
  const [x, y]: Point = [rounded((x0 + x1) / 2), rounded((y0 + y1) / 2)];
  const { length, width } = preset.value;
  if (kind === "walls") addWall([x - 0.5, y], [x + 0.5, y]);
  else if (kind === "furniture")
    addBox([x - length / 2, y - width / 2, x + length / 2, y + width / 2]);
  else if (kind === "places") addPlace([x, y]);
  else if (kind === "zones") addZone([x - 0.5, y - 0.5, x + 0.5, y + 0.5]);
  else if (kind === "frame_points") addFramePoint([x, y]);
  else tap([x, y]);
}
