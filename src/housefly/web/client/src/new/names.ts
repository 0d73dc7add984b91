// Items and steps in words.
import type { SiteDraft } from "../wire/draft-messages";
import { view } from "./draft";
import type { Item } from "./items";
import type { Step } from "./tools";

const metres = (value: number): string => value.toFixed(2);

export function nameOfItem(all: SiteDraft, { kind, index }: Item): string {
  if (kind === "pad") return "Pad";
  if (kind === "walls") {
    const { start, end } = all.walls[index]!;
    const length = Math.hypot(end[0] - start[0], end[1] - start[1]);
    return `Wall ${index + 1}, ${metres(length)} m`;
  }
  if (kind === "furniture") return all.furniture[index]!.name;
  if (kind === "places") return all.places[index]!.title || all.places[index]!.name;
  if (kind === "zones") return all.zones[index]!.reason;
  return all.frame_points[index]!.name || `point ${index + 1}`;
}

export const STEPS: { step: Step; title: string; words: (all: SiteDraft) => string }[] = [
  { step: "room", title: "Room", words: roomWords },
  {
    step: "objects",
    title: "Walls and furniture",
    words: objectWords,
  },
  {
    step: "pad",
    title: "Pad",
    words: (all) => (all.pad ? `at ${metres(all.pad[0])}, ${metres(all.pad[1])} m` : ""),
  },
  { step: "places", title: "Places", words: (all) => listed(all.places.map(titled)) },
  { step: "zones", title: "No-fly zones", words: (all) => listed(all.zones.map((z) => z.reason)) },
  { step: "tracking", title: "Tracking", words: trackingWords },
  {
    step: "frame",
    title: "Tracking frame",
    words: (all) => (all.hardware ? many(all.frame_points.length, "point") : "simulated"),
  },
  {
    step: "drone",
    title: "Drone",
    words: (all) => (all.hardware ? (all.drone?.address ?? "") : "simulated"),
  },
  { step: "save", title: "Write the site", words: () => "" },
];

const titled = (place: { title: string; name: string }): string => place.title || place.name;

function roomWords(all: SiteDraft): string {
  if (!all.bounds) return "";
  const [x0, y0, x1, y1] = all.bounds;
  return `${metres(x1 - x0)} × ${metres(y1 - y0)} m, ${metres(all.height)} m high`;
}

function objectWords(all: SiteDraft): string {
  const scanned = view.value?.scanned ?? 0;
  const pieces = all.furniture.length ? `, ${many(all.furniture.length, "piece")}` : "";
  if (scanned) return `${scanned} boxes of a file${pieces}`;
  return many(all.walls.length, "wall") + (pieces || ", no furniture");
}

function trackingWords(all: SiteDraft): string {
  if (!all.hardware) return "simulated";
  return all.tracking ? `${all.tracking.kind} at ${all.tracking.address}` : "";
}

function many(count: number, what: string): string {
  return `${count || "no"} ${what}${count === 1 ? "" : "s"}`;
}

function listed(names: string[]): string {
  if (names.length === 0) return "none";
  return names.length > 3 ? `${names.slice(0, 3).join(", ")} …` : names.join(", ");
}
