// Points, rectangles and boxes on the floor [m]; the grid is 5 cm.
import type { Point } from "../store";
import type { DraftBox, SiteDraft } from "../wire/draft-messages";

const STEP = 20;
/** A wall that is within this of a right angle gets one [rad]. */
const SQUARE = 0.12;

export const rounded = (value: number): number => Math.round(value * STEP) / STEP;
export const millimetres = (value: number): number => Math.round(value * 1000) / 1000;
export const pointOf = ([x, y]: Point): Point => [rounded(x), rounded(y)];

/** The nearest point on the 5 cm grid, on the floor. */
export function snapped(draft: SiteDraft, [x, y]: Point): Point {
  const [x0, y0, x1, y1] = draft.bounds ?? [-1000, -1000, 1000, 1000];
  return pointOf([Math.min(x1, Math.max(x0, x)), Math.min(y1, Math.max(y0, y))]);
}

/** The end of a wall: at a right angle to the axes if it nearly is. */
export function squared(draft: SiteDraft, from: Point, to: Point): Point {
  const [x, y] = snapped(draft, to);
  const [dx, dy] = [Math.abs(x - from[0]), Math.abs(y - from[1])];
  if (dy < SQUARE * dx) return [x, from[1]];
  return dx < SQUARE * dy ? [from[0], y] : [x, y];
}

export function rectangleOf(a: Point, b: Point): [number, number, number, number] {
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[0], b[0]), Math.max(a[1], b[1])];
}

/** A point in the frame of a box, and back. */
export function turned([x, y]: Point, yaw: number): Point {
  const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
  return [c * x - s * y, s * x + c * y];
}

export function cornersOf(box: DraftBox): Point[] {
  const [a, b] = [box.length / 2, box.width / 2];
  const corners: Point[] = [[a, b], [-a, b], [-a, -b], [a, -b]];
  return corners.map((corner) => {
    const [dx, dy] = turned(corner, box.yaw);
    return [box.x + dx, box.y + dy];
  });
}

/** The box whose opposite corners are the fixed one and the pulled one. */
export function resized(box: DraftBox, fixed: Point, to: Point): DraftBox {
  const [u, v] = turned([to[0] - fixed[0], to[1] - fixed[1]], -box.yaw);
  const [length, width] = [Math.max(0.05, Math.abs(u)), Math.max(0.05, Math.abs(v))];
  const middle: Point = [(Math.sign(u) || 1) * length, (Math.sign(v) || 1) * width];
  const [dx, dy] = turned([middle[0] / 2, middle[1] / 2], box.yaw);
  const at = [fixed[0] + dx, fixed[1] + dy].map(millimetres) as Point;
  return {
    ...box,
    x: at[0],
    y: at[1],
    length: millimetres(length),
    width: millimetres(width),
  };
}

export const radians = (degrees: number): number =>
  Math.round((degrees * Math.PI * 1e5) / 180) / 1e5;
export const degrees = (radians: number): number => Math.round((radians * 1800) / Math.PI) / 10;

/** How far outside of a rectangle a point is, by how far it is beyond each pair of sides [m]. */
export const outside = (a: number, b: number): number => Math.hypot(Math.max(0, a), Math.max(0, b));
