// What this console knows of the room, as signals; live/room-client.ts writes most of them.
import { computed, signal } from "@preact/signals";
import { now } from "../wire/clock";
import type {
  CoverageView,
  ObstacleAnswer,
  SituationAnswer,
  EventAnswer,
  PictureAnswer,
  PlacedThing,
  SensorsAnswer,
  ThingAnswer,
  WhereAnswer,
} from "../wire/room-messages";

/** A thing with the Unix time at which it was seen and at which we were told [s]. */
export interface Seen extends PlacedThing {
  seenAt: number | null;
  toldAt: number;
}

/** The answer to a search, or why there is none and what could have been meant. */
export interface Found {
  answer: WhereAnswer | null;
  problem: string;
  meant: string[];
}

export const NOTHING: Found = { answer: null, problem: "", meant: [] };

export const things = signal<ReadonlyMap<string, Seen>>(new Map());
export const situations = signal<SituationAnswer[]>([]);
export const obstacles = signal<ObstacleAnswer[]>([]);
/** Source of furniture that the tracking system sees. */
export const TRACKED = "tracking";
/** How many things are in the way that nobody put there on purpose. */
export const hindering = computed(
  () => obstacles.value.filter((one) => one.source !== TRACKED).length,
);
export const events = signal<EventAnswer[]>([]);
export const sensors = signal<SensorsAnswer | null>(null);
/** Whether somebody looks at them. */
export const wantsSensors = signal(false);
export const catalogue = signal<ThingAnswer[]>([]);
export const coverage = signal<CoverageView | null>(null);
/** Why the room is not heard, in words, or "". */
export const trouble = signal("");

/** The moment that is shown [Unix time, s]; null is now. */
export const at = signal<number | null>(null);
export const picture = signal<PictureAnswer | null>(null);
/** How far back the slider reaches [s]. */
export const span = signal(600);
/** Whose events are listed; "" is everybody's. */
export const only = signal("");
export const query = signal("");
export const found = signal<Found>(NOTHING);
export const showsCoverage = signal(false);

let offset = 0;

/** Learn the hub's clock from something it has just said. */
export function learnTime(unix: number): void {
  offset = unix - Date.now() / 1000;
}

/** The hub's Unix time [s], ticking five times a second. */
export const hubNow = computed(() => {
  void now.value;
  return Date.now() / 1000 + offset;
});
/** The moment that is shown, live or past. */
export const moment = computed(() => at.value ?? hubNow.value);

export function seen(placed: PlacedThing, toldAt: number): Seen {
  return { ...placed, toldAt, seenAt: placed.age === null ? null : toldAt - placed.age };
}

/** Everything with its place at the moment that is shown. */
export const shown = computed<Seen[]>(() => {
  if (at.value === null) return [...things.value.values()];
  const then = picture.value;
  return then ? then.things.map((placed) => seen(placed, then.at)) : [];
});

export function nameOf(id: string): string {
  return things.value.get(id)?.name ?? id;
}
