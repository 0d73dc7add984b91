// A flight that is looked at again: which, at what moment, and what the drone was doing then.
import { batch, computed, signal } from "@preact/signals";
import { layer } from "../back";
import { showAt } from "../live/room-client";
import { at } from "../live/store";
import { flying } from "../store";
import { fetchAsSession } from "../wire/session";
import type { FlightReplay, FlightsView, FlightView } from "../wire/room-messages";
import { t } from "../messages/language";

/** Which flights there are; null before that is known. */
export const flights = signal<FlightView[] | null>(null);
/** Why one cannot be shown, in words, or "". */
export const trouble = signal("");
export const replay = signal<FlightReplay | null>(null);
/** Whether a recording is on the screen, and not the present. */
export const replaying = computed(() => replay.value !== null);
/** The moment that is shown, since the start of the flight [s]. */
export const moment = signal(0);
export const playing = signal(false);
export const pace = signal(1);
/** Why the recording was left without anybody asking for it, in words, or "". */
export const liveAgain = signal("");

const ROOM_PERIOD = 500;
const SAID_FOR = 30_000;

async function get<T>(path: string): Promise<T> {
  const answer = await fetchAsSession(path).catch(() => {
    throw new Error("no contact with the server");
  });
  const tree = (await answer.json().catch(() => ({}))) as T & { error?: string };
  if (!answer.ok) throw new Error(tree.error ?? answer.statusText);
  return tree;
}

/** Ask which flights there are. */
export async function askFlights(): Promise<void> {
  try {
    flights.value = (await get<FlightsView>("/flights")).flights;
  } catch {
    flights.value = null; // no flights are kept here, or no contact: the headline says that
  }
}

/** Why no recording can be opened now, in words, or "". */
export const replayObjection = computed(() =>
  flying.value ? t("The drone may be in the air: what is live stays on the screen.") : "",
);

let asked = "";

/** Show a flight from its start. */
export async function openFlight(id: string): Promise<void> {
  if (replayObjection.peek()) {
    trouble.value = replayObjection.peek();
    return;
  }
  asked = id;
  try {
    const found = await get<FlightReplay>(`/flights/${id}`);
    // Somebody may have chosen another, or have taken off, meanwhile.
    if (asked !== id || replayObjection.peek()) return;
    batch(() => {
      trouble.value = "";
      liveAgain.value = "";
      replay.value = found;
      pace.value = 1;
      playing.value = false;
    });
    show(0);
  } catch (error) {
    trouble.value = (error as Error).message;
  }
}

let roomShown = 0;

/** Show a moment of the flight [s since its start]. */
export function show(time: number): void {
  const now = replay.peek();
  if (!now) return;
  moment.value = Math.max(0, Math.min(now.flight.duration, time));
  // People and things follow, twice a second: each moment of theirs is asked of the server.
  if (performance.now() - roomShown < ROOM_PERIOD) return;
  roomShown = performance.now();
  showAt(now.flight.started_at + moment.peek());
}

let last = 0;

function step(at: number): void {
  const now = replay.peek();
  if (!now || !playing.peek()) return;
  const time = moment.peek() + ((at - last) / 1000) * pace.peek();
  last = at;
  show(time);
  if (time >= now.flight.duration) playing.value = false;
  else requestAnimationFrame(step);
}

export function play(): void {
  const now = replay.peek();
  if (!now || playing.peek()) return;
  if (moment.peek() >= now.flight.duration) show(0);
  playing.value = true;
  last = performance.now();
  requestAnimationFrame(step);
}

export function pause(): void {
  playing.value = false;
}

/** Go back to the present; the reason is said where nobody asked for it. */
export function closeFlight(reason = ""): void {
  asked = "";
  if (!replay.peek() && at.peek() === null) return;
  batch(() => {
    replay.value = null;
    playing.value = false;
    moment.value = 0;
    liveAgain.value = reason;
    showAt(null);
  });
  if (reason)
    setTimeout(() => liveAgain.peek() === reason && (liveAgain.value = ""), SAID_FOR);
}

layer(
  () => replaying.value || at.value !== null,
  () => closeFlight(),
);

/** The number of the last row whose time is not after a moment [s]; -1 before the first. */
export function rowAt(times: { t: number }[] | number[], time: number): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    const one = times[middle]!;
    if ((typeof one === "number" ? one : one.t) <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export interface Recorded {
  place: [number, number, number] | null;
  yaw: number;
  speed: number;
  battery: number;
}

const GAP = 0.5;

/** Where the drone was at a moment, between two samples that are not far apart. */
export function recordedAt(flight: FlightReplay, time: number): Recorded | null {
  const row = rowAt(flight.t, time);
  if (row < 0) return null;
  const next = Math.min(row + 1, flight.t.length - 1);
  const span = flight.t[next]! - flight.t[row]!;
  const share = span > 0 && span < GAP ? Math.min(1, (time - flight.t[row]!) / span) : 0;
  const mix = (values: (number | null)[]): number | null => {
    const [a, b] = [values[row] ?? null, values[next] ?? null];
    return a === null || b === null ? a : a + share * (b - a);
  };
  const [x, y, z] = [mix(flight.x), mix(flight.y), mix(flight.z)];
  const isOld = time - flight.t[row]! > GAP && row < flight.t.length - 1;
  const turn = flight.yaw[next]! - flight.yaw[row]!;
  const turned = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
  return {
    place: x === null || y === null || z === null || isOld ? null : [x, y, z],
    yaw: flight.yaw[row]! + share * turned,
    speed: mix(flight.speed) ?? 0,
    battery: flight.battery[row]!,
  };
}
