// The room's data while its screen is open: questions over HTTP, changes over a WebSocket.
import { batch } from "@preact/signals";
import type {
  CoverageView,
  EventsAnswer,
  FeedAnswer,
  EventAnswer,
  PictureAnswer,
  PlacedThing,
  RoomAnswer,
  RoomNews,
  SensorsAnswer,
  ThingsAnswer,
  WhereAnswer,
} from "../wire/room-messages";
import { suggestions } from "./suggestions";
import { openSocket } from "../wire/open-socket";
import { fetchAsSession } from "../wire/session";
import * as store from "./store";

const API = "/api/v1";
const PERIOD = 1000;
const DEBOUNCE = 120;
const EVENTS_KEPT = 500;
const RECENT = 100;
/** A memory that does not answer is asked less often [ticks]. */
const RESTS = 2;
/** How often sensors are asked for that nobody looks at [ticks]. */
const HEARD_EVERY = 3;

async function get<T extends RoomAnswer>(
  path: string,
  parameters: Record<string, string | number> = {},
): Promise<T> {
  const text = new URLSearchParams(
    Object.entries(parameters).map(([key, value]) => [key, String(value)]),
  );
  const answer = await fetchAsSession(`${path}?${text}`).catch(() => {
    throw new Error("no contact with the server");
  });
  // An address that the server does not have is answered with a page.
  const tree = (await answer.json().catch(() => ({}))) as T & { error?: string };
  if (!answer.ok) throw new Error(tree.error ?? answer.statusText);
  return tree;
}

/** Listen to the room until the returned function is called. */
export function listen(): () => void {
  let closed = false;
  let again = 0;
  let line: WebSocket;
  const open = (): void => {
    line = openSocket(`${API}/watch`);
    line.onopen = () => void begin();
    line.onmessage = (event: MessageEvent<string>) => receive(JSON.parse(event.data) as RoomNews);
    line.onclose = () => {
      if (!closed) again = window.setTimeout(open, PERIOD);
    };
  };
  open();
  const ticking = setInterval(() => void tick(), PERIOD);
  void tick();
  return () => {
    closed = true;
    clearTimeout(again);
    clearInterval(ticking);
    line.close();
  };
}

/** Fetch everything that has a place; the socket sends changes from then on. */
async function begin(): Promise<void> {
  try {
    const [now, all] = await Promise.all([
      get<PictureAnswer>(`${API}/picture`),
      get<ThingsAnswer>(`${API}/things`),
    ]);
    batch(() => {
      store.learnTime(now.at);
      merge(now.things, now.at);
      store.situations.value = now.situations;
      store.obstacles.value = now.obstacles;
      store.catalogue.value = all.things;
      store.trouble.value = "";
    });
    await askEvents();
  } catch (error) {
    store.trouble.value = (error as Error).message;
  }
}

let heardAt = 0;

function receive(news: RoomNews): void {
  heardAt = Date.now();
  batch(() => {
    store.learnTime(news.at);
    merge(news.things, news.at);
    store.situations.value = news.situations;
    store.obstacles.value = news.obstacles;
    // The socket may repeat an event that was just fetched.
    const known = new Set(store.events.value.slice(-RECENT).map(keyOf));
    const fresh = news.events.filter(
      (event) =>
        (!store.only.value || event.thing === store.only.value) && !known.has(keyOf(event)),
    );
    if (fresh.length) store.events.value = [...store.events.value, ...fresh].slice(-EVENTS_KEPT);
  });
}

export function keyOf(event: EventAnswer): string {
  return `${event.at} ${event.kind} ${event.thing}`;
}

function merge(placed: PlacedThing[], toldAt: number): void {
  const known = new Map(store.things.value);
  for (const one of placed) {
    if ((known.get(one.thing)?.toldAt ?? 0) <= toldAt)
      known.set(one.thing, store.seen(one, toldAt));
  }
  store.things.value = known;
}

let ticks = false;
let rests = 0;
let beats = 0;

