// Moving the drone by hand: what is held becomes a velocity, sent ten times a second while it is.
import { batch, computed, effect, signal } from "@preact/signals";
import { hover } from "../commands";
import { claim } from "../keys";
import { letters } from "../keymap";
import { events, orderRefused, room } from "../store";
import { localNow } from "../wire/clock";
import type { Said } from "../wire/messages";
import { ask } from "../wire/socket";
import { gamepadPush, forgetGamepad } from "./gamepad";
import { offered } from "./nudge-here";

/** Along x, y and z of the map, each from -1 to 1. */
export type Push = [number, number, number];

/** The pilot forgets a nudge after 0.3 s. */
const PERIOD = 100;
/** No two are sent closer together [s]. */
const APART = 0.05;
let sentAt = 0;

const KEYS: Record<string, Push> = {
  w: [0, 1, 0],
  arrowup: [0, 1, 0],
  s: [0, -1, 0],
  arrowdown: [0, -1, 0],
  a: [-1, 0, 0],
  arrowleft: [-1, 0, 0],
  d: [1, 0, 0],
  arrowright: [1, 0, 0],
  r: [0, 0, 1],
  pageup: [0, 0, 1],
  f: [0, 0, -1],
  pagedown: [0, 0, -1],
};

export const on = signal(false);
/** What is held now: keys, and buttons of the page, by name. */
const held = signal<ReadonlyMap<string, Push>>(new Map());
const stick = signal<Push>([0, 0, 0]);
/** Why the pilot or the server refused; nothing is sent until everything was let go. */
export const refused = signal<Said>("");
const since = signal(0);

const push = computed<Push>(() => {
  const sum: Push = [...stick.value];
  for (const one of held.value.values()) one.forEach((part, k) => (sum[k]! += part));
  return sum.map((part) => Math.max(-1, Math.min(1, part))) as Push;
});
const direction = computed(() => push.value.map(Math.sign).join());
export const moving = computed(() => push.value.some((part) => part !== 0));

/** What limits the motion, in the pilot's words, since this direction is held. */
export const limit = computed(() => {
  if (!moving.value) return "";
  const told = events.value.filter(
    (one) => one.code === "nudge_limited" && one.number > since.value,
  );
  return (told.at(-1)?.text[1] as Said | undefined) ?? "";
});

/** Hold a direction, by the name of a key or a button. */
export function hold(name: string, direction: Push): void {
  if (!held.peek().has(name)) held.value = new Map([...held.peek(), [name, direction]]);
}

export function letGo(name: string): void {
  if (!held.peek().has(name)) return;
  held.value = new Map([...held.peek()].filter(([one]) => one !== name));
}

/** Nothing is held any more, whatever is pressed: the drone brakes and hovers. */
export function letGoOfAll(): void {
  forgetGamepad();
  batch(() => {
    held.value = new Map();
    stick.value = [0, 0, 0];
  });
}

export const isSeen = (): boolean => !document.hidden && document.hasFocus();

async function send(): Promise<void> {
  const speed = room.peek()?.limits["nudge_speed"] ?? 0;
  if (!on.peek() || !offered.peek() || refused.peek() || !isSeen()) return;
  if (localNow() - sentAt < APART) return;
  sentAt = localNow();
  const wanted = push.peek();
  // The pilot cuts a diagonal down to the same speed.
  const velocity = wanted.map((part) => part * speed) as Push;
  const answer = await ask({ type: "nudge", velocity, sent: localNow() });
  if (answer.type === "refused") refused.value = answer.reason;
}

function tick(): void {
  const pad = gamepadPush(hover);
  if (pad.some((part, k) => part !== stick.peek()[k])) stick.value = pad;
  if (moving.peek()) void send();
}

function claimed(event: KeyboardEvent): boolean {
  const name = event.key.toLowerCase();
  const direction = KEYS[name];
  if (!direction || (name.length === 1 && !letters.peek())) return false;
  // A key that was down already when moving began must be let go first.
  if (!event.repeat) hold(name, direction);
  return true;
}

const released = (event: KeyboardEvent): void => letGo(event.key.toLowerCase());
const hidden = (): void => void (document.hidden && letGoOfAll());

effect(() => {
  if (!offered.value) on.value = false;
});

effect(() => {
  const one = orderRefused.value;
  if (one?.order === "nudge" && moving.peek()) refused.value = one.reason;
});

effect(() => {
  if (!on.value) return;
  claim.value = claimed;
  const timer = setInterval(tick, PERIOD);
  window.addEventListener("keyup", released, { capture: true });
  window.addEventListener("blur", letGoOfAll);
  window.addEventListener("gamepaddisconnected", letGoOfAll);
  document.addEventListener("visibilitychange", hidden);
  return () => {
    clearInterval(timer);
    claim.value = null;
    window.removeEventListener("keyup", released, { capture: true });
    window.removeEventListener("blur", letGoOfAll);
    window.removeEventListener("gamepaddisconnected", letGoOfAll);
    document.removeEventListener("visibilitychange", hidden);
    letGoOfAll();
  };
});

// A new direction is sent at once; what limited the last one says nothing of it.
effect(() => {
  const isHeld = direction.value !== "0,0,0";
  since.value = events.peek().at(-1)?.number ?? 0;
  if (isHeld) void send();
  else refused.value = "";
});
