// Two fingers turn the map; a button, there only while it is turned, turns it back.
import { useEffect, useRef } from "preact/hooks";
import { listen } from "../hands";
import { screen, type Point } from "../store";
import { angle, NEARER, projection, showWhole, size, smoothly, turnTo, zoom } from "./view";
import { t } from "../messages/language";

/** Fingers that turn less do not mean it [rad]. */
const UNMEANT = 0.2;

/** The way back of a map that is turned, and the hands that turn it. */
export function Turning() {
  const here = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    // Where the room is edited zones lie along its axes.
    if (screen.peek() === "edit") angle.value = 0;
    return listenToTwists(here.current!.parentElement!);
  }, []);
  return (
    <>
      <span ref={here} hidden />
      {projection.value?.angle ? (
        <button
          type="button"
          class="turn-back"
          aria-label={t("Turn the map back")}
          onClick={turnBack}
        >
          <svg viewBox="-12 -12 24 24" style={{ rotate: `${-angle.value}rad` }}>
            <path d="M0 -10L5 0H-5z" />
            <path class="tail" d="M0 10L5 0H-5z" />
          </svg>
        </button>
      ) : null}
    </>
  );
}

/** Turn the room back, the shorter way. */
function turnBack(): void {
  const from = Math.atan2(Math.sin(angle.peek()), Math.cos(angle.peek()));
  const [width, height] = size.peek();
  smoothly((share) => turnTo(from * (1 - share), [width / 2, height / 2]));
}

/** Let two fingers turn the map in a box until the returned function is called. */
function listenToTwists(box: HTMLElement): () => void {
  const fingers = new Map<number, Point>();
  let twist = 0;

  const down = (event: PointerEvent): void => {
    if (event.isPrimary) fingers.clear();
    if (event.pointerType === "touch") fingers.set(event.pointerId, at(event));
    twist = 0;
  };
  const move = (event: PointerEvent): void => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const [now, other] = [at(event), [...fingers].find(([id]) => id !== event.pointerId)?.[1]];
    fingers.set(event.pointerId, now);
    if (!other || screen.peek() === "edit") return;
    const by = turnAround(other, before, now);
    twist += by;
    const { left, top } = box.getBoundingClientRect();
    const middle: Point = [(now[0] + other[0]) / 2 - left, (now[1] + other[1]) / 2 - top];
    if (Math.abs(twist) > UNMEANT) turnTo(angle.peek() + by, middle);
  };
  const up = (event: PointerEvent): void => {
    fingers.delete(event.pointerId);
    if (fingers.size > 0 || twist === 0) return;
    twist = 0;
    if (Math.abs(angle.peek()) < UNMEANT) turnBack();
    else if (zoom.peek() < NEARER) showWhole();
  };

  return listen(box, { pointerdown: down, pointermove: move, pointerup: up, pointercancel: up });
}

const at = (event: PointerEvent): Point => [event.clientX, event.clientY];

/** How far a finger went around another, counterclockwise [rad]. */
function turnAround([x, y]: Point, [x0, y0]: Point, [x1, y1]: Point): number {
  const [a, b, c, d] = [x0 - x, y - y0, x1 - x, y - y1];
  return Math.atan2(a * d - b * c, a * c + b * d);
}
