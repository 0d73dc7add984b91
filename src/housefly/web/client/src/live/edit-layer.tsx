import { signal } from "@preact/signals";
import type { Projection } from "../map/projection";
import { room, type Point } from "../store";
import type { PlaceView, ZoneView } from "../wire/room-messages";
import {
  addPlace,
  addZone,
  aim,
  aims,
  choose,
  chosen,
  places,
  rectangle,
  setZone,
  zones,
} from "./edits";
import { t } from "../messages/language";

/** A touch that moves less is a tap [px]. */
const STILL = 8;
const NEAR = 18;
/** On smaller maps names would cover each other [px/m]; the list has them all. */
const NAMES_FROM = 35;

interface Pull {
  from: Point;
  to: Point;
  moved: boolean;
}

const pull = signal<Pull | null>(null);

/** Places and zones as edited. A tap adds a place, a drag a zone; the open item follows. */
export function EditLayer({ to }: { to: Projection }) {
  const at = (event: PointerEvent): Point => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    return to.back([event.clientX - box.left, event.clientY - box.top]);
  };
  const down = (event: PointerEvent): void => {
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    const here = at(event);
    const touched = nearest(to, here);
    if (
      touched >= 0 &&
      chosen.value?.kind !== "zones" &&
      places.value[touched]!.name !== "home" &&
      aims.value === "viewpoint"
    )
      choose({ kind: "places", index: touched });
    pull.value = { from: here, to: here, moved: false };
  };
  const move = (event: PointerEvent): void => {
    if (!pull.value) return;
    const here = at(event);
    const far =
      to.scale * Math.hypot(here[0] - pull.value.from[0], here[1] - pull.value.from[1]) > STILL;
    pull.value = { ...pull.value, to: here, moved: pull.value.moved || far };
    if (pull.value.moved && chosen.value?.kind === "places") aim(chosen.value.index, here);
  };
  const up = (): void => {
    const done = pull.value;
    pull.value = null;
    if (done) finish(done, nearest(to, done.from) >= 0);
  };
  const open = chosen.value;
  return (
    <g class="edits">
      {zones.value.map((zone, k) => (
        <Zone key={k} to={to} zone={zone} open={open?.kind === "zones" && open.index === k} />
      ))}
      {pull.value?.moved && open?.kind !== "places" && (
        <Zone
          to={to}
          zone={{ rectangle: rectangle(pull.value.from, pull.value.to), reason: "" }}
          open
        />
      )}
      {places.value.map((place, k) => (
        <Place key={k} to={to} place={place} open={open?.kind === "places" && open.index === k} />
      ))}
      <rect
        class="touch"
        width={to.width}
        height={to.height}
        onPointerDown={down}
        onPointerMove={move}
        onPointerUp={up}
        onPointerCancel={() => (pull.value = null)}
        onMouseDown={
          (event) => event.preventDefault() /* the form that a touch opens keeps the focus */
        }
      />
    </g>
  );
}

function finish({ from, to, moved }: Pull, onPlace: boolean): void {
  const open = chosen.value;
  if (open?.kind === "places") {
    if (!moved && !(onPlace && aims.value === "viewpoint")) aim(open.index, to);
  } else if (moved && open) setZone(open.index, { rectangle: rectangle(from, to) });
  else if (moved) addZone(from, to);
  else if (!open) addPlace(to);
}

/** The place under the finger, or -1. */
function nearest(to: Projection, point: Point): number {
  const away = places.value.map(
    (place) => to.scale * Math.hypot(place.viewpoint[0] - point[0], place.viewpoint[1] - point[1]),
  );
  const least = Math.min(...away);
  return least < NEAR ? away.indexOf(least) : -1;
}

function Zone({ to, zone, open }: { to: Projection; zone: ZoneView; open: boolean }) {
  const [x0, y0, x1, y1] = zone.rectangle;
  const [u, v] = to.at([x0, y1]);
  const [width, height] = [to.scale * (x1 - x0), to.scale * (y1 - y0)];
  return (
    <g class="zone" data-open={open}>
      <rect x={u} y={v} width={width} height={height} />
      <text x={u + width / 2} y={v + height / 2 + 4}>
        {zone.reason}
      </text>
    </g>
  );
}

function Place({ to, place, open }: { to: Projection; place: PlaceView; open: boolean }) {
  const [u, v] = to.at(place.viewpoint);
  const [a, b] = to.at([place.look_at[0], place.look_at[1]]);
  if (place.name === "home" && room.value) return null;
  return (
    <g class="spot-mark" data-open={open}>
      {open && <path d={`M${u} ${v}L${a} ${b}`} />}
      {open && <path class="eye" d={`M${a - 5} ${b - 5}l10 10m0 -10l-10 10`} />}
      <circle cx={u} cy={v} r={open ? 8 : 6} />
      {(open || to.scale > NAMES_FROM) && (
        <text x={u} y={v + 20}>
          {place.title || t("new place")}
        </text>
      )}
    </g>
  );
}
