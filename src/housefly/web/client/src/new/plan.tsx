import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { fit, type Projection } from "../map/projection";
import { decimal } from "../messages/numbers";
import type { Point } from "../store";
import type { SiteDraft } from "../wire/draft-messages";
import { change, draft, preview } from "./draft";
import { rounded } from "./geometry";
import { anchorOf, gripsOf, itemAt, moved, type Grip, type Item } from "./items";
import type { Key } from "./messages/en";
import { t } from "./messages/texts";
import { PlanLayers } from "./plan-layers";
import { choose, chosen, drawn, finishDrawing, moves, step, tap, TOUCHED } from "./tools";

/** A touch that moves less is a tap [px]; what is nearer than a finger's width is meant [px]. */
const STILL = 6;
const NEAR = { mouse: 9, touch: 20 };
const MARGIN = 22;
/** What lies outside of the floor is shown too: the outer walls [m]. */
const AROUND = 0.15;

interface Drag {
  from: Point;
  to: Point;
  moved: boolean;
  near: number;
  /** The draft before it; a grip or an item changes that. */
  before: SiteDraft;
  grip: ((point: Point) => Partial<SiteDraft>) | null;
  item: Item | null;
}

const size = signal<Point>([0, 0]);
const drag = signal<Drag | null>(null);
const pointer = signal<Point | null>(null);

/** The floor plan: everything of the open step can be drawn, moved and reached with Tab. */
export function Plan() {
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      size.value = [entry!.contentRect.width, entry!.contentRect.height];
    });
    observer.observe(frame.current!);
    return () => observer.disconnect();
  }, []);
  const all = draft.value!;
  const to = projection(all);
  return (
    <section class="view map plan" aria-label={t("Floor plan")}>
      <div class="plan-view" ref={frame}>
        {to ? (
          <Drawing all={all} to={to} />
        ) : (
          <p class="veil">{t("Give the room a size first.")}</p>
        )}
      </div>
      <p class="where">
        <span>{pointer.value ? wordsOf(pointer.value) : hint()}</span>
        {to && <span class="too-close">{t("too close to fly")}</span>}
      </p>
    </section>
  );
}

function wordsOf([x, y]: Point): string {
  return `x ${decimal(rounded(x), 2)} m, y ${decimal(rounded(y), 2)} m`;
}

const HINTS: Partial<Record<string, Key>> = {
  objects: "Drag to draw; tap what is drawn to move it.",
  pad: "Tap where the pad lies; pull its line to where the nose looks.",
  places: "Tap for a new place; pull its line to what it looks at.",
  zones: "Drag over what is to be kept free.",
  frame: "Tap where a point lies on the floor.",
};

function hint(): string {
  const key = HINTS[step.value];
  return key ? t(key) : "";
}

function projection(all: SiteDraft): Projection | null {
  const [width, height] = size.value;
  if (!all.bounds || width === 0 || height === 0) return null;
  const [x0, y0, x1, y1] = all.bounds;
  if (!(x0 < x1 && y0 < y1)) return null;
  return fit([x0 - AROUND, y0 - AROUND, x1 + AROUND, y1 + AROUND], width, height, MARGIN);
}

function Drawing({ all, to }: { all: SiteDraft; to: Projection }) {
  const at = (event: PointerEvent): Point => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    return to.back([event.clientX - box.left, event.clientY - box.top]);
  };
  const down = (event: PointerEvent): void => {
    if (event.button !== 0 || TOUCHED[step.value].length === 0) return;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    const near = (event.pointerType === "mouse" ? NEAR.mouse : NEAR.touch) / to.scale;
    drag.value = begun(all, at(event), near);
  };
  const move = (event: PointerEvent): void => {
    const here = at(event);
    pointer.value = event.pointerType === "mouse" || drag.value ? here : null;
    if (drag.value) pull(drag.value, here, to.scale);
  };
  const up = (): void => {
    const done = drag.value;
    drag.value = null;
    if (done) finish(done);
  };
  const now = drag.value;
  const line = now?.moved && !now.item && !now.grip ? drawn(now.from, now.to) : null;
  return (
    <svg
      width={to.width}
      height={to.height}
      role="group"
      aria-label={t("Floor plan. Tab reaches what the open step draws; arrow keys move it.")}
      data-scale={to.scale}
      data-step={step.value}
      data-origin={to.at([0, 0]).join(" ")}
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={up}
      onPointerCancel={cancel}
      onMouseDown={(event) => event.preventDefault() /* the focus stays where it is */}
      onPointerLeave={() => (pointer.value = null)}
    >
      <PlanLayers all={all} to={to} line={line} />
    </svg>
  );
}

function begun(all: SiteDraft, here: Point, near: number): Drag {
  const still = { from: here, to: here, moved: false, before: all, near, grip: null, item: null };
  if (!moves()) return still;
  const grip = nearest(chosen.value ? gripsOf(all, chosen.value) : [], here, near);
  if (grip) return { ...still, grip: grip.to };
  const item = itemAt(all, TOUCHED[step.value], here, near);
  if (item) choose(item);
  return { ...still, item };
}

function nearest(grips: Grip[], here: Point, near: number): Grip | null {
  let best: Grip | null = null;
  let least = 1.5 * near;
  for (const grip of grips) {
    const away = Math.hypot(grip.at[0] - here[0], grip.at[1] - here[1]);
    if (away <= least) [best, least] = [grip, away];
  }
  return best;
}

function pull(now: Drag, here: Point, scale: number): void {
  const [dx, dy] = [here[0] - now.from[0], here[1] - now.from[1]];
  const far = now.moved || scale * Math.hypot(dx, dy) > STILL;
  drag.value = { ...now, to: here, moved: far };
  if (!far) return;
  if (now.grip) preview(now.grip(here));
  else if (now.item) {
    const [x, y] = anchorOf(now.before, now.item);
    preview(moved(now.before, now.item, [rounded(x + dx) - x, rounded(y + dy) - y]));
  }
}

function finish(done: Drag): void {
  if (done.moved && (done.grip || done.item)) change({});
  else if (done.moved) finishDrawing(done.from, done.to);
  else if (!done.grip && !done.item) {
    const item = moves() ? null : itemAt(done.before, TOUCHED[step.value], done.to, done.near);
    if (item) choose(item);
    else tap(done.to);
  }
}

function cancel(): void {
  if (drag.value) preview(drag.value.before);
  drag.value = null;
}
