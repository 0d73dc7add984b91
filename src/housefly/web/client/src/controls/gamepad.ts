// A gamepad's two sticks as a push: left along the map, right up and down; B hovers.
import type { Push } from "./nudge-input";

const DEAD_ZONE = 0.2;
const B_BUTTON = 1;
/** Left and right, down and up of the left stick; down and up of the right one. */
const [ASIDE, ALONG, CLIMB] = [0, 1, 3];

/** A stick that was pushed already when moving began must be let go first. */
let isFree = false;
let wasPressed = false;

export function forgetGamepad(): void {
  isFree = false;
}

function beyond(value: number): number {
  const size = Math.abs(value);
  if (!(size > DEAD_ZONE)) return 0;
  return (Math.sign(value) * (Math.min(size, 1) - DEAD_ZONE)) / (1 - DEAD_ZONE);
}

/** What the first gamepad asks for now; calls `onB` when its B is pressed. */
export function gamepadPush(onB: () => void): Push {
  const pad = navigator.getGamepads?.().find((one) => one?.connected);
  if (!pad) {
    forgetGamepad();
    return [0, 0, 0];
  }
  const isPressed = pad.buttons[B_BUTTON]?.pressed ?? false;
  if (isPressed && !wasPressed) onB();
  wasPressed = isPressed;
  // Pages and sticks count down as positive.
  const read = (axis: number): number => beyond(pad.axes[axis] ?? 0);
  const push: Push = [read(ASIDE!), -read(ALONG!) || 0, -read(CLIMB!) || 0];
  const isStill = push.every((part) => part === 0);
  isFree ||= isStill;
  return isFree && !isPressed ? push : [0, 0, 0];
}
