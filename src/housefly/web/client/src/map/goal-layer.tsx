import { goal } from "../goal";
import { path, state, type Point } from "../store";
import { lazyPart } from "../lazy-part";
import { polyline, type Projection } from "./projection";
import { decimal } from "../messages/language";

const CurveLayer = lazyPart(async () => (await import("../later")).CurveLayer);

/** The path that is being flown: what is left of it strong, what is done faint. */
export function PathLayer({ to }: { to: Projection }) {
  const way = path.value?.waypoints ?? [];
  if (way.length < 2) return null;
  if (path.value!.speeds.length > 1)
    return (
      <g class="way">
        <CurveLayer to={to} />
        <Target to={to} at={way.at(-1)!} />
      </g>
    );
  return (
    <g class="way">
      <path class="done" d={polyline(to, way)} />
      <Left to={to} way={way} />
      <Target to={to} at={way.at(-1)!} />
    </g>
  );
}

function Left({ to, way }: { to: Projection; way: readonly Point[] }) {
  const now = state.value;
  const here: Point[] = now?.position ? [[now.position[0], now.position[1]]] : [];
  return <path class="left" d={polyline(to, [...here, ...way.slice(now?.waypoint ?? 0)])} />;
}

function Target({ to, at }: { to: Projection; at: Point }) {
  const [u, v] = to.at(at);
  return <circle class="target" cx={u} cy={v} r="6" />;
}

/** The ghost: a goal not yet sent, with its path, length and time. */
export function GoalLayer({ to }: { to: Projection }) {
  const aim = goal.value;
  if (!aim) return null;
  const [u, v] = to.at(aim.point);
  const way = aim.plan?.path;
  const words = way ? `${decimal(way.length, 1)} m · ${Math.round(aim.plan!.duration)} s` : "";
  return (
    <g class="ghost" data-possible={way != null}>
      {way && <path class="preview" d={polyline(to, way.waypoints)} />}
      {aim.asked && <Asked to={to} at={aim.asked} />}
      <g transform={`translate(${u} ${v})`}>
        <circle class="ring" r="11" />
        <path class="cross" d="M-16 0h8M8 0h8M0 -16v8M0 8v8" />
      </g>
      {words && (
        <Tag
          x={Math.min(to.width - TAG.width / 2 - 4, Math.max(TAG.width / 2 + 4, u))}
          y={v > 60 ? v - 34 : v + 34}
          words={words}
        />
      )}
    </g>
  );
}

const TAG = { width: 108, height: 26 };

function Tag({ x, y, words }: { x: number; y: number; words: string }) {
  return (
    <g class="tag" transform={`translate(${x} ${y})`}>
      <rect x={-TAG.width / 2} y={-TAG.height / 2} width={TAG.width} height={TAG.height} rx="6" />
      <text y="5">{words}</text>
    </g>
  );
}

/** Where the person pointed, when the drone cannot be there. */
function Asked({ to, at }: { to: Projection; at: Point }) {
  const [u, v] = to.at(at);
  return <path class="asked" d={`M${u - 6} ${v - 6}l12 12m0 -12l-12 12`} />;
}
