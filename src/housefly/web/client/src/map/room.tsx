import { computed } from "@preact/signals";
import { room, state } from "../store";
import type { GridView, OutlineView, PlaceView, RoomView } from "../wire/messages";
import { runs } from "./grid";
import { polyline, type Projection } from "./projection";

const LETTER_PX = 6.2;
const WALLS = /wall|partition|pillar|column/;
const GRID_LINES_FROM = 13;

/** Everything that does not move: cells, furniture with names, places, home, scale. */
export function RoomLayer({ to }: { to: Projection }) {
  const view = room.value;
  if (!view) return null;
  return (
    <g class="room">
      <Floor view={view} to={to} />
      <Furniture view={view} to={to} />
      <Cells grid={view.grid} to={to} />
      <Names view={view} to={to} />
      <HomePad view={view} to={to} />
      {view.places.map((place) => place.name !== "home" && <Place key={place.name} place={place} to={to} />)}
      <Visitors to={to} />
      <Scale to={to} />
    </g>
  );
}

interface RoomProps {
  view: RoomView;
  to: Projection;
}

function Floor({ view, to }: RoomProps) {
  const [x0, y0, x1, y1] = view.bounds;
  const [u, v] = to.at([x0, y1]);
  return <rect class="floor" x={u} y={v} width={to.scale * (x1 - x0)} height={to.scale * (y1 - y0)} rx="3" />;
}

function Cells({ grid, to }: { grid: GridView; to: Projection }) {
  const cell = to.scale * grid.resolution;
  const shape = (letter: string): string =>
    runs(grid, letter)
      .map(({ i, j, width }) => {
        const [u, v] = to.at([grid.origin[0] + i * grid.resolution, grid.origin[1] + (j + 1) * grid.resolution]);
        return `M${u.toFixed(2)} ${v.toFixed(2)}h${(width * cell).toFixed(2)}v${cell.toFixed(2)}h${(-width * cell).toFixed(2)}z`;
      })
      .join("");
  return (
    <g class="cells">
      <defs>
        <pattern id="hatch" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
          <line class="hatch" x1="0" y1="0" x2="0" y2="7" />
        </pattern>
      </defs>
      {cell >= GRID_LINES_FROM && <path class="lines" d={lines(grid, to)} />}
      <path class="inflated" d={shape("i")} />
      <path class="occupied" d={shape("#")} />
      <path class="virtual" d={shape("v")} />
    </g>
  );
}

function lines(grid: GridView, to: Projection): string {
  const at = (i: number, j: number): string =>
    to.at([grid.origin[0] + i * grid.resolution, grid.origin[1] + j * grid.resolution]).map((value) => value.toFixed(1)).join(" ");
  const along = Array.from({ length: grid.width + 1 }, (_, i) => `M${at(i, 0)}L${at(i, grid.height)}`);
  const across = Array.from({ length: grid.height + 1 }, (_, j) => `M${at(0, j)}L${at(grid.width, j)}`);
  return [...along, ...across].join("");
}

function Furniture({ view, to }: RoomProps) {
  const sorted = [...view.outlines].sort((a, b) => a.top - b.top);
  return (
    <g class="furniture">
      {sorted.map((outline, k) => (
        <path
          key={k}
          class={kind(outline, view)}
          d={polyline(to, outline.corners, true)}
          style={WALLS.test(outline.thing) ? {} : { "--own": outline.colour }}
        />
      ))}
    </g>
  );
}

/** Walls, things lower than the drone flies, and things that stand in its way look different. */
function kind(outline: OutlineView, view: RoomView): string {
  if (WALLS.test(outline.thing)) return "wall";
  if (outline.top < 0.05) return "flat";
  return outline.top < view.flight_height - 0.3 ? "low" : "tall";
}

interface Box {
  name: string;
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

/** One name a thing, where the thing is wide enough for it. */
function Names({ view, to }: RoomProps) {
  const boxes = new Map<string, Box>();
  for (const outline of view.outlines) {
    if (WALLS.test(outline.thing)) continue;
    const box = boxes.get(outline.thing) ?? { name: outline.thing, x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
    for (const corner of outline.corners) {
      const [u, v] = to.at(corner);
      box.x0 = Math.min(box.x0, u);
      box.x1 = Math.max(box.x1, u);
      box.y0 = Math.min(box.y0, v);
      box.y1 = Math.max(box.y1, v);
    }
    boxes.set(outline.thing, box);
  }
  return (
    <g class="names" aria-hidden="true">
      {[...boxes.values()].map((box) => {
        const text = plain(box.name);
        const long = text.length * LETTER_PX;
        if (long > box.x1 - box.x0 + 6 || box.y1 - box.y0 < 10) return null;
        return (
          <text key={box.name} x={(box.x0 + box.x1) / 2} y={(box.y0 + box.y1) / 2 + 4}>
            {text}
          </text>
        );
      })}
    </g>
  );
}

function plain(thing: string): string {
  return thing.replace(/[_-]/g, " ").replace(/ ?\d+$/, "");
}

function HomePad({ view, to }: RoomProps) {
  const [u, v] = to.at(view.home);
  const radius = Math.max(9, 0.35 * to.scale);
  return (
    <g class="home" transform={`translate(${u} ${v})`}>
      <circle r={radius} />
      <path d={`M${-radius * 0.3} ${-radius * 0.42}v${radius * 0.84}M${radius * 0.3} ${-radius * 0.42}v${radius * 0.84}M${-radius * 0.3} 0h${radius * 0.6}`} />
    </g>
  );
}

function Place({ place, to }: { place: PlaceView; to: Projection }) {
  const [u, v] = to.at(place.viewpoint);
  const [a, b] = to.at([place.look_at[0], place.look_at[1]]);
  const away = Math.hypot(a - u, b - v) || 1;
  const tick = (px: number): string => `${(((a - u) / away) * px).toFixed(1)} ${(((b - v) / away) * px).toFixed(1)}`;
  return (
    <g class="place-mark" transform={`translate(${u} ${v})`}>
      <path d={`M${tick(4)}L${tick(11)}`} />
      <circle r="4" />
      <text y={b < v ? 17 : -9}>{place.title}</text>
    </g>
  );
}

const others = computed(() => state.value?.others ?? []);

/** People whom the room tracks; where a visitor usually stands when nobody is tracked. */
function Visitors({ to }: { to: Projection }) {
  return (
    <>
      {others.value.map((one) => {
        const [u, v] = to.at(one.position);
        return (
          <g key={one.name} class="person" transform={`translate(${u} ${v})`}>
            <ellipse rx={0.24 * to.scale} ry={0.24 * to.scale} />
            <circle r={0.1 * to.scale} />
            <text y={-0.24 * to.scale - 4}>{one.name}</text>
          </g>
        );
      })}
    </>
  );
}

function Scale({ to }: { to: Projection }) {
  return (
    <g class="scale" transform={`translate(${to.width - 16 - to.scale} ${to.height - 10})`} aria-hidden="true">
      <path d={`M0 -5v5h${to.scale}v-5`} />
      <text x={to.scale / 2} y="-4">1 m</text>
    </g>
  );
}
