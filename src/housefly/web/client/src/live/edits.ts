// Places and zones as they are being edited; nothing leaves the browser before Save.
import { batch, computed, effect, signal } from "@preact/signals";
import { iFly, room, verdict } from "../store";
import { fetchAsSession } from "../wire/session";
import { tab } from "../wire/socket";
import type { EditsView, PlaceView, ZoneView } from "../wire/room-messages";
import { showAt } from "./room-client";
import type { Point } from "../store";
import { t, translated } from "../messages/language";
import { capital } from "../format";

export interface Chosen {
  kind: "places" | "zones";
  index: number;
}

interface Trouble {
  words: string;
  /** The item it is about; null is all of them. */
  item: Chosen | null;
}

const STEP = 20;
const AHEAD = 1.5;
const ZONE = 1;

export const saved = signal<EditsView | null>(null);
export const places = signal<PlaceView[]>([]);
export const zones = signal<ZoneView[]>([]);
export const chosen = signal<Chosen | null>(null);
export const trouble = signal<Trouble | null>(null);
export const said = signal("");
/** What a touch of the map sets while a place is open. */
export const aims = signal<"viewpoint" | "look_at">("viewpoint");
export const busy = signal(false);

export const changed = computed(
  () =>
    saved.value !== null &&
    JSON.stringify([places.value, zones.value]) !==
      JSON.stringify([saved.value.places, saved.value.zones]),
);

const DRAFT_KEY = "housefly draft";

interface Draft {
  saved: EditsView;
  places: PlaceView[];
  zones: ZoneView[];
}

/** What was edited and not saved is still there, after a reload too; else what the server has. */
export function beginEditing(): void {
  showAt(null);
  if (changed.value) return;
  const draft = keptDraft();
  if (draft)
    batch(() => {
      saved.value = draft.saved;
      places.value = draft.places;
      zones.value = draft.zones;
      said.value = t("These changes were not saved before. Save or Discard them.");
    });
  else void load();
}

function keptDraft(): Draft | null {
  try {
    const draft = JSON.parse(sessionStorage.getItem(DRAFT_KEY) ?? "null") as Draft | null;
    return draft?.saved && Array.isArray(draft.places) && Array.isArray(draft.zones) ? draft : null;
  } catch {
    return null;
  }
}

effect(() => {
  const view = saved.value;
  if (!view) return;
  const draft: Draft = { saved: view, places: places.value, zones: zones.value };
  if (changed.value) sessionStorage.setItem(DRAFT_KEY, JSON.stringify(draft));
  else sessionStorage.removeItem(DRAFT_KEY);
});

/** Why this page may change nothing here, or "": the server refuses the same at Save. */
export const editObjection = computed(() => {
  if (iFly.value) return "";
  const who = verdict.value?.control;
  return who
    ? t("{who} has control, and only who has control may change the room.", { who })
    : t("Take control first: only who has control may change the room.");
});

/** Take what the server has; unsaved changes are gone. */
export function load(): Promise<void> {
  return ask("/edits", null, () => "");
}

export function save(): Promise<void> {
  const view = saved.value;
  if (!view) return Promise.resolve();
  const nameless = places.value.findIndex((place) => !place.title.trim());
  if (nameless >= 0)
    return Promise.resolve(
      complain(t("Give this place a name."), { kind: "places", index: nameless }),
    );
  const own = new Map(view.own.map((place) => [place.name, JSON.stringify(place)]));
  const named = withNames(places.value);
  const sent = named.filter((place) => own.get(place.name) !== JSON.stringify(place));
  const removed = view.own
    .map((place) => place.name)
    .filter((name) => !named.some((place) => place.name === name));
  const item = (words: string): Chosen | null => {
    const [kind, index] = words.split(".");
    if (kind === "zones") return { kind, index: Number(index) };
    return kind === "places" && sent[Number(index)]
      ? { kind, index: named.indexOf(sent[Number(index)]!) }
      : null;
  };
  const body = {
    based_on: view.version,
    tab: tab(),
    edits: { places: sent, removed, zones: zones.value },
  };
  return ask("/edits", body, (fresh) => `Saved as version ${fresh.version}.`, item);
}

export function undo(): Promise<void> {
  return ask(
    "/edits/undo",
    { based_on: saved.value?.version ?? 0, tab: tab() },
    (fresh) => `Undone; this is version ${fresh.version}.`,
  );
}

/** Give the newest version to the drone, which stands; its pilot starts again. */
export function putIntoUse(): Promise<void> {
  const body = { based_on: saved.value?.version ?? 0, tab: tab() };
  return ask("/edits/use", body, () => "");
}

/** Say what became of it. */
export function tell(words: string): void {
  batch(() => {
    said.value = words;
    trouble.value = null;
  });
}

