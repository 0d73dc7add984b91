// What a recording says of the moment that is shown: path, stage, words, lines of the log.
import { computed } from "@preact/signals";
import { percent } from "../format";
import { curveOf } from "../map/curve-values";
import type { Key } from "../messages/en";
import type { Point } from "../store";
import { moment, recordedAt, replay, rowAt } from "./replay";
import { decimal, t } from "../messages/language";

const pathRow = computed(() =>
  replay.value ? rowAt(replay.value.paths, moment.value) : -1,
);
/** The path that was flown at the moment that is shown. */
export const recordedPath = computed(() => replay.value?.paths[pathRow.value] ?? null);
/** The same as a curve with heights and speeds; null of one in the plane. */
export const recordedCurve = computed(() => {
  const told = recordedPath.value;
  return told ? curveOf({ ...told, number: 0, length: 0, type: "path" }) : null;
});

const stageRow = computed(() =>
  replay.value ? rowAt(replay.value.stages, moment.value) : -1,
);
/** What the drone was doing at the moment that is shown. */
export const recordedStage = computed(() => replay.value?.stages[stageRow.value] ?? null);

/** The clock of the flight, and what the drone was doing, in words. */
export const recordedWords = computed(() => {
  const flight = replay.value;
  const then = flight ? recordedAt(flight, moment.value) : null;
  const stage = recordedStage.value;
  const goal = stage?.goal ? `, ${stage.goal}` : "";
  const doing = stage ? t(`${stage.phase}^phase` as Key) + goal : "";
  if (!then?.place) return `${doing}; ${t("nobody saw the drone")}`;
  const words = t("{high} m high, {fast} m/s, battery {p}", {
    high: decimal(then.place[2], 1),
    fast: decimal(then.speed, 1),
    p: percent(then.battery),
  });
  return `${doing}; ${words}`;
});
/** The second of the flight that is shown [Unix time]. */
export const recordedSecond = computed(() =>
  Math.floor((replay.value?.flight.started_at ?? 0) + moment.value),
);
/** The number of the last line of the log up to the moment that is shown, or -1. */
export const recordedLine = computed(() =>
  replay.value ? rowAt(replay.value.notes, moment.value) : -1,
);

/** The whole way that was flown, in parts where it was seen [m]. */
export const recordedWay = computed<Point[][]>(() => {
  const flight = replay.value;
  const parts: Point[][] = [];
  let open: Point[] | null = null;
  flight?.x.forEach((x, k) => {
    const y = flight.y[k] ?? null;
    if (x === null || y === null) {
      open = null;
      return;
    }
    if (!open) parts.push((open = []));
    const before = open.at(-1);
    if (!before || Math.hypot(x - before[0], y - before[1]) > 0.03) open.push([x, y]);
  });
  return parts;
});
