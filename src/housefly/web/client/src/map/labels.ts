// Where names go on the map: only where there is room for them, places before things.
import type { PlaceView, RoomView } from "../wire/messages";
import { around, boxOf, overlap, type Box } from "./label-spots";
import type { Projection } from "./projection";

export interface Label {
  kind: "spot" | "thing";
  text: string;
  x: number;
  y: number;
}

const LINE = 14;
const FILLED = 0.35;
const MARK = 6;
const OUTSIDE_COST = 1e4;
/** A name that would cover more of others [px²] is left out; the mark stays, and the list. */
const CROWDED = 60;
export const WALLS = /wall|partition|pillar|column/;

export function labels(view: RoomView, to: Projection): Label[] {
  const taken: Box[] = marks(view, to);
  const places = view.places
    .filter((place) => place.name !== "home")
    .flatMap((place) => besideMark(place, to, taken));
  const things = thingBoxes(view, to).flatMap(({ text, box }) =>
    inside(text, shown(box, to), taken),
  );
  return [...places, ...things];
}

/** What the names of places and things cover, for others to keep clear of. */
export function namesOf(view: RoomView, to: Projection): Box[] {
  return labels(view, to).map((one) => boxOf(one.text, one.x, one.y));
}

/** The name of a place stands below, above, right or left of its mark: where it covers least. */
function besideMark(place: PlaceView, to: Projection, taken: Box[]): Label[] {
  const [u, v] = to.at(place.viewpoint);
  const side = boxOf(place.title, 0, 0).x1 + 9;
  const spots: [number, number][] = [
    [u, v + 18],
    [u, v - 10],
    [u + side, v + 4],
    [u - side, v + 4],
  ];
  const costs = spots.map(([x, y]) => {
    const box = boxOf(place.title, x, y);
    const fits = box.x0 > 0 && box.x1 < to.width && box.y0 > 0 && box.y1 < to.height;
    return overlap(box, taken) + (fits ? 0 : OUTSIDE_COST);
  });
  const least = Math.min(...costs);
  if (least > CROWDED) return [];
  const [x, y] = spots[costs.indexOf(least)]!;
  taken.push(boxOf(place.title, x, y));
  return [{ kind: "spot", text: place.title, x, y }];
}

/** The part of a box that is in view: there its name stands. */
function shown(box: Box, to: Projection): Box {
  return {
    x0: Math.max(0, box.x0),
    y0: Math.max(0, box.y0),
    x1: Math.min(to.width, box.x1),
    y1: Math.min(to.height, box.y1),
  };
}

function inside(text: string, box: Box, taken: Box[]): Label[] {
  const [x, y] = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2 + 4];
  const own = boxOf(text, x, y);
  if (
    own.x1 - own.x0 > box.x1 - box.x0 + 8 ||
    box.y1 - box.y0 < LINE - 2 ||
    overlap(own, taken) > 0
  )
    return [];
  taken.push(own);
  return [{ kind: "thing", text, x, y }];
}

/** Boxes [px] of things in one piece; things in several spots, such as chairs, get no name. */
function thingBoxes(view: RoomView, to: Projection): { text: string; box: Box }[] {
  const found = new Map<string, { box: Box; area: number }>();
  for (const outline of view.outlines) {
    if (outline.tracked) continue;
    if (WALLS.test(outline.thing) || outline.top < 0.05) continue;
    const box = around(outline.corners.map((corner) => to.at(corner)));
    const known = found.get(outline.thing);
    const joined = known
      ? around([
          [known.box.x0, known.box.y0],
          [known.box.x1, known.box.y1],
          [box.x0, box.y0],
          [box.x1, box.y1],
        ])
      : box;
    found.set(outline.thing, { box: joined, area: (known?.area ?? 0) + area(box) });
  }
  return [...found]
    .filter(([, { box, area: sum }]) => sum > FILLED * area(box))
    .sort(([, a], [, b]) => area(b.box) - area(a.box))
    .map(([thing, { box }]) => ({ text: thing.replace(/[_-]/g, " "), box }));
}

function marks(view: RoomView, to: Projection): Box[] {
  const points = [...view.places.map((place) => place.viewpoint), view.home];
  return points.map((point) => {
    const [u, v] = to.at(point);
    return { x0: u - MARK, y0: v - MARK, x1: u + MARK, y1: v + MARK };
  });
}

function area(box: Box): number {
  return (box.x1 - box.x0) * (box.y1 - box.y0);
}
