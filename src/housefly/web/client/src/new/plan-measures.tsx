import type { Projection } from "../map/projection";
import { decimal } from "../messages/numbers";
import type { Point } from "../store";
import type { SiteDraft } from "../wire/draft-messages";
import { cornersOf, rectangleOf } from "./geometry";
import { type Item, type Kind } from "./items";
import { rect } from "./plan-shapes";

export interface Line {
  from: Point;
  to: Point;
  kind: Kind;
}

interface MeasuresProps {
  all: SiteDraft;
  to: Projection;
  item: Item;
}

/** How large the open item is, beside it. */
export function Measures({ all, to, item }: MeasuresProps) {
  if (item.kind === "walls") {
    const { start, end } = all.walls[item.index]!;
    return <Tag to={to} from={start} until={end} words={lengthOf(start, end)} />;
  }
  if (item.kind === "furniture") {
    const box = all.furniture[item.index]!;
    const corners = cornersOf(box);
    const low = corners.reduce((a, b) => (b[1] < a[1] ? b : a));
    const words = `${decimal(box.length, 2)} × ${decimal(box.width, 2)} m`;
    return <Tag to={to} from={[box.x, low[1]]} until={[box.x, low[1]]} words={words} below />;
  }
  return null;
}

function lengthOf(a: Point, b: Point): string {
  return `${decimal(Math.hypot(b[0] - a[0], b[1] - a[1]), 2)} m`;
}

interface TagProps {
  to: Projection;
  from: Point;
  until: Point;
  words: string;
  below?: boolean;
}

function Tag({ to, from, until, words, below = false }: TagProps) {
  const [[u0, v0], [u1, v1]] = [to.at(from), to.at(until)];
  const width = 8 * words.length + 8;
  const middle = Math.min(to.width - width / 2, Math.max(width / 2, (u0 + u1) / 2));
  const y = Math.min(to.height - 10, Math.max(12, (v0 + v1) / 2 + (below ? 18 : -18)));
  return (
    <g class="tag" transform={`translate(${middle} ${y})`}>
      <rect x={-width / 2} y="-11" width={width} height="20" rx="5" />
      <text y="4">{words}</text>
    </g>
  );
}

/** What a drag is about to draw, and how large. */
export function Preview({ line, to }: { line: Line; to: Projection }) {
  if (line.kind === "walls") {
    const [[u0, v0], [u1, v1]] = [to.at(line.from), to.at(line.to)];
    return (
      <g class="preview" aria-hidden="true">
        <line x1={u0} y1={v0} x2={u1} y2={v1} stroke-width={Math.max(2, 0.1 * to.scale)} />
        <Tag to={to} from={line.from} until={line.to} words={lengthOf(line.from, line.to)} />
      </g>
    );
  }
  const area = rectangleOf(line.from, line.to);
  const words = `${decimal(area[2] - area[0], 2)} × ${decimal(area[3] - area[1], 2)} m`;
  const low: Point = [(area[0] + area[2]) / 2, area[1]];
  return (
    <g class="preview" aria-hidden="true">
      <rect {...rect(to, area)} />
      <Tag to={to} from={low} until={low} words={words} below />
    </g>
  );
}
