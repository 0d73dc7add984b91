// World metres to pixels of the map and back: x to the right and y up, or turned.
import type { Point } from "../store";

export interface Projection {
  scale: number;
  /** How far the room is turned on the screen, counterclockwise [rad]. */
  angle: number;
  width: number;
  height: number;
  at(point: Point): Point;
  back(pixel: Point): Point;
}

/** x_min, y_min, x_max, y_max [m]. */
export type Bounds = [number, number, number, number];

/**
 * Fit bounds into width x height [px] with a margin [px]. A band at the top, where buttons lie, is
 * left free as far as there is room below; what is kept at the top is free in any case.
 */
export function fit(
  bounds: Bounds,
  width: number,
  height: number,
  margin: number,
  band = 0,
  kept = 0,
): Projection {
  const [x0, y0, x1, y1] = bounds;
  const scale = Math.max(
    1,
    Math.min((width - 2 * margin) / (x1 - x0), (height - 2 * margin - kept) / (y1 - y0)),
  );
  const left = (width - scale * (x1 - x0)) / 2;
  const free = height - scale * (y1 - y0);
  const top = Math.max(free / 2, Math.min(Math.max(band, kept), free - margin));
  return placed(scale, width, height, [x0, y1], [left, top]);
}

/** The projection in which a point of the room lies on a pixel. */
export function placed(
  scale: number,
  width: number,
  height: number,
  [x0, y0]: Point,
  [u0, v0]: Point,
): Projection {
  return {
    scale,
    angle: 0,
    width,
    height,
    at: ([x, y]) => [u0 + scale * (x - x0), v0 - scale * (y - y0)],
    back: ([u, v]) => [x0 + (u - u0) / scale, y0 - (v - v0) / scale],
  };
}

/** A point that was turned about the origin, counterclockwise [rad]. */
export function rotated([x, y]: Point, angle: number): Point {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [cos * x - sin * y, sin * x + cos * y];
}

/** A projection of the turned room as one of the room itself. */
export function turned(of: Projection, angle: number): Projection {
  return {
    ...of,
    angle,
    at: (point) => of.at(rotated(point, angle)),
    back: (pixel) => rotated(of.back(pixel), -angle),
  };
}

/** The bounds of turned bounds. */
export function turnedBounds([x0, y0, x1, y1]: Bounds, angle: number): Bounds {
  const corners = [[x0, y0], [x1, y0], [x0, y1], [x1, y1]] as const;
  const all = corners.map(([x, y]) => rotated([x, y], angle));
  const [xs, ys] = [all.map(([x]) => x), all.map(([, y]) => y)];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** SVG path text of a rectangle from its lower left corner, so wide and high [m]. */
export function rectangle(to: Projection, [x, y]: Point, width: number, height: number): string {
  const [right, top] = [x + width, y + height];
  return polyline(to, [[x, y], [right, y], [right, top], [x, top]], true);
}

/** SVG path text through points. */
export function polyline(
  projection: Projection,
  points: readonly Point[],
  closed = false,
): string {
  const steps = points.map((point, k) => {
    const [u, v] = projection.at(point);
    return `${k ? "L" : "M"}${u.toFixed(1)} ${v.toFixed(1)}`;
  });
  return steps.join("") + (closed && steps.length ? "Z" : "");
}

/** A yaw of the world [rad] as degrees on the screen, where y points down. */
export const turn = (yaw: number, to: Projection): string =>
  ((-(yaw + to.angle) * 180) / Math.PI).toFixed(1);
