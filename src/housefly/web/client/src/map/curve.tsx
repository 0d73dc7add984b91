import { useMemo } from "preact/hooks";
import {
  braking,
  curve,
  flown,
  pointAt,
  seconds,
  speedClass,
  SPEED_CLASSES,
  stretch,
  topSpeed,
  type Curve,
} from "./curve-values";
import { polyline, type Projection } from "./projection";
import { decimal, t } from "../messages/language";

const DOT = 2.2;
const REST_BAR = 9;
const RUN_LEGS = 4;

/** The curve that is flown: colour is the planned speed, a dot each second, and where it stops. */
export function CurveLayer({ to }: { to: Projection }) {
  const way = curve.value;
  if (!way) return null;
  return (
    <g class="curve">
      <SpeedLine to={to} way={way} />
      <Stopping to={to} way={way} />
    </g>
  );
}

/** A line whose colour is the planned speed; what is flown already is faint. */
export function SpeedLine({ to, way, top = topSpeed.value }: Props & { top?: number }) {
  const done = way === curve.value ? flown.value : 0;
  const dots = useMemo(
    () => seconds(way).map((mark) => ({ mark, spot: to.at(pointAt(way, mark)) })),
    [to, way],
  );
  return (
    <>
      <Runs
        way={way}
        top={top}
        done={done}
        line={(first, last) => polyline(to, way.points.slice(first, last + 1))}
        by={to}
      />
      {dots.map(({ mark, spot: [u, v] }, k) => (
        <circle key={k} class="second" cx={u} cy={v} r={DOT} data-flown={mark <= done} />
      ))}
    </>
  );
}

interface RunsProps {
  way: Curve;
  top: number;
  /** How far along the curve the drone has come [m]. */
  done: number;
  /** How the points from one number to another are drawn, as long as `by` stays the same. */
  line: (first: number, last: number) => string;
  by: unknown;
}

/** The lines are made once for a curve: only what is flown changes while it is. */
export function Runs({ way, top, done, line, by }: RunsProps) {
  const parts = useMemo(
    () => runs(way, top).map((run) => ({ ...run, d: line(run.first, run.last) })),
    [way, top, by],
  );
  return (
    <>
      {parts.map(({ first, last, kind, d }) => (
        <path
          key={first}
          class="speed"
          data-speed={kind}
          data-flown={way.marks[last]! <= done}
          d={d}
        />
      ))}
    </>
  );
}

interface Props {
  to: Projection;
  way: Curve;
}

interface Run {
  first: number;
  last: number;
  kind: number;
}

/** Neighbouring legs of one class of speed as one run. */
function runs(way: Curve, top: number): Run[] {
  const found: Run[] = [];
  for (let k = 0; k + 1 < way.points.length; k++) {
    const kind = speedClass((way.speeds[k]! + way.speeds[k + 1]!) / 2, top);
    const last = found.at(-1);
    // Short, so that what is flown already can be told apart.
    if (last && last.kind === kind && last.last - last.first < RUN_LEGS) last.last = k + 1;
    else found.push({ first: k, last: k + 1, kind });
  }
  return found;
}

/** How far the drone flies on if it brakes now, along its curve, and a bar where it rests. */
function Stopping({ to, way }: Props) {
  const now = braking.value;
  if (!now || now.distance <= 0 || now.rest <= now.at) return null;
  const [end, before] = [to.at(pointAt(way, now.rest)), to.at(pointAt(way, now.rest - 0.05))];
  const length = Math.hypot(end[0] - before[0], end[1] - before[1]) || 1;
  const [across, down] = [
    (-(end[1] - before[1]) / length) * REST_BAR,
    ((end[0] - before[0]) / length) * REST_BAR,
  ];
  return (
    <g class="stopping" data-distance={now.distance.toFixed(2)}>
      <path class="brakes" d={polyline(to, stretch(way, now.at, now.rest))} />
      <path
        class="rest"
        d={`M${end[0] - across} ${end[1] - down}L${end[0] + across} ${end[1] + down}`}
      />
    </g>
  );
}

/** What the colours mean, in the legend of the map; nothing while no curve is flown. */
export function SpeedLegend() {
  if (!curve.value) return null;
  const shades = Array.from({ length: SPEED_CLASSES }, (_, k) => k);
  return (
    <>
      <li class="plain speeds">
        <span aria-hidden="true">
          {shades.map((kind) => (
            <i key={kind} data-speed={kind} />
          ))}
        </span>
        {t("0 to {d} m/s, a dot each second", { d: decimal(topSpeed.value, 1) })}
      </li>
      <li class="plain rests">{t("stops here if it brakes now")}</li>
    </>
  );
}