async function ask(
  path: string,
  body: unknown,
  done: (fresh: EditsView) => string,
  item: (words: string) => Chosen | null = () => null,
): Promise<void> {
  if (busy.value) return;
  busy.value = true;
  try {
    const post = body ? { method: "POST", body: JSON.stringify(body) } : {};
    const answer = await fetchAsSession(path, post);
    const tree = (await answer.json()) as EditsView & { error?: string; item?: string };
    if (answer.ok) accept(tree, done(tree));
    else complain(translated(tree.error ?? answer.statusText), item(tree.item ?? ""));
  } catch {
    complain(t("No contact with the server."), null);
  }
  busy.value = false;
}

function accept(fresh: EditsView, words: string): void {
  batch(() => {
    saved.value = fresh;
    places.value = fresh.places;
    zones.value = fresh.zones;
    chosen.value = null;
    trouble.value = null;
    said.value = [words, translated(fresh.words)].filter(Boolean).join(" ");
  });
}

function complain(words: string, item: Chosen | null): void {
  batch(() => {
    trouble.value = { words: capital(words), item };
    said.value = "";
    if (item) chosen.value = item;
  });
}

/** New places get the name that commands know them by from what people call them. */
function withNames(all: PlaceView[]): PlaceView[] {
  const taken = new Set([
    ...all.map((place) => place.name),
    ...saved.value!.own.map((place) => place.name),
  ]);
  return all.map((place) => {
    if (place.name) return place;
    const plain =
      place.title
        .normalize("NFKD")
        .toLowerCase()
        .replace(/[^a-z0-9]+/g, "-")
        .replace(/^-+|-+$/g, "")
        .slice(0, 36) || "place";
    let name = plain;
    for (let k = 2; taken.has(name); k++) name = `${plain}-${k}`;
    taken.add(name);
    return { ...place, name };
  });
}

// --- changing the draft

function rounded(value: number): number {
  return Math.round(value * STEP) / STEP;
}

function inside([x, y]: Point): Point {
  const [x0, y0, x1, y1] = room.value!.bounds;
  return [rounded(Math.min(x1, Math.max(x0, x))), rounded(Math.min(y1, Math.max(y0, y)))];
}

export function choose(item: Chosen | null): void {
  if (item && editObjection.peek()) return;
  batch(() => {
    chosen.value = item;
    aims.value = "viewpoint";
  });
}

/** A new place; it looks away from the middle of the room, where things stand. */
export function addPlace(at: Point): void {
  if (editObjection.peek()) return;
  const [x0, y0, x1, y1] = room.value!.bounds;
  const viewpoint = inside(at);
  const [dx, dy] = [viewpoint[0] - (x0 + x1) / 2, viewpoint[1] - (y0 + y1) / 2];
  const scale = AHEAD / (Math.hypot(dx, dy) || 1);
  const [u, v] = inside([viewpoint[0] + scale * (dx || 1), viewpoint[1] + scale * dy]);
  places.value = [
    ...places.value,
    { name: "", title: "", viewpoint, look_at: [u, v, room.value!.flight_height] },
  ];
  choose({ kind: "places", index: places.value.length - 1 });
}

export function addZone(a: Point, b: Point): void {
  if (editObjection.peek()) return;
  zones.value = [...zones.value, { rectangle: rectangle(a, b), reason: "" }];
  choose({ kind: "zones", index: zones.value.length - 1 });
}

/** A place or a zone in the middle of the room, for those who have no pointer. */
export function addInTheMiddle(kind: Chosen["kind"]): void {
  const [x0, y0, x1, y1] = room.value!.bounds;
  const [x, y]: Point = [(x0 + x1) / 2, (y0 + y1) / 2];
  if (kind === "places") addPlace([x, y]);
  else addZone([x - ZONE / 2, y - ZONE / 2], [x + ZONE / 2, y + ZONE / 2]);
}

export function rectangle(a: Point, b: Point): ZoneView["rectangle"] {
  const [p, q] = [inside(a), inside(b)];
  return [Math.min(p[0], q[0]), Math.min(p[1], q[1]), Math.max(p[0], q[0]), Math.max(p[1], q[1])];
}

export function setPlace(index: number, change: Partial<PlaceView>): void {
  if (editObjection.peek()) return;
  places.value = places.value.map((place, k) => (k === index ? { ...place, ...change } : place));
}

export function setZone(index: number, change: Partial<ZoneView>): void {
  if (editObjection.peek()) return;
  zones.value = zones.value.map((zone, k) => (k === index ? { ...zone, ...change } : zone));
}

export function remove({ kind, index }: Chosen): void {
  if (editObjection.peek()) return;
  batch(() => {
    if (kind === "places") places.value = places.value.filter((_, k) => k !== index);
    else zones.value = zones.value.filter((_, k) => k !== index);
    chosen.value = null;
    trouble.value = null;
  });
}

/** Move what the open place aims with. */
export function aim(index: number, at: Point): void {
  const [x, y] = inside(at);
  const place = places.value[index]!;
  if (aims.value === "viewpoint") setPlace(index, { viewpoint: [x, y] });
  else setPlace(index, { look_at: [x, y, place.look_at[2]] });
}
