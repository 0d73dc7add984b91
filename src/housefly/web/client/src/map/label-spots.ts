// Where the words beside a mark stand: they cover neither each other nor what was placed before.
import type { Projection } from "./projection";

export interface Box {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

/** Where the first line stands, from the middle of its mark [px]. */
export interface Spot {
  x: number;
  y: number;
}

export const LINE = 13;
const [LETTER, WIDE_LETTER] = [6.4, 12];
const WIDE = /[\u1100-\u11ff\u2e80-\uffdc]/g;
const OUTSIDE_COST = 1e4;
export const FREE = 1;

/** The box [px] of a line, centred on x. */
export function boxOf(text: string, x: number, y: number): Box {
  const wide = text.match(WIDE)?.length ?? 0;
  const half = ((text.length - wide) * LETTER + wide * WIDE_LETTER) / 2 + 3;
  return { x0: x - half, y0: y - 11, x1: x + half, y1: y + 3 };
}

/** The box [px] of lines under each other, the first at (x, y), each centred on x. */
function blockOf(texts: string[], x: number, y: number): Box {
  return around(
    texts.flatMap((text, line): [number, number][] => {
      const { x0, y0, x1, y1 } = boxOf(text, x, y + line * LINE);
      return [[x0, y0], [x1, y1]];
    }),
  );
}

export function around(points: [number, number][]): Box {
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  return { x0: Math.min(...xs), y0: Math.min(...ys), x1: Math.max(...xs), y1: Math.max(...ys) };
}

/** What a box covers of others [px²]. */
export function overlap(box: Box, others: Box[]): number {
  return others.reduce((sum, other) => {
    const width = Math.min(box.x1, other.x1) - Math.max(box.x0, other.x0);
    const height = Math.min(box.y1, other.y1) - Math.max(box.y0, other.y0);
    return sum + (width > 0 && height > 0 ? width * height : 0);
  }, 0);
}

/** Below, above, right and left of a mark, then beside its corners. */
function spotsOf(texts: string[], reach: number): Spot[] {
  const side = blockOf(texts, 0, 0).x1 + reach;
  const more = (texts.length - 1) * LINE;
  const [below, above, middle] = [reach + LINE, -reach - 5 - more, 4 - more / 2];
  const beside = [side, -side].map((x) => ({ x, y: middle }));
  const corners = [side, -side].flatMap((x) => [
    { x: 0.75 * x, y: below },
    { x: 0.75 * x, y: above },
  ]);
  return [{ x: 0, y: below }, { x: 0, y: above }, ...beside, ...corners];
}

/** What a mark says, from all of it to the least; where nothing of that is free, see `isKept`. */
export interface Saying {
  at: [number, number];
  reach: number;
  choices: string[][];
  /** Whether the least is said even where it covers something. */
  isKept: boolean;
  /** Whether the words may stand on the mark itself. */
  isWithin?: boolean;
}

/** The choice that has room, and where; null where there is none. Takes the room. */
export function placed(
  { at: [u, v], reach, choices, isKept, isWithin }: Saying,
  to: Projection,
  taken: Box[],
): { choice: number; spot: Spot } | null {
  let [best, least] = [null as { choice: number; spot: Spot } | null, Infinity];
  for (const [choice, texts] of choices.entries()) {
    const spots = spotsOf(texts, reach);
    for (const spot of isWithin ? [{ x: 0, y: 4 }, ...spots] : spots) {
      const cost = costOf(blockOf(texts, u + spot.x, v + spot.y), to, taken);
      if (cost < least) [best, least] = [{ choice, spot }, cost];
    }
    if (least < FREE) break;
  }
  if (!best || (least >= FREE && !isKept)) return null;
  taken.push(blockOf(choices[best.choice]!, u + best.spot.x, v + best.spot.y));
  return best;
}

function costOf(box: Box, to: Projection, taken: Box[]): number {
  const fits = box.x0 >= 0 && box.x1 <= to.width && box.y0 >= 0 && box.y1 <= to.height;
  return overlap(box, taken) + (fits ? 0 : OUTSIDE_COST);
}
