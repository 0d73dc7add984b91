// Items and steps in words.
import { decimal } from "../messages/numbers";
import type { SiteDraft } from "../wire/draft-messages";
import { view } from "./draft";
import type { Item } from "./items";
import type { Key } from "./messages/en";
import { t } from "./messages/texts";
import type { Step } from "./tools";

const metres = (value: number): string => decimal(value, 2);

export function nameOfItem(all: SiteDraft, { kind, index }: Item): string {
  if (kind === "pad") return t("Pad");
  if (kind === "walls") {
    const { start, end } = all.walls[index]!;
    const length = Math.hypot(end[0] - start[0], end[1] - start[1]);
    return t("Wall {k}, {d} m", { k: index + 1, d: metres(length) });
  }
  if (kind === "furniture") return all.furniture[index]!.name;
  if (kind === "places") return all.places[index]!.title || all.places[index]!.name;
  if (kind === "zones") return all.zones[index]!.reason;
  return all.frame_points[index]!.name || t("point {k}", { k: index + 1 });
}

export const STEPS: { step: Step; title: Key; words: (all: SiteDraft) => string }[] = [
  { step: "room", title: "Room", words: roomWords },
  {
    step: "objects",
    title: "Walls and furniture",
    words: objectWords,
  },
  {
    step: "pad",
    title: "Pad",
    words: ({ pad }) =>
      pad ? t("at {x}, {y} m", { x: metres(pad[0]), y: metres(pad[1]) }) : "",
  },
  { step: "places", title: "Places", words: (all) => listed(all.places.map(titled)) },
  { step: "zones", title: "No-fly zones", words: (all) => listed(all.zones.map((z) => z.reason)) },
  { step: "tracking", title: "Tracking", words: trackingWords },
  {
    step: "frame",
    title: "Tracking frame",
    words: (all) => (all.hardware ? points(all.frame_points.length) : t("simulated")),
  },
  {
    step: "drone",
    title: "Drone",
    words: (all) => (all.hardware ? (all.drone?.model ?? "") : t("simulated")),
  },
  { step: "save", title: "Write the site", words: () => "" },
];

const titled = (place: { title: string; name: string }): string => place.title || place.name;

function roomWords(all: SiteDraft): string {
  if (!all.bounds) return "";
  const [x0, y0, x1, y1] = all.bounds;
  return t("{a} × {b} m, {h} m high", {
    a: metres(x1 - x0),
    b: metres(y1 - y0),
    h: metres(all.height),
  });
}

function objectWords(all: SiteDraft): string {
  const scanned = view.value?.scanned ?? 0;
  const n = all.furniture.length;
  const pieces = n ? [t("{n} piece|{n} pieces", { n })] : [];
  if (scanned) return [t("{n} boxes of a file", { n: scanned }), ...pieces].join(", ");
  const walls = all.walls.length;
  return [
    walls ? t("{n} wall|{n} walls", { n: walls }) : t("no walls"),
    ...(n ? pieces : [t("no furniture")]),
  ].join(", ");
}

function trackingWords(all: SiteDraft): string {
  if (!all.hardware) return t("simulated");
  return all.tracking
    ? t("{kind} at {address}", { kind: all.tracking.kind, address: all.tracking.address })
    : "";
}

function points(n: number): string {
  return n ? t("{n} point|{n} points", { n }) : t("no points");
}

function listed(names: string[]): string {
  if (names.length === 0) return t("none");
  return names.length > 3 ? `${names.slice(0, 3).join(", ")} …` : names.join(", ");
}
