// Fingers, mouse, wheel and keys on the map: what moves it, and what is left for a tap.
import { listen } from "../hands";
import type { Point } from "../store";
import { drag, panStep, showWhole, zoomAt, zoomStep } from "./view";

/** A touch that moves less is a tap [px]. */
const STILL = 8;
const ARROW = 80;
const LINE = 16;
/** Larger by so much a pixel of the wheel; a pinch on a trackpad is a wheel with Ctrl. */
const WHEEL = { wheel: 0.002, pinch: 0.01 };
const WHEEL_MAX = 0.7;

const KEYS: Record<string, () => void> = {
  "+": () => zoomStep(1),
  "=": () => zoomStep(1),
  "-": () => zoomStep(-1),
  "0": () => showWhole(),
  ArrowLeft: () => panStep(ARROW, 0),
  ArrowRight: () => panStep(-ARROW, 0),
  ArrowUp: () => panStep(0, ARROW),
  ArrowDown: () => panStep(0, -ARROW),
};

/**
 * Let hands move the map in a box until the returned function is called. Where one finger draws,
 * it takes two to move the map. Keys that reach the box are of the map: `keys.ts` took its own.
 */
export function listenToHands(box: HTMLElement, oneFingerDraws: () => boolean): () => void {
  const fingers = new Map<number, Point>();
  let start: Point = [0, 0];
  let first: EventTarget | null = null;
  let moved = false;

  const at = (event: MouseEvent): Point => {
    const { left, top } = box.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  const down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    if (event.isPrimary) fingers.clear();
    fingers.set(event.pointerId, at(event));
    if (fingers.size === 1) {
      [start, first, moved] = [at(event), event.target, false];
      return;
    }
    // What one finger has begun to draw is taken back.
    if (!moved) first?.dispatchEvent(new PointerEvent("pointercancel", { bubbles: true }));
    moved = true;
    event.stopPropagation();
  };
  const move = (event: PointerEvent): void => {
    const before = fingers.get(event.pointerId);
    if (!before || event.buttons === 0) return;
    const here = at(event);
    if (fingers.size === 1) {
      if (!moved && Math.hypot(here[0] - start[0], here[1] - start[1]) <= STILL) return;
      // A finger that is left of a pinch goes on moving the map.
      if (oneFingerDraws() && !moved) return;
      if (!moved) box.setPointerCapture(event.pointerId);
      moved = true;
      drag(here[0] - before[0], here[1] - before[1]);
    } else {
      const other = [...fingers].find(([id]) => id !== event.pointerId)![1];
      pinch(before, here, other);
    }
    fingers.set(event.pointerId, here);
  };
  const up = (event: PointerEvent): void => {
    if (event.isTrusted) fingers.delete(event.pointerId);
  };
  const click = (event: MouseEvent): void => {
    if (!moved || event.detail === 0) return;
    event.stopPropagation();
    event.preventDefault();
  };
  const wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : LINE;
    const [right, back] = [event.deltaX * unit, event.deltaY * unit];
    if (!event.ctrlKey && (event.shiftKey || Math.abs(right) > Math.abs(back)))
      return drag(-(right || back), 0);
    const power = -back * (event.ctrlKey ? WHEEL.pinch : WHEEL.wheel);
    return zoomAt(Math.exp(Math.max(-WHEEL_MAX, Math.min(WHEEL_MAX, power))), at(event));
  };
  const key = (event: KeyboardEvent): void => {
    const does = KEYS[event.key];
    if (!does || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    does();
  };

  const unhear = listen(box, {
    pointerdown: down,
    pointermove: move,
    pointerup: up,
    pointercancel: up,
    click,
    wheel,
  });
  // What in the box has the focus may take a key first.
  box.addEventListener("keydown", key);
  return () => {
    unhear();
    box.removeEventListener("keydown", key);
  };
}

/** One finger has moved and the other not: the room follows their middle and their distance. */
function pinch(before: Point, here: Point, other: Point): void {
  const apart = (one: Point): number =>
    Math.max(1, Math.hypot(one[0] - other[0], one[1] - other[1]));
  drag((here[0] - before[0]) / 2, (here[1] - before[1]) / 2);
  zoomAt(apart(here) / apart(before), [(here[0] + other[0]) / 2, (here[1] + other[1]) / 2]);
}
