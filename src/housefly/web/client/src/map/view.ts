// The part of the map that is on the screen, for all maps of the page: one is shown at a time.
import { batch, computed, effect, signal, untracked } from "@preact/signals";
import { goal } from "../goal";
import { hasDrone, room, screen, swapped, type Point } from "../store";
import {
  aimed,
  dragged,
  limited,
  midway,
  nearer,
  seenBy,
  WHOLE,
  type Camera,
  type Sight,
} from "./camera";
import { insideOf } from "./grid";
import { fit, rotated, turned, turnedBounds } from "./projection";

const MARGIN = 14;
/** Height of the buttons at the top of the map [px]. */
const BAND = 58;
/** On a map that is narrower [px] the picture lies in the corner, so high for its width. */
const NARROW = 500;
const INSET = 0.22;
const GLIDE = 180;
const SETTLED = 250;
const STEP = 1.6;

export const size = signal<Point>([0, 0]);
/** In the frame of the turned room. */
const camera = signal<Camera>(WHOLE);
/** How far two fingers have turned the room on the screen, counterclockwise [rad]. */
export const angle = signal(0);
/** Whether the map moves under a hand: marks then keep to it at once. */
export const moving = signal(false);

/** The small map beside a large picture shows the whole room. */
const isSmall = computed(() => swapped.value && screen.value === "live");

const sight = computed<Sight | null>(() => {
  const view = room.value;
  const [width, height] = size.value;
  if (!view || width <= 0 || height <= 0) return null;
  const bounds = turnedBounds(insideOf(view.grid) ?? view.bounds, angle.value);
  const hasInset = width < NARROW && screen.value === "live" && hasDrone.value && !isSmall.value;
  const kept = hasInset ? INSET * width : 0;
  return { bounds, whole: fit(bounds, width, height, MARGIN, BAND, kept) };
});
export const projection = computed(() => {
  const whole = sight.value;
  return whole && turned(seenBy(isSmall.value ? WHOLE : camera.value, whole), angle.value);
});
export const zoom = computed(() => (isSmall.value ? 1 : camera.value.zoom));

let settling = 0;

function look(next: Camera): void {
  batch(() => {
    camera.value = next;
    moving.value = true;
  });
  clearTimeout(settling);
  settling = window.setTimeout(() => (moving.value = false), SETTLED);
}

let gliding = 0;

const still = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Show all shares of a way, 0 to 1, or the end at once for those who want no motion. */
export function smoothly(show: (share: number) => void): void {
  cancelAnimationFrame(gliding);
  const began = performance.now();
  const step = (time: number): void => {
    const share = still() ? 1 : Math.min(1, Math.max(0, (time - began) / GLIDE));
    show(share);
    if (share < 1) gliding = requestAnimationFrame(step);
  };
  step(began);
}

function glide(to: Camera): void {
  const from = camera.peek();
  smoothly((share) => look(share < 1 ? midway(from, to, share) : to));
}

function change(made: (whole: Sight) => Camera, way: (next: Camera) => void): void {
  const whole = sight.peek();
  if (!whole || isSmall.peek()) return;
  way(made(whole));
}

/** Draw the room so much larger; a pixel keeps its point of the room. */
export function zoomAt(factor: number, pixel: Point): void {
  cancelAnimationFrame(gliding);
  change((whole) => nearer(camera.peek(), whole, factor, pixel), look);
}

/** Let the room follow a hand by so many pixels. */
export function drag(right: number, down: number): void {
  cancelAnimationFrame(gliding);
  change((whole) => dragged(camera.peek(), whole, right, down), look);
}

/** A zoom that is less is as good as none. */
export const NEARER = 1.08;

/** Turn the room to an angle [rad]; a pixel keeps its point, and the room its size if it can. */
export function turnTo(next: number, pixel: Point): void {
  const before = projection.peek();
  if (!before || isSmall.peek()) return;
  const [point, { zoom }] = [before.back(pixel), camera.peek()];
  cancelAnimationFrame(gliding);
  batch(() => {
    angle.value = next;
    const whole = sight.peek()!;
    const kept = zoom > NEARER ? before.scale / whole.whole.scale : zoom;
    look(aimed(kept, rotated(point, next), pixel, whole));
  });
}

/** One step nearer (1) or farther (-1), around the middle. */
export function zoomStep(steps: number): void {
  const [width, height] = size.peek();
  change(
    (whole) => nearer(camera.peek(), whole, STEP ** steps, [width / 2, height / 2]),
    glide,
  );
}

export function panStep(right: number, down: number): void {
  change((whole) => dragged(camera.peek(), whole, right, down), glide);
}

export function showWhole(): void {
  change((whole) => limited({ ...camera.peek(), zoom: 1 }, whole), glide);
}

/** Bring a point of the room to the middle. */
export function bringTo(point: Point): void {
  change(
    (whole) =>
      limited({ zoom: camera.peek().zoom, centre: rotated(point, angle.peek()) }, whole),
    glide,
  );
}

/** Bring a point of the room into view, if it is not. */
export function keepInView(point: Point): void {
  const to = projection.peek();
  if (!to) return;
  const [u, v] = to.at(point);
  if (u < 0 || v < 0 || u > to.width || v > to.height) bringTo(point);
}

// A goal that a key or the name of a place has chosen is seen.
effect(() => {
  const aim = goal.value;
  if (aim) untracked(() => keepInView(aim.point));
});
