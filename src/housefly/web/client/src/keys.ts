// The keyboard: STOP from anywhere, everything else unless the focus has its own use for the key.
import { signal } from "@preact/signals";
import type { Hold } from "./hold";
import { isLetter, KEYS, letters, SPACE, type Key } from "./keymap";
import { flying, hasDrone, screen } from "./store";

/** Who takes keys before all others but Space, while it is set: moving the drone by hand. */
export const claim = signal<((event: KeyboardEvent) => boolean) | null>(null);

let held: { key: string; hold: Hold } | null = null;

function inTextField(target: EventTarget | null): boolean {
  if (target instanceof HTMLInputElement) return target.type !== "range";
  return target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;
}

/** What moves by the arrow keys itself: lists that scroll, and sliders. */
const OWN_ARROWS = "[data-scrolls], input[type=range]";

/** Whether the focus uses Enter itself, as buttons and links do; a chosen place no longer does. */
function usesEnter(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  const control = target.closest("button, a, summary, [role=button]");
  return control !== null && control.getAttribute("aria-pressed") !== "true";
}

function find(event: KeyboardEvent): Key | undefined {
  const key = event.key.toLowerCase();
  const shift = event.shiftKey && key === "escape";
  return KEYS.find((one) => one.keys.includes(key) && (one.shift ?? false) === shift);
}

/** Whether Space is for the focused button: on the ground there is nothing to stop. */
function presses(target: EventTarget | null): boolean {
  if (flying.peek() || !(target instanceof Element)) return false;
  return target.closest("button, a, summary") !== null;
}

function belongsToFocus(event: KeyboardEvent): boolean {
  if (event.key === SPACE && presses(event.target)) return true;
  // No goal moves and no flight begins where the goal is not on the screen.
  if (screen.peek() !== "live" && (event.key === "Enter" || event.key.startsWith("Arrow")))
    return true;
  // Someone who types a name while the drone flies can still stop it with Space.
  if (inTextField(event.target)) return event.key !== SPACE || !flying.peek();
  if (event.key.startsWith("Arrow"))
    return event.target instanceof Element && event.target.closest(OWN_ARROWS) !== null;
  return event.key === "Enter" && usesEnter(event.target);
}

function down(event: KeyboardEvent): void {
  if (event.ctrlKey || event.altKey || event.metaKey || belongsToFocus(event)) return;
  if (event.key !== SPACE && claim.peek()?.(event)) {
    event.preventDefault();
    event.stopPropagation();
    return;
  }
  const key = find(event);
  if (!hasDrone.peek() && event.key === SPACE) return;
  if (!key || (isLetter(event.key) && !letters.peek())) return;
  event.preventDefault();
  event.stopPropagation();
  if (key.hold) {
    if (event.repeat) return;
    held = { key: event.key, hold: key.hold };
    key.hold.begin();
  } else if (!event.repeat || event.key.startsWith("Arrow")) {
    key.press?.(event.key.toLowerCase());
  }
}

function up(event: KeyboardEvent): void {
  if (event.key === SPACE && !inTextField(event.target) && !presses(event.target))
    event.preventDefault();
  if (held && (event.key === held.key || event.key === "Shift")) letGo();
}

function letGo(): void {
  held?.hold.cancel();
  held = null;
}

export function listenToKeys(): void {
  window.addEventListener("keydown", down, { capture: true });
  window.addEventListener("keyup", up, { capture: true });
  window.addEventListener("blur", letGo);
}
