// A path in space as numbers: how far along, how fast, where in a second, where it can stop.
import { computed } from "@preact/signals";
import { path, room, state, type Point } from "../store";
import type { PathMessage } from "../wire/messages";

/** Classes of speed, slow to fast. */
export const SPEED_CLASSES = 5;
const MOVES = 0.05;

/** A path with the way along it [m] at each point; only of a path with heights and speeds. */
export interface Curve {
  points: Point[];
  heights: number[];
  times: number[];
  speeds: number[];
  marks: number[];
}

export function curveOf(told: PathMessage | null): Curve | null {
  if (!told || told.speeds.length < 2 || told.speeds.length !== told.waypoints.length) return null;
  const { waypoints: points, heights, times, speeds } = told;
  const marks = [0];
  points.forEach(([x, y], k) => {
    if (!k) return;
    const [u, v] = points[k - 1]!;
    marks.push(marks[k - 1]! + Math.hypot(x - u, y - v, heights[k]! - heights[k - 1]!));
  });
  return { points, heights, times, speeds, marks };
}

/** The curve that is flown now. */
export const curve = computed(() => curveOf(path.value));

/** The speed of the fastest colour [m/s]: the site's limit, or more where more is planned. */
export const topSpeed = computed(() =>
  Math.max(room.value?.limits.speed ?? 0, ...(curve.value?.speeds ?? []), 0.1),
);

export function speedClass(speed: number, top: number): number {
  return Math.max(0, Math.min(SPEED_CLASSES - 1, Math.floor((SPEED_CLASSES * speed) / top)));
}

/** The row before a value in a rising list, never the last, and the share of the step after it. */
function rowAt(values: number[], value: number): [number, number] {
  let low = 0;
  let high = values.length - 2;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (values[middle]! <= value) low = middle;
    else high = middle - 1;
  }
  const step = values[low + 1]! - values[low]!;
  return [low, step > 0 ? Math.max(0, Math.min(1, (value - values[low]!) / step)) : 0];
}

function between(values: number[], row: number, share: number): number {
  return (1 - share) * values[row]! + share * values[row + 1]!;
}

/** Where the curve is when it has come so far [m]. */
export function pointAt(way: Curve, mark: number): Point {
  const [row, share] = rowAt(way.marks, mark);
  const [a, b] = [way.points[row]!, way.points[row + 1]!];
  return [(1 - share) * a[0] + share * b[0], (1 - share) * a[1] + share * b[1]];
}

export function heightAt(way: Curve, mark: number): number {
  return between(way.heights, ...rowAt(way.marks, mark));
}

/** The part of the curve from one mark to another [m]. */
export function stretch(way: Curve, from: number, to: number): Point[] {
  const inside = way.points.filter((_, k) => way.marks[k]! > from && way.marks[k]! < to);
  return [pointAt(way, from), ...inside, pointAt(way, to)];
}

/** How far the curve has come at each whole second [m]. */
export function seconds(way: Curve): number[] {
  const last = Math.floor(way.times.at(-1)!);
  return Array.from({ length: Math.max(0, last) }, (_, k) =>
    between(way.marks, ...rowAt(way.times, k + 1)),
  );
}

/** How far along the curve the drone is [m]: the nearest place on the stretch it is at. */
export function markOf(way: Curve, here: Point, waypoint: number): number {
  const first = Math.max(0, Math.min(way.points.length - 2, waypoint - 2));
  let best = way.marks[first]!;
  let least = Infinity;
  for (let k = first; k < Math.min(way.points.length - 1, first + 4); k++) {
    const [a, b] = [way.points[k]!, way.points[k + 1]!];
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const square = dx * dx + dy * dy;
    const along = square ? ((here[0] - a[0]) * dx + (here[1] - a[1]) * dy) / square : 0;
    const share = Math.max(0, Math.min(1, along));
    const off = Math.hypot(here[0] - a[0] - share * dx, here[1] - a[1] - share * dy);
    if (off < least) {
      least = off;
      best = way.marks[k]! + share * (way.marks[k + 1]! - way.marks[k]!);
    }
  }
  return best;
}

/** Where the drone is on its curve, and where it would come to rest if it braked now [m]. */
export const braking = computed(() => {
  const [way, now] = [curve.value, state.value];
  if (!way || !now?.position || !now.velocity) return null;
  const at = markOf(way, [now.position[0], now.position[1]], now.waypoint);
  const moves = Math.hypot(...now.velocity) > MOVES;
  const distance = moves ? (now.stopping_distance ?? 0) : 0;
  return { at, rest: Math.min(way.marks.at(-1)!, at + distance), distance };
});

/** How far the drone has come: the last point or second of its curve that it has passed [m]. */
export const flown = computed(() => {
  const [way, here] = [curve.value, braking.value];
  if (!way || !here) return 0;
  return Math.max(0, ...[...way.marks, ...seconds(way)].filter((mark) => mark <= here.at));
});
