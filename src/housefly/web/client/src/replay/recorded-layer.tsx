import { useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { SpeedLine } from "../map/curve";
import { polyline, turn, type Projection } from "../map/projection";
import type { Point } from "../store";
import { recordedCurve, recordedPath, recordedWay } from "./recorded-state";
import { moment, recordedAt, replay, rowAt } from "./replay";

const HULL = 0.26;
/** So much of the way behind the drone is strong [s]. */
const BEHIND = 12;

/** A flight of the past on the map: hollow and dashed, as nothing live is. */
export function RecordedLayer({ to }: { to: Projection }) {
  if (!replay.value) return null;
  return (
    <g class="recorded-layer">
      {recordedWay.value.map((part, k) => (
        <path key={k} class="whole" d={polyline(to, part)} />
      ))}
      <Planned to={to} />
      <Moving to={to} />
      <text class="watermark" x={to.width / 2} y={to.height / 2}>
        RECORDED
      </text>
    </g>
  );
}

function Planned({ to }: { to: Projection }) {
  const way = recordedCurve.value;
  if (way)
    return (
      <g class="curve">
        <SpeedLine to={to} way={way} top={Math.max(...way.speeds, 0.1)} />
      </g>
    );
  const flat = recordedPath.value?.waypoints ?? [];
  return flat.length > 1 ? <path class="flat" d={polyline(to, flat)} /> : null;
}

/** What changes sixty times a second is set on the elements themselves. */
function Moving({ to }: { to: Projection }) {
  const drone = useRef<SVGGElement>(null);
  const behind = useRef<SVGPathElement>(null);
  useSignalEffect(() => {
    const flight = replay.value;
    const time = moment.value;
    if (!flight || !drone.current || !behind.current) return;
    const then = recordedAt(flight, time);
    drone.current.style.display = then?.place ? "" : "none";
    if (!then?.place) return;
    const [u, v] = to.at([then.place[0], then.place[1]]);
    drone.current.setAttribute(
      "transform",
      `translate(${u.toFixed(1)} ${v.toFixed(1)}) rotate(${turn(then.yaw, to)})`,
    );
    const way: Point[] = [];
    for (let k = Math.max(0, rowAt(flight.t, time - BEHIND)); k <= rowAt(flight.t, time); k += 2)
      if (flight.x[k] != null) way.push([flight.x[k]!, flight.y[k]!]);
    way.push([then.place[0], then.place[1]]);
    behind.current.setAttribute("d", polyline(to, way));
  });
  const radius = Math.max(9, HULL * to.scale);
  const [nose, back, side] = [0.72 * radius, -0.5 * radius, 0.52 * radius];
  return (
    <>
      <path class="behind" ref={behind} />
      <g class="then" ref={drone}>
        <circle r={radius} />
        <path d={`M${nose} 0L${back} ${side}L${-0.22 * radius} 0L${back} ${-side}z`} />
      </g>
    </>
  );
}
