import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { goal } from "../goal";
import type { Key } from "../messages/en";
import { t } from "../messages/language";
import { endHints, HINTS, nextHint, step } from "./hints";

/** What is said, and what it is about. */
const SAID: { words: Key; about: string }[] = [
  { words: "Ask for anything, or choose a place on the map.", about: ".dock" },
  { words: "Fly to … lists the places; hold the large button to fly.", about: ".to-fly" },
  { words: "STOP stops at once. It works for everybody, at any time.", about: ".stop" },
];
const EDGE = 8;
const RING = 4;

/** One hint on the stage, and a ring around what it is about: no button lies below either. */
export function Bubble() {
  const box = useRef<HTMLElement>(null);
  const ring = useRef<HTMLDivElement>(null);
  const now = step.value;
  const { words, about } = SAID[now]!;
  useLayoutEffect(() => {
    const place = (): void => {
      if (box.current) onStage(box.current);
      if (ring.current) around(ring.current, document.querySelector(about));
    };
    place();
    const watching = new ResizeObserver(place);
    for (const one of [document.body, ...document.querySelectorAll(".scene > *")])
      watching.observe(one);
    return () => watching.disconnect();
  }, [about]);
  // Before it is painted: who reads it may press a key at once.
  useLayoutEffect(() => {
    const close = (event: KeyboardEvent): void => void (event.key === "Escape" && endHints());
    window.addEventListener("keydown", close, { capture: true });
    return () => window.removeEventListener("keydown", close, { capture: true });
  }, []);
  // Who has chosen a place needs no word about it.
  useEffect(() => {
    if (now === 0 && goal.value) nextHint();
  }, [goal.value]);
  return (
    <>
      <div class="hint-ring" ref={ring} aria-hidden="true" />
      <section class="hint" ref={box} aria-label={t("First steps")}>
        <p role="status">
          <small>
            {now + 1}/{HINTS}
          </small>{" "}
          {t(words)}
        </p>
        <button type="button" onClick={nextHint}>
          {t("OK")}
        </button>
        <button type="button" aria-label={t("Close the hints")} onClick={endHints}>
          ×
        </button>
      </section>
    </>
  );
}

/** How far down on the stage, of the room that the hint leaves. */
const DOWN = 0.4;

/** On what is large, map or picture; both leave their buttons at the edges. */
function onStage(box: HTMLElement): void {
  const views = [...document.querySelectorAll(".view.map, .view.video")];
  const sizes = views.map((view) => view.getBoundingClientRect());
  const stage = sizes.sort((a, b) => b.width * b.height - a.width * a.height)[0];
  if (!stage) return;
  const left = stage.left + (stage.width - box.offsetWidth) / 2;
  const top = stage.top + DOWN * (stage.height - box.offsetHeight);
  box.style.left = `${Math.max(EDGE, left)}px`;
  box.style.top = `${Math.max(EDGE, top)}px`;
}

function around(ring: HTMLElement, target: Element | null): void {
  const at = target?.getBoundingClientRect();
  ring.hidden = !at || at.width === 0;
  if (!at) return;
  ring.style.left = `${at.left - RING}px`;
  ring.style.top = `${at.top - RING}px`;
  ring.style.width = `${at.width + 2 * RING}px`;
  ring.style.height = `${at.height + 2 * RING}px`;
}
