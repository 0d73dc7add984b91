// One finger that goes across the stage of a phone: from the map to the picture, and back.
import { listen } from "../hands";
import { swapped, type Point } from "../store";

/** A finger that goes less far across [px], or not twice as far as up or down, is no swipe. */
const FAR = 48;
const STEEP = 2;
/** By so much of its way the stage follows the finger. */
const FOLLOWS = 0.3;
const COMES_FROM = 60;
const COMES_IN = 180;
/** What a finger may press, and a map that it moves itself. */
const NOT_SWIPED = "button, a, summary, .layers, .space-view, .plan-view[data-zoomed=true]";

/** The view that has the stage. */
export const large = (): HTMLElement =>
  document.querySelector<HTMLElement>(swapped.peek() ? ".scene > .video" : ".scene > .map")!;

const isStill = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Show the picture or the map large; the new one comes in from the side where it lay. */
export function show(picture: boolean): void {
  if (picture === swapped.peek()) return;
  swapped.value = picture;
  if (isStill()) return;
  const [next, from] = [large(), picture ? COMES_FROM : -COMES_FROM];
  requestAnimationFrame(() =>
    next.animate(
      [{ transform: `translateX(${from}px)`, opacity: 0.3 }, { transform: "none", opacity: 1 }],
      { duration: COMES_IN, easing: "ease-out" },
    ),
  );
}

/** Let fingers swipe the stage of a scene until the returned function is called. */
export function listenToSwipes(scene: HTMLElement): () => void {
  let [view, start] = [null as HTMLElement | null, [0, 0] as Point];
  const across = (event: PointerEvent): number => event.clientX - start[0];

  const end = (): void => {
    if (view) view.style.translate = "";
    view = null;
  };
  const down = (event: PointerEvent): void => {
    end();
    const at = event.target as Element;
    // Two fingers pinch; a mouse has the button.
    if (!event.isPrimary || event.pointerType === "mouse" || at.closest(NOT_SWIPED)) return;
    if (large().contains(at)) [view, start] = [large(), [event.clientX, event.clientY]];
  };
  const move = (event: PointerEvent): void => {
    if (view && event.isPrimary && !isStill())
      view.style.translate = `${(FOLLOWS * across(event)).toFixed(0)}px`;
  };
  const up = (event: PointerEvent): void => {
    if (!view || !event.isPrimary) return;
    const [right, away] = [across(event), Math.abs(event.clientY - start[1])];
    end();
    if (Math.abs(right) > Math.max(FAR, STEEP * away)) show(right < 0);
  };

  return listen(scene, { pointerdown: down, pointermove: move, pointerup: up, pointercancel: end });
}
