import { runs } from "../map/grid";
import { polyline, type Projection } from "../map/projection";
import type { Point } from "../store";
import type { GridView, SiteDraft } from "../wire/draft-messages";
import { change, known, view } from "./draft";
import { countOf, gripsOf, moved, type Item, type Kind } from "./items";
import { nameOfItem } from "./names";
import { Measures, Preview, type Line } from "./plan-measures";
import { rect, shapeOf } from "./plan-shapes";
import { choose, chosen, moves, remove, step, tool, TOUCHED } from "./tools";

const ARROWS: Record<string, Point> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const NUDGE = 0.05;

interface LayerProps {
  all: SiteDraft;
  to: Projection;
}

/** Everything on the plan, from the floor up. */
export function PlanLayers({ all, to, line }: LayerProps & { line: Line | null }) {
  return (
    <>
      <defs>
        <pattern
          id="hatch"
          width="7"
          height="7"
          patternUnits="userSpaceOnUse"
          patternTransform="rotate(45)"
        >
          <line class="hatch" x1="0" y1="0" x2="0" y2="7" />
        </pattern>
      </defs>
      <Floor all={all} to={to} />
      <Items all={all} to={to} kind="furniture" />
      <Items all={all} to={to} kind="zones" />
      <Items all={all} to={to} kind="walls" />
      <Items all={all} to={to} kind="pad" />
      <Items all={all} to={to} kind="places" />
      {step.value === "frame" && <Items all={all} to={to} kind="frame_points" />}
      {chosen.value && <Grips all={all} to={to} item={chosen.value} />}
      {line && <Preview line={line} to={to} />}
      <Scale to={to} />
    </>
  );
}

function Floor({ all, to }: LayerProps) {
  const shown = view.value;
  const [x0, y0, x1, y1] = all.bounds!;
  return (
    <g class="cells" aria-hidden="true">
      <rect class="floor" {...rect(to, all.bounds!)} />
      <path class="lines" d={metres(to, x0, y0, x1, y1)} />
      {shown?.grid && <path class="inflated" d={cells(shown.grid, to, "#i")} />}
      {shown?.scan && <Scan scan={shown.scan} to={to} />}
    </g>
  );
}

/** What a file brought: nobody has seen it, lower than the drone flies, as high or higher. */
function Scan({ scan, to }: { scan: GridView; to: Projection }) {
  return (
    <>
      <path class="unseen" d={cells(scan, to, "u")} />
      <path class="scan low" d={cells(scan, to, "l")} />
      <path class="scan" d={cells(scan, to, "#")} />
    </>
  );
}

/** A line each metre. */
function metres(to: Projection, x0: number, y0: number, x1: number, y1: number): string {
  const line = (a: Point, b: Point): string => polyline(to, [a, b]);
  let lines = "";
  for (let x = Math.ceil(x0 + 0.01); x < x1; x++) lines += line([x, y0], [x, y1]);
  for (let y = Math.ceil(y0 + 0.01); y < y1; y++) lines += line([x0, y], [x1, y]);
  return lines;
}

/** All cells of some letters as one SVG path. */
function cells(grid: GridView, to: Projection, letters: string): string {
  const cell = to.scale * grid.resolution;
  return runs(grid, letters)
    .map(({ i, j, width }) => {
      const [x, y] = grid.origin;
      const [u, v] = to.at([x + i * grid.resolution, y + (j + 1) * grid.resolution]);
      const [across, up] = [(width * cell).toFixed(1), cell.toFixed(1)];
      return `M${u.toFixed(1)} ${v.toFixed(1)}h${across}v${up}h-${across}z`;
    })
    .join("");
}

function Items({ all, to, kind }: LayerProps & { kind: Kind }) {
  const count = countOf(all, kind);
  return (
    <g class={`drawn ${kind}`}>
      {Array.from({ length: count }, (_, index) => (
        <Shape key={index} all={all} to={to} item={{ kind, index }} />
      ))}
    </g>
  );
}

/** One item; in its step it can be reached with Tab, moved with arrows, removed with Delete. */
function Shape({ all, to, item }: LayerProps & { item: Item }) {
  const open = chosen.value?.kind === item.kind && chosen.value.index === item.index;
  const active =
    TOUCHED[step.value].includes(item.kind) &&
    !(step.value === "objects" && tool.value === "erase");
  const press = (event: KeyboardEvent): void => {
    const by = ARROWS[event.key];
    if (by) {
      const far = NUDGE * (event.shiftKey ? 10 : 1);
      const kept = known.value;
      change(moved(kept, item, [by[0] * far, by[1] * far]), `${item.kind}.${item.index}.at`);
    } else if (event.key === "Delete" || event.key === "Backspace") remove(item);
    else if (event.key === "Enter" || event.key === " ") choose(item);
    else return;
    event.preventDefault();
  };
  const reach = active
    ? {
        tabIndex: 0,
        role: "button" as const,
        "aria-label": nameOfItem(all, item),
        "aria-pressed": open,
        onKeyDown: press,
        onFocus: () => (chosen.value = item),
      }
    : {};
  return (
    <g class="item" data-open={open} data-active={active} {...reach}>
      {shapeOf(all, to, item)}
    </g>
  );
}

function Grips({ all, to, item }: LayerProps & { item: Item }) {
  if (item.index >= countOf(all, item.kind) || !TOUCHED[step.value].includes(item.kind))
    return null;
  const round = item.kind === "places" || item.kind === "pad";
  return (
    <g class="grips" aria-hidden="true">
      {(moves() ? gripsOf(all, item) : []).map(({ at }, k) => {
        const [u, v] = to.at(at);
        if (round) return <circle key={k} cx={u} cy={v} r="7" />;
        return <rect key={k} x={u - 6} y={v - 6} width="12" height="12" />;
      })}
      <Measures all={all} to={to} item={item} />
    </g>
  );
}

function Scale({ to }: { to: Projection }) {
  return (
    <g class="scale" transform={`translate(12 ${to.height - 6})`} aria-hidden="true">
      <path d={`M0 -5v5h${to.scale}v-5`} />
      <text x={to.scale / 2} y="-4">
        1 m
      </text>
    </g>
  );
}
