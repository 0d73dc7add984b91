// The state of everything in one line of words, with a shape that says the same without colour.
import { computed } from "@preact/signals";
import { contact, flying, link, path, preflight, room, state, stateAge, type Point } from "./store";
import type { Phase, StateMessage } from "./wire/messages";

export type Shape = "ready" | "moving" | "holding" | "stopped" | "warning" | "lost";

export interface Headline {
  shape: Shape;
  text: string;
  detail: string;
}

const PILOT_TIMEOUT = 2;

function goalName(now: StateMessage): string {
  const named = room.value?.places.find((place) => place.name === now.goal_name);
  return named?.title ?? (now.goal_name || "the goal");
}

const BY_PHASE: Record<Phase, (now: StateMessage) => Headline> = {
  "idle": () =>
    flying.value
      ? { shape: "holding", text: "Hovering", detail: "waiting for an order" }
      : onThePad(),
  "taking off": () => ({ shape: "moving", text: "Taking off", detail: "" }),
  "flying to goal": (now) => ({
    shape: "moving",
    text: `Flying to ${goalName(now)}`,
    detail: left(),
  }),
  "looking": (now) => ({
    shape: "holding",
    text: `Looking at ${goalName(now)}`,
    detail: "comes home by itself",
  }),
  "holding": () => ({ shape: "holding", text: "Hovering", detail: "waiting for an order" }),
  "returning": () => ({ shape: "moving", text: "Coming home", detail: left() }),
  "landing": () => ({ shape: "moving", text: "Landing", detail: "" }),
};

export const headline = computed<Headline>(() => {
  const now = state.value;
  if (contact.value === "elsewhere")
    return {
      shape: "lost",
      text: "Opened in another tab",
      detail: "this one only watches the past",
    };
  if (contact.value === "shut out")
    return { shape: "lost", text: "Session ended", detail: "use a fresh link" };
  if (contact.value === "connecting") return { shape: "lost", text: "Connecting", detail: "" };
  if (contact.value === "lost")
    return { shape: "lost", text: "No contact", detail: "with the server" };
  if (!now) return { shape: "lost", text: "Waiting for the pilot", detail: "" };
  if (stateAge.value > PILOT_TIMEOUT)
    return { shape: "lost", text: "No contact", detail: "with the pilot" };
  if (now.status === "emergency")
    return { shape: "warning", text: "Motors are cut", detail: "reset before the next flight" };
  if (now.safety === "cut") return { shape: "warning", text: "Cutting motors", detail: now.reason };
  if (now.safety === "land")
    return { shape: "warning", text: "Landing for safety", detail: now.reason };
  if (now.safety === "stopped") {
    const where = flying.value ? "hovers until you resume" : "stays down until you resume";
    return { shape: "stopped", text: "Stopped", detail: where };
  }
  if (now.safety === "hold")
    return { shape: "warning", text: "HOLDING FOR SAFETY", detail: now.reason };
  if (now.status === null || now.status === "unknown") {
    return {
      shape: "warning",
      text: "Waiting for the drone",
      detail: link.value?.link.notes[0] ?? now.reason,
    };
  }
  return BY_PHASE[now.phase](now);
});

function onThePad(): Headline {
  const { ready, checks } = preflight.value;
  if (ready) return { shape: "ready", text: "Ready on the pad", detail: "motors are off" };
  if (checks.length === 0)
    return { shape: "holding", text: "On the pad", detail: "looking whether all is well" };
  return { shape: "warning", text: "Not ready", detail: "motors are off" };
}

/** How far and how long the current path still goes. */
function left(): string {
  const metres = distanceLeft.value;
  const speed = room.value?.limits.speed;
  if (metres === null) return "";
  return speed
    ? `${metres.toFixed(1)} m, ${Math.round(metres / speed)} s left`
    : `${metres.toFixed(1)} m left`;
}

export const distanceLeft = computed<number | null>(() => {
  const now = state.value;
  const way = path.value?.waypoints ?? [];
  if (!now?.position || way.length === 0) return null;
  const rest: Point[] = [[now.position[0], now.position[1]], ...way.slice(now.waypoint)];
  return rest
    .slice(1)
    .reduce((sum, point, k) => sum + Math.hypot(point[0] - rest[k]![0], point[1] - rest[k]![1]), 0);
});
