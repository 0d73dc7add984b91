// What can be drawn, one table: where it can be gripped, how it moves, what a touch meets.
import type { Point } from "../store";
import type { SiteDraft } from "../wire/draft-messages";
import {
  cornersOf,
  millimetres,
  outside,
  pointOf,
  radians,
  rectangleOf,
  resized,
  snapped,
  squared,
  turned,
} from "./geometry";

export type Kind = "walls" | "furniture" | "pad" | "places" | "zones" | "frame_points";

export interface Item {
  kind: Kind;
  index: number;
}

export interface Grip {
  at: Point;
  /** The change when it is pulled to a point. */
  to: (point: Point) => Partial<SiteDraft>;
}

const AHEAD = 0.8;

/** What a place looks at; where it only looks away from the pad, a point in that direction. */
export function lookOf(draft: SiteDraft, index: number): Point {
  const place = draft.places[index]!;
  if (place.look_at) return [place.look_at[0], place.look_at[1]];
  const [px, py] = draft.pad ?? [place.x - 1, place.y];
  const [dx, dy] = [place.x - px, place.y - py];
  const length = Math.hypot(dx, dy);
  const [u, v] = length ? [dx / length, dy / length] : turned([1, 0], draft.pad_yaw);
  return [place.x + AHEAD * u, place.y + AHEAD * v];
}

export function noseOf(draft: SiteDraft): Point {
  const [dx, dy] = turned([AHEAD, 0], draft.pad_yaw);
  return [draft.pad![0] + dx, draft.pad![1] + dy];
}

/** One item of a list replaced. */
export function with_<K extends "walls" | "furniture" | "places" | "zones" | "frame_points">(
  draft: SiteDraft,
  kind: K,
  index: number,
  next: Partial<SiteDraft[K][number]>,
): Partial<SiteDraft> {
  const all = draft[kind] as object[];
  return { [kind]: all.map((one, k) => (k === index ? { ...one, ...next } : one)) };
}

export function without(draft: SiteDraft, { kind, index }: Item): Partial<SiteDraft> {
  if (kind === "pad") return { pad: null };
  return { [kind]: (draft[kind] as object[]).filter((_, k) => k !== index) };
}

export function gripsOf(draft: SiteDraft, { kind, index }: Item): Grip[] {
  if (kind === "pad") return draft.pad ? [noseGrip(draft)] : [];
  if (kind === "walls") {
    const wall = draft.walls[index]!;
    const pull = (end: "start" | "end", other: Point) => (point: Point) =>
      with_(draft, "walls", index, { [end]: squared(draft, other, point) });
    return [
      { at: wall.start, to: pull("start", wall.end) },
      { at: wall.end, to: pull("end", wall.start) },
    ];
  }
  if (kind === "furniture") {
    const box = draft.furniture[index]!;
    const corners = cornersOf(box);
    return corners.map((at, k) => ({
      at,
      to: (point) =>
        with_(
          draft,
          "furniture",
          index,
          resized(box, corners[(k + 2) % 4]!, snapped(draft, point)),
        ),
    }));
  }
  if (kind === "zones") return zoneGrips(draft, index);
  if (kind === "places") {
    const height = draft.places[index]!.look_at?.[2] ?? draft.flight_height;
    const to = (point: Point): Partial<SiteDraft> =>
      with_(draft, "places", index, { look_at: [...pointOf(point), height] });
    return [{ at: lookOf(draft, index), to }];
  }
  return [];
}

function noseGrip(draft: SiteDraft): Grip {
  const [x, y] = draft.pad!;
  const degrees = (point: Point): number =>
    (Math.atan2(point[1] - y, point[0] - x) * 180) / Math.PI;
  return {
    at: noseOf(draft),
    to: (point) => ({ pad_yaw: radians(5 * Math.round(degrees(point) / 5)) }),
  };
}

function zoneGrips(draft: SiteDraft, index: number): Grip[] {
  const [x0, y0, x1, y1] = draft.zones[index]!.rectangle;
  const corners: Point[] = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
  return corners.map((at, k) => ({
    at,
    to: (point) =>
      with_(draft, "zones", index, {
        rectangle: rectangleOf(corners[(k + 2) % 4]!, snapped(draft, point)),
      }),
  }));
}

