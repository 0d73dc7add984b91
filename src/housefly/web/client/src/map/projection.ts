// World metres to pixels of the map and back: x to the right, y up.
import type { Point } from "../store";

export interface Projection {
  scale: number;
  width: number;
  height: number;
  at(point: Point): Point;
  back(pixel: Point): Point;
}

/** Fit bounds (x_min, y_min, x_max, y_max) [m] into width x height [px] with a margin [px]. */
export function fit(
  bounds: [number, number, number, number],
  width: number,
  height: number,
  margin: number,
): Projection {
  const [x0, y0, x1, y1] = bounds;
  const scale = Math.max(
    1,
    Math.min((width - 2 * margin) / (x1 - x0), (height - 2 * margin) / (y1 - y0)),
  );
  const left = (width - scale * (x1 - x0)) / 2;
  const top = (height - scale * (y1 - y0)) / 2;
  return {
    scale,
    width,
    height,
    at: ([x, y]) => [left + scale * (x - x0), top + scale * (y1 - y)],
    back: ([u, v]) => [x0 + (u - left) / scale, y1 - (v - top) / scale],
  };
}

/** SVG path text through points. */
export function polyline(projection: Projection, points: Point[], closed = false): string {
  const steps = points.map((point, k) => {
    const [u, v] = projection.at(point);
    return `${k ? "L" : "M"}${u.toFixed(1)} ${v.toFixed(1)}`;
  });
  return steps.join("") + (closed && steps.length ? "Z" : "");
}

/** A yaw of the world [rad] as an SVG transform: y points down on the screen. */
export function turn(yaw: number): string {
  return `rotate(${((-yaw * 180) / Math.PI).toFixed(1)})`;
}
