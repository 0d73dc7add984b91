// What this console knows, as signals. Only wire/socket.ts writes the first block.
import { computed, signal } from "@preact/signals";
import { now } from "./wire/clock";
import type {
  DroneStatus,
  EventView,
  LinkMessage,
  PathMessage,
  PreflightView,
  RoomView,
  StateMessage,
  ViewersMessage,
} from "./wire/messages";

export type Contact = "connecting" | "open" | "lost" | "elsewhere" | "shut out";
export type Point = [number, number];

export const contact = signal<Contact>("connecting");
export const me = signal(0);
export const state = signal<StateMessage | null>(null);
export const room = signal<RoomView | null>(null);
export const preflight = signal<PreflightView>({ ready: false, checks: [] });
export const path = signal<PathMessage | null>(null);
export const link = signal<LinkMessage | null>(null);
export const viewers = signal<ViewersMessage>({ pilot: null, viewers: [], type: "viewers" });
export const events = signal<EventView[]>([]);
export const trail = signal<Point[]>([]);
export const notice = signal("");

/** Which of the two views is large; and on a narrow screen, which are shown. */
export const swapped = signal(false);
/** The screen that is open; the address keeps it over a reload. */
export type Screen = "fly" | "room" | "tasks";
export const screen = signal<Screen>(
  location.hash === "#room" ? "room" : /^#(tasks|clip\/)/.test(location.hash) ? "tasks" : "fly",
);

export function open(name: Screen): void {
  screen.value = name;
  history.replaceState(null, "", name === "fly" ? location.pathname : `#${name}`);
}

export const panel = signal<"" | "help" | "control" | "checks">("");

const OLD = 0.5;
const DEAD = 2;
export type Freshness = "fresh" | "old" | "dead";

/** Time since the server heard of the newest state [s]. */
export const stateAge = computed(() =>
  state.value ? Math.max(0, now.value - state.value.heard_at) : Infinity,
);

export function freshness(age: number): Freshness {
  return age < OLD ? "fresh" : age < DEAD ? "old" : "dead";
}

/** Whether what is on the screen is the drone's present. */
export const inContact = computed(() => contact.value === "open" && stateAge.value < DEAD);

const ON_THE_GROUND: (DroneStatus | null)[] = [null, "unknown", "landed", "emergency"];
export const flying = computed(
  () => state.value !== null && !ON_THE_GROUND.includes(state.value.status),
);
export const stopped = computed(() => state.value?.safety === "stopped");
export const cut = computed(
  () => state.value?.status === "emergency" || state.value?.safety === "cut",
);

export const iFly = computed(() => me.value !== 0 && viewers.value.pilot === me.value);

export function nameOf(viewer: number | null): string {
  return viewers.value.viewers.find((one) => one.id === viewer)?.name ?? "somebody who left";
}