/** The draft with an item moved by dx, dy [m]; what it looks at goes with it. */
export function moved(draft: SiteDraft, { kind, index }: Item, by: Point): Partial<SiteDraft> {
  const [dx, dy] = by;
  const at = (x: number, y: number): Point => [millimetres(x + dx), millimetres(y + dy)];
  if (kind === "pad") return { pad: at(...draft.pad!) };
  if (kind === "walls") {
    const { start, end } = draft.walls[index]!;
    return with_(draft, kind, index, { start: at(...start), end: at(...end) });
  }
  if (kind === "zones") {
    const [x0, y0, x1, y1] = draft.zones[index]!.rectangle;
    return with_(draft, kind, index, { rectangle: [...at(x0, y0), ...at(x1, y1)] });
  }
  if (kind === "frame_points") {
    const [x, y, z] = draft.frame_points[index]!.on_map;
    return with_(draft, kind, index, { on_map: [...at(x, y), z] });
  }
  if (kind === "furniture") {
    const box = draft.furniture[index]!;
    const [x, y] = at(box.x, box.y);
    return with_(draft, kind, index, { x, y });
  }
  const place = draft.places[index]!;
  const [x, y] = at(place.x, place.y);
  if (!place.look_at) return with_(draft, kind, index, { x, y });
  const [u, v, height] = place.look_at;
  return with_(draft, kind, index, { x, y, look_at: [...at(u, v), height] });
}

/** Where an item is, for the shift of a drag: this point stays on the 5 cm grid. */
export function anchorOf(draft: SiteDraft, { kind, index }: Item): Point {
  if (kind === "pad") return draft.pad!;
  if (kind === "walls") return draft.walls[index]!.start;
  if (kind === "furniture") return cornersOf(draft.furniture[index]!)[2]!;
  if (kind === "places") return [draft.places[index]!.x, draft.places[index]!.y];
  const [x, y] =
    kind === "zones" ? draft.zones[index]!.rectangle : draft.frame_points[index]!.on_map;
  return [x, y];
}

/** How far a point is from an item [m]; 0 inside. */
function distance(draft: SiteDraft, { kind, index }: Item, [x, y]: Point): number {
  if (kind === "walls") {
    const { start, end, thickness } = draft.walls[index]!;
    const [dx, dy] = [end[0] - start[0], end[1] - start[1]];
    const along = ((x - start[0]) * dx + (y - start[1]) * dy) / (dx * dx + dy * dy || 1);
    const k = Math.min(1, Math.max(0, along));
    const away = Math.hypot(x - start[0] - k * dx, y - start[1] - k * dy);
    return Math.max(0, away - thickness / 2);
  }
  if (kind === "furniture") {
    const box = draft.furniture[index]!;
    const [u, v] = turned([x - box.x, y - box.y], -box.yaw);
    return outside(Math.abs(u) - box.length / 2, Math.abs(v) - box.width / 2);
  }
  if (kind === "zones") {
    const [x0, y0, x1, y1] = draft.zones[index]!.rectangle;
    return outside(Math.max(x0 - x, x - x1), Math.max(y0 - y, y - y1));
  }
  const [a, b] = anchorOf(draft, { kind, index });
  return Math.max(0, Math.hypot(x - a, y - b) - (kind === "pad" ? 0.4 : 0.1));
}

export function countOf(draft: SiteDraft, kind: Kind): number {
  return kind === "pad" ? (draft.pad ? 1 : 0) : draft[kind].length;
}

/** The item that a touch meets: the nearest one, and of those on top of each other the last. */
export function itemAt(
  draft: SiteDraft,
  kinds: readonly Kind[],
  point: Point,
  slack: number,
): Item | null {
  let best: Item | null = null;
  let least = slack;
  for (const kind of kinds)
    for (let index = 0; index < countOf(draft, kind); index++) {
      const away = distance(draft, { kind, index }, point);
      if (away <= least) [best, least] = [{ kind, index }, away];
    }
  return best;
}
