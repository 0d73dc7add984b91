// Which part of the plan is on the screen: how near it is, and around which point of the room.
import type { Point } from "../store";
import { placed, type Bounds, type Projection } from "./projection";

export interface Camera {
  /** 1 is the whole room. */
  zoom: number;
  centre: Point;
}

/** What a camera looks at: the room, and how all of it is drawn. */
export interface Sight {
  bounds: Bounds;
  whole: Projection;
}

export const ZOOM_MAX = 8;
/** The room's edge may come so far into the picture [px], out from under the buttons there. */
const EDGE = { whole: 14, near: 56 };

export const WHOLE: Camera = { zoom: 1, centre: [0, 0] };

/** The same camera, no nearer and no farther than allowed, and never past the room. */
export function limited(camera: Camera, { bounds, whole }: Sight): Camera {
  const zoom = between(camera.zoom, 1, ZOOM_MAX);
  const scale = zoom * whole.scale;
  const edge = Math.min(EDGE.near, EDGE.whole + (zoom - 1) * (EDGE.near - EDGE.whole)) / scale;
  const middle = whole.back([whole.width / 2, whole.height / 2]);
  const along = (axis: 0 | 1, pixels: number): number => {
    const half = pixels / 2 / scale;
    const low = bounds[axis] + half - edge;
    const high = bounds[axis + 2]! - half + edge;
    // Where the room is smaller than the picture it stays inside, where the whole room has it.
    return low < high
      ? between(camera.centre[axis], low, high)
      : between(middle[axis], high, low);
  };
  return { zoom, centre: [along(0, whole.width), along(1, whole.height)] };
}

function between(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}

/** How a camera draws the room. */
export function seenBy(camera: Camera, sight: Sight): Projection {
  const { zoom, centre } = limited(camera, sight);
  const { scale, width, height } = sight.whole;
  if (zoom === 1) return sight.whole;
  return placed(zoom * scale, width, height, centre, [width / 2, height / 2]);
}

/** Nearer by a factor; the point of the room under a pixel stays there. */
export function nearer(camera: Camera, sight: Sight, factor: number, pixel: Point): Camera {
  const now = limited(camera, sight);
  return aimed(now.zoom * factor, seenBy(now, sight).back(pixel), pixel, sight);
}

/** The camera of a zoom that has a point of the room on a pixel. */
export function aimed(wanted: number, [x, y]: Point, pixel: Point, sight: Sight): Camera {
  const zoom = between(wanted, 1, ZOOM_MAX);
  const { scale, width, height } = sight.whole;
  const [across, up] = [pixel[0] - width / 2, height / 2 - pixel[1]];
  const centre: Point = [x - across / (zoom * scale), y - up / (zoom * scale)];
  return limited({ zoom, centre }, sight);
}

/** Moved so that the room follows by so many pixels to the right and down. */
export function dragged(camera: Camera, sight: Sight, right: number, down: number): Camera {
  const { zoom, centre } = limited(camera, sight);
  const scale = zoom * sight.whole.scale;
  return limited({ zoom, centre: [centre[0] - right / scale, centre[1] + down / scale] }, sight);
}

/** A camera on its way from one to another; the share is 0 to 1. */
export function midway(from: Camera, to: Camera, share: number): Camera {
  const mix = (a: number, b: number): number => a + share * (b - a);
  return {
    zoom: from.zoom * (to.zoom / from.zoom) ** share,
    centre: [mix(from.centre[0], to.centre[0]), mix(from.centre[1], to.centre[1])],
  };
}

/** At the lower right lie other things: the way back to the whole room, on a phone the picture. */
const CORNER = { share: 0.4, height: 90 };

/** Where an arrow at the edge points to a pixel that is out of view, and its turn [degree]. */
export function atTheEdge(
  [u, v]: Point,
  { width, height }: Projection,
  inset: number,
): { spot: Point; turn: number } | null {
  if (u >= 0 && u <= width && v >= 0 && v <= height) return null;
  const x = between(u, inset, width - inset);
  const low = height - (x > (1 - CORNER.share) * width ? CORNER.height : inset);
  const y = between(v, inset, Math.max(inset, low));
  return { spot: [x, y], turn: (Math.atan2(v - y, u - x) * 180) / Math.PI };
}
