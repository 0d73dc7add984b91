// What this console knows, as signals. Only wire/socket.ts writes the first block.
import { computed, signal } from "@preact/signals";
import { layer } from "./back";
import type { Trail } from "./trail";
import { now } from "./wire/clock";
import type {
  OrderRefused,
  EventView,
  LinkMessage,
  PathMessage,
  PreflightView,
  Role,
  RoomView,
  StateMessage,
  ConsoleVerdict,
  ViewersMessage,
} from "./wire/messages";

export type Contact = "connecting" | "open" | "lost" | "elsewhere" | "shut out";
export type Point = [number, number];

export const contact = signal<Contact>("connecting");
export const me = signal(0);
/** What this browser may do. */
export const role = signal<Role>("watch");
/** Whether the room is simulated: then things may be done to it. */
export const simulated = signal(false);
/** One-time links of this page that were used, by name. */
export const usedInvitations = signal<ReadonlySet<string>>(new Set());
/** All that headline, banner and buttons say of the drone. */
export const verdict = signal<ConsoleVerdict | null>(null);
/** Whether there is a drone at all; else the room is watched, and nothing here flies. */
export const hasDrone = computed(() => verdict.value?.has_drone ?? true);
export const state = signal<StateMessage | null>(null);
export const room = signal<RoomView | null>(null);
export const preflight = signal<PreflightView>({ ready: false, checks: [] });
export const path = signal<PathMessage | null>(null);
export const link = signal<LinkMessage | null>(null);
export const viewers = signal<ViewersMessage>({ pilot: null, viewers: [], type: "viewers" });
export const events = signal<EventView[]>([]);
export const trail = signal<Trail>([]);
export const notice = signal("");
/** The last order of this page that the pilot refused. */
export const orderRefused = signal<OrderRefused | null>(null);

/** Whether the picture is large and the map small; scene/stage.ts sets it, and a person. */
export const swapped = signal(false);
/** The screen that is open; the address keeps it over a reload. */
export type Screen = "live" | "edit" | "tasks";
const addressed = (): Screen =>
  /^#(room|edit)/.test(location.hash)
    ? "edit"
    : /^#(tasks|clip\/)/.test(location.hash)
      ? "tasks"
      : "live";
export const screen = signal<Screen>(addressed());
window.addEventListener("hashchange", () => (screen.value = addressed()));

export function open(name: Screen): void {
  screen.value = name;
  panel.value = "";
  history.replaceState(history.state, "", name === "live" ? location.pathname : `#${name}`);
}

export type Panel =
  | ""
  | "help"
  | "control"
  | "invite"
  | "checks"
  | "more"
  | "side"
  | "ask"
  | "fly"
  | "tasks"
  | "past";
export const panel = signal<Panel>("");

layer(
  () => screen.value !== "live",
  () => open("live"),
);
layer(
  () => panel.value !== "",
  () => (panel.value = ""),
);

export function toggle(name: Panel): void {
  panel.value = panel.value === name ? "" : name;
}

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

export const stateFreshness = computed(() => freshness(stateAge.value));

/** Time since the server's last verdict [s]; it sends one twice a second. */
export const silence = computed(() =>
  verdict.value ? Math.max(0, now.value - verdict.value.at) : Infinity,
);
/** Whether what the verdict says is of now. */
export const lineLives = computed(() => contact.value === "open" && silence.value < DEAD);

/** Time since tracking saw the drone [s]. */
export const poseAge = computed(() => (state.value?.pose_age ?? Infinity) + stateAge.value);

export const poseFreshness = computed(() => freshness(poseAge.value));

/** Whether one must reckon with a drone in the air. */
export const flying = computed(() => verdict.value?.may_be_airborne ?? false);
export const cut = computed(() => verdict.value?.is_cut ?? false);

/** What became of the STOP that was pressed on this page, until the server's word of it. */
export const stopPress = signal<{ state: "" | "sending" | "failed"; words: string }>({
  state: "",
  words: "",
});

export const iFly = computed(() => me.value !== 0 && verdict.value?.pilot === me.value);