async function tick(): Promise<void> {
  if (ticks || rests-- > 0) return;
  ticks = true;
  rests = 0;
  try {
    // A memory that has fallen silent is noticed by that, too.
    if (store.wantsSensors.peek() || ++beats % HEARD_EVERY === 0)
      store.sensors.value = await get<SensorsAnswer>(`${API}/sensors`);
    if (store.trouble.value) await begin();
    if (store.at.value === null && store.found.value.answer) await refind();
  } catch (error) {
    // Who still tells news is there, even if a question was too slow.
    if (Date.now() - heardAt > 3 * PERIOD) store.trouble.value = (error as Error).message;
  }
  if (store.trouble.value) rests = RESTS;
  ticks = false;
}

// --- the past

let pending = 0;
let asking = false;

/** Show the room at a time in the past [Unix time, s]; null goes back to now. */
export function showAt(time: number | null): void {
  store.at.value = time;
  clearTimeout(pending);
  if (time !== null) pending = window.setTimeout(() => void askPicture(), DEBOUNCE);
  else
    batch(() => {
      store.picture.value = null;
      void refind();
    });
}

async function askPicture(): Promise<void> {
  const time = store.at.value;
  if (asking || time === null) return;
  asking = true;
  try {
    const then = await get<PictureAnswer>(`${API}/picture`, { at: time.toFixed(3) });
    if (store.at.value !== null) store.picture.value = then;
    await refind();
  } catch (error) {
    store.trouble.value = (error as Error).message;
  }
  asking = false;
  if (store.at.value !== time) void askPicture();
}

/** Ask for what happened in the span of the slider. */
export async function askEvents(): Promise<void> {
  const since = Math.max(0, store.moment.value - store.span.value);
  const thing: Record<string, string> = store.only.value ? { thing: store.only.value } : {};
  const { events } = await get<EventsAnswer>(`${API}/events`, {
    since: since.toFixed(3),
    limit: EVENTS_KEPT,
    ...thing,
  });
  // What happened while the answer was on its way is not in it.
  const last = events.at(-1)?.at ?? since;
  const newer = store.events.value.filter(
    (one) => one.at > last && (!store.only.value || one.thing === store.only.value),
  );
  store.events.value = [...events, ...newer];
}

/** Ask what happened in the day before a time, grouped by what it is about; null is now. */
export const feed = (of: string, limit: number, until: number | null): Promise<FeedAnswer> =>
  get(`${API}/feed`, { of, limit, ...(until === null ? {} : { until }) });

// --- search

/** Find a thing by what people call it. */
export async function find(words: string): Promise<void> {
  const wanted = words.trim();
  unfind();
  store.query.value = wanted;
  if (wanted) await where(wanted);
}

/** Nothing is searched for any more. */
export function unfind(): void {
  turn += 1;
  store.query.value = "";
  store.found.value = store.NOTHING;
}

/** Ask again, about the same thing: it may have moved, or the time that is shown. */
async function refind(): Promise<void> {
  if (store.query.value) await where(store.found.value.answer?.thing ?? store.query.value);
}

let turn = 0;

/** Only the newest question is answered, whatever order the answers come in. */
async function where(thing: string): Promise<void> {
  const time: Record<string, string> =
    store.at.value === null ? {} : { at: store.at.value.toFixed(3) };
  const mine = ++turn;
  let found = store.NOTHING;
  // A name is one part of an address: a stroke in it would be two.
  const path = `${API}/where/${encodeURIComponent(thing.replace(/[\\/]+/g, " "))}`;
  try {
    found = { ...found, answer: await get<WhereAnswer>(path, time) };
  } catch (error) {
    const meant = suggestions(thing, store.catalogue.value);
    found = { ...found, problem: (error as Error).message, meant };
  }
  if (mine === turn) store.found.value = found;
}

/** Fetch what the tracking cameras see; it stays the same while the house runs. */
export async function learnCoverage(): Promise<void> {
  if (store.coverage.value) return;
  try {
    store.coverage.value = await get<CoverageView>("/coverage");
  } catch {
    store.coverage.value = null; // no cameras are known here
  }
}

export async function toggleCoverage(): Promise<void> {
  store.showsCoverage.value = !store.showsCoverage.value;
  if (store.coverage.value || !store.showsCoverage.value) return;
  try {
    store.coverage.value = await get<CoverageView>("/coverage");
  } catch (error) {
    store.showsCoverage.value = false;
    store.trouble.value = (error as Error).message;
  }
}
