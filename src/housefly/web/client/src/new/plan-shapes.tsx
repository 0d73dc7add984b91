import { polyline, type Projection } from "../map/projection";
import type { DraftBox, DraftWall, SiteDraft } from "../wire/draft-messages";
import { cornersOf } from "./geometry";
import { lookOf, noseOf, type Item } from "./items";
import { chosen, step } from "./tools";

const PAD_RADIUS = 0.4;
/** What ends so far below the drone looks low [m]. */
const LOW = 0.3;
/** On smaller plans names would cover each other [px/m]. */
const NAMES_FROM = 30;

interface ShapeProps {
  all: SiteDraft;
  to: Projection;
}

/** A rectangle of the room as the attributes of an SVG one. */
export function rect(to: Projection, [x0, y0, x1, y1]: [number, number, number, number]) {
  const [u, v] = to.at([x0, y1]);
  return { x: u, y: v, width: to.scale * (x1 - x0), height: to.scale * (y1 - y0) };
}

/** What an item looks like. */
export function shapeOf(all: SiteDraft, to: Projection, { kind, index }: Item) {
  if (kind === "walls") return <Wall wall={all.walls[index]!} to={to} />;
  if (kind === "furniture")
    return <Box box={all.furniture[index]!} to={to} flight={all.flight_height} />;
  if (kind === "pad") return <Pad all={all} to={to} />;
  if (kind === "zones") {
    const { rectangle, reason } = all.zones[index]!;
    const box = rect(to, rectangle);
    return (
      <>
        <rect class="zone-area" {...box} />
        <text x={box.x + box.width / 2} y={box.y + box.height / 2 + 4}>
          {reason}
        </text>
      </>
    );
  }
  if (kind === "frame_points") {
    const { name, on_map } = all.frame_points[index]!;
    const [u, v] = to.at([on_map[0], on_map[1]]);
    return (
      <>
        <path class="target" d={`M${u - 8} ${v}h16M${u} ${v - 8}v16`} />
        <circle cx={u} cy={v} r="5" />
        <text x={u} y={v - 12}>
          {name}
        </text>
      </>
    );
  }
  return <Place all={all} to={to} index={index} />;
}

function Wall({ wall, to }: { wall: DraftWall; to: Projection }) {
  const [[u0, v0], [u1, v1]] = [to.at(wall.start), to.at(wall.end)];
  return (
    <line
      x1={u0}
      y1={v0}
      x2={u1}
      y2={v1}
      stroke-linecap="square"
      stroke-width={Math.max(2, wall.thickness * to.scale)}
    />
  );
}

function Box({ box, to, flight }: { box: DraftBox; to: Projection; flight: number }) {
  const [u, v] = to.at([box.x, box.y]);
  const fits = to.scale * box.length > 7 * box.name.length || to.scale > NAMES_FROM;
  return (
    <>
      <path
        class={box.top < flight - LOW ? "low" : "tall"}
        d={polyline(to, cornersOf(box), true)}
      />
      {fits && (
        <text x={u} y={v + 4}>
          {box.name}
        </text>
      )}
    </>
  );
}

function Pad({ all, to }: ShapeProps) {
  const [u, v] = to.at(all.pad!);
  const [a, b] = to.at(noseOf(all));
  const radius = Math.max(8, PAD_RADIUS * to.scale);
  const [h, w] = [0.42 * radius, 0.3 * radius];
  return (
    <>
      <circle cx={u} cy={v} r={radius} />
      <path d={`M${u - w} ${v - h}v${2 * h}M${u + w} ${v - h}v${2 * h}M${u - w} ${v}h${2 * w}`} />
      {step.value === "pad" && <path class="look" d={`M${u} ${v}L${a} ${b}`} />}
    </>
  );
}

function Place({ all, to, index }: ShapeProps & { index: number }) {
  const place = all.places[index]!;
  const [u, v] = to.at([place.x, place.y]);
  const [a, b] = to.at(lookOf(all, index));
  const away = Math.hypot(a - u, b - v) || 1;
  const open = chosen.value?.kind === "places" && chosen.value.index === index;
  const far = open ? away : 14;
  return (
    <>
      <path class="look" d={`M${u} ${v}l${((a - u) / away) * far} ${((b - v) / away) * far}`} />
      <circle cx={u} cy={v} r={open ? 8 : 6} />
      <text x={u} y={v + 20}>
        {place.title || place.name}
      </text>
    </>
  );
}
