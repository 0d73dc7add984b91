// Where the drone was, in stretches of which only the newest grows: the others stay as drawn.
import type { Point } from "./store";

/** Each stretch begins where the one before it ends; oldest first. */
export type Trail = readonly (readonly Point[])[];

/** Steps of one stretch: short, for all of the newest is drawn anew with each. */
const STRETCH = 25;
export const STRETCHES = 24;
/** Between two points of the trail [m]. */
const STEP = 0.04;

/** The way through some points, oldest first. */
export function trailOf(points: readonly Point[]): Trail {
  const length = Math.ceil((points.length - 1) / STRETCH);
  const cut = Array.from({ length: Math.max(0, length) }, (_, k) =>
    points.slice(k * STRETCH, (k + 1) * STRETCH + 1),
  );
  return cut.slice(-STRETCHES);
}

/** The trail on to a point; the same where that is next to its end. */
export function extended(trail: Trail, point: Point): Trail {
  const newest = trail.at(-1) ?? [];
  const end = newest.at(-1);
  if (!end) return [[point]];
  if (Math.hypot(point[0] - end[0], point[1] - end[1]) < STEP) return trail;
  if (newest.length > STRETCH) return [...trail.slice(1 - STRETCHES), [end, point]];
  return [...trail.slice(0, -1), [...newest, point]];
}
