import { computed } from "@preact/signals";
import { room, state, type Point } from "../store";
import type { GridView, OtherBody, OutlineView, PlaceView, RoomView } from "../wire/messages";
import { Footprint } from "./footprint";
import { runs } from "./grid";
import { labels, WALLS } from "./labels";
import { polyline, rectangle, type Projection } from "./projection";
import { capital } from "../format";

const GRID_LINES_FROM = 13;

/** Everything that does not move: cells, furniture with names, places, home, scale. */
export function RoomLayer({ to, visitors = true }: { to: Projection; visitors?: boolean }) {
  const view = room.value;
  if (!view) return null;
  return (
    <g class="room">
      <Floor view={view} to={to} />
      <Furniture view={view} to={to} />
      <Cells grid={view.grid} to={to} />
      <HomePad view={view} to={to} />
      {view.places.map(
        (place) => place.name !== "home" && <Place key={place.name} place={place} to={to} />,
      )}
      <Names view={view} to={to} />
      {visitors && <Visitors to={to} />}
      <Scale to={to} />
    </g>
  );
}

interface RoomProps {
  view: RoomView;
  to: Projection;
}

/** All cells of some letters as one SVG path. */
function cells(grid: GridView, to: Projection, letters: string): string {
  const { origin, resolution: cell } = grid;
  return runs(grid, letters)
    .map(({ i, j, width }) =>
      rectangle(to, [origin[0] + i * cell, origin[1] + j * cell], width * cell, cell),
    )
    .join("");
}

function Floor({ view, to }: RoomProps) {
  return <path class="floor" d={cells(view.grid, to, ".#vi")} />;
}

function Cells({ grid, to }: { grid: GridView; to: Projection }) {
  const cell = to.scale * grid.resolution;
  return (
    <g class="cells">
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
      {cell >= GRID_LINES_FROM && <path class="lines" d={lines(grid, to)} />}
      <path class="inflated" d={cells(grid, to, "i")} />
      <path class="occupied" d={cells(grid, to, "#")} />
      <path class="virtual" d={cells(grid, to, "v")} />
    </g>
  );
}

function lines(grid: GridView, to: Projection): string {
  const at = (i: number, j: number): Point => [
    grid.origin[0] + i * grid.resolution,
    grid.origin[1] + j * grid.resolution,
  ];
  const along = Array.from({ length: grid.width + 1 }, (_, i) => [at(i, 0), at(i, grid.height)]);
  const across = Array.from({ length: grid.height + 1 }, (_, j) => [at(0, j), at(grid.width, j)]);
  return [...along, ...across].map((line) => polyline(to, line)).join("");
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

/** Walls, tracked furniture, and things below or at the drone's flight height look different. */
function kind(outline: OutlineView, view: RoomView): string {
  if (WALLS.test(outline.thing)) return "wall";
  if (outline.tracked) return "tracked";
  if (outline.top < 0.05) return "flat";
  return outline.top < view.flight_height - 0.3 ? "low" : "tall";
}

function Names({ view, to }: RoomProps) {
  return (
    <g class="names">
      {labels(view, to).map((label) => (
        <text key={`${label.kind} ${label.text}`} class={label.kind} x={label.x} y={label.y}>
          {label.text}
        </text>
      ))}
    </g>
  );
}

function HomePad({ view, to }: RoomProps) {
  const [u, v] = to.at(view.home);
  const radius = Math.max(9, 0.35 * to.scale);
  const [u0, v0] = [0.3 * radius, 0.42 * radius];
  return (
    <g class="home" transform={`translate(${u} ${v})`}>
      <circle r={radius} />
      <path d={`M${-u0} ${-v0}v${2 * v0}M${u0} ${-v0}v${2 * v0}M${-u0} 0h${2 * u0}`} />
    </g>
  );
}

function Place({ place, to }: { place: PlaceView; to: Projection }) {
  const [u, v] = to.at(place.viewpoint);
  const [a, b] = to.at([place.look_at[0], place.look_at[1]]);
  const away = Math.hypot(a - u, b - v) || 1;
  const tick = (px: number): string =>
    `${(((a - u) / away) * px).toFixed(1)} ${(((b - v) / away) * px).toFixed(1)}`;
  return (
    <g class="place-mark" transform={`translate(${u} ${v})`}>
      <path d={`M${tick(4)}L${tick(11)}`} />
      <circle r="4" />
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
        if (one.size[0]) return <Piece key={one.name} to={to} one={one} />;
        return (
          <g key={one.name} class="person" transform={`translate(${u} ${v})`}>
            <ellipse rx={0.24 * to.scale} ry={0.24 * to.scale} />
            <circle r={0.1 * to.scale} />
            <text y={-0.24 * to.scale - 4}>
              {capital(one.name)}
            </text>
          </g>
        );
      })}
    </>
  );
}

/** Furniture where tracking sees it. */
function Piece({ to, one }: { to: Projection; one: OtherBody }) {
  const [u, v] = to.at(one.position);
  const [length, width] = [one.size[0] * to.scale, one.size[1] * to.scale];
  return (
    <g class="piece" transform={`translate(${u} ${v})`}>
      <Footprint to={to} length={length} width={width} yaw={one.yaw} />
      <text y="4">{one.name}</text>
    </g>
  );
}

/** Lengths of the scale [m], and how long it is drawn at most [px]. */
const LENGTHS = [1, 0.5, 0.2, 0.1];
const SCALE_MAX = 140;

function Scale({ to }: { to: Projection }) {
  const length = LENGTHS.find((one) => one * to.scale <= SCALE_MAX) ?? LENGTHS.at(-1)!;
  const width = length * to.scale;
  return (
    <g class="scale" transform={`translate(14 ${to.height - 8})`} aria-hidden="true">
      <path class="halo" d={`M0 -5v5h${width}v-5`} />
      <path d={`M0 -5v5h${width}v-5`} />
      <text x={width / 2} y="-4">
        {length} m
      </text>
    </g>
  );
}
