import { stop } from "../commands";
import { flying, stopped } from "../store";
import { StopIcon } from "./icons";

/** STOP: always there, always in the same place, one press, for everybody. */
export function StopBar() {
  const latched = stopped.value;
  const then = latched
    ? flying.value
      ? "The drone hovers and takes no orders until Resume is held"
      : "The drone takes no orders until Resume is held"
    : "hover at once and stay";
  return (
    <footer class="stopbar">
      <button
        type="button"
        class="stop"
        data-latched={latched}
        onPointerDown={press}
        onClick={click}
      >
        <StopIcon />
        <strong>{latched ? "STOPPED" : "STOP"}</strong>
        <span class="then">{then}</span>
        <kbd>Space</kbd>
      </button>
    </footer>
  );
}

// STOP acts when the finger comes down; the click that follows must not send it twice.
let pressed = false;

function press(event: PointerEvent): void {
  if (event.button !== 0) return;
  pressed = true;
  void stop();
}

function click(): void {
  if (!pressed) void stop();
  pressed = false;
}
