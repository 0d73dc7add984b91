import { milliseconds } from "../format";
import { useMemo } from "preact/hooks";
import { poseAge, poseFreshness, state, trail, type Point } from "../store";
import { STRETCHES } from "../trail";
import { polyline, turn, type Projection } from "./projection";

const HULL = 0.26;
/** How strong the parts of the trail are, the newest first. */
const STRENGTHS = [0.8, 0.7, 0.6, 0.5];

let lastYaw = 0;

/** The same heading without the jump at 180 degrees, so that the arrow never spins round. */
function unwrapped(yaw: number): number {
  const step =
    ((((yaw - lastYaw + Math.PI) % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI)) - Math.PI;
  lastYaw += step;
  return lastYaw;
}

/** The drone with its heading, where it was, and how sure the room is of it. */
export function DroneLayer({ to }: { to: Projection }) {
  return (
    <>
      <Trail to={to} />
      <Drone to={to} />
    </>
  );
}

function Trail({ to }: { to: Projection }) {
  const stretches = trail.value;
  return (
    <g class="trail">
      {stretches.map((points, k) => (
        <Stretch
          key={points[0]!.join()}
          to={to}
          points={points}
          opacity={strength(stretches.length - 1 - k)}
        />
      ))}
    </g>
  );
}

/** Few steps, so that few stretches change as a new one begins. */
const strength = (age: number): number =>
  STRENGTHS[Math.floor((STRENGTHS.length * age) / STRETCHES)]!;

interface StretchProps {
  to: Projection;
  points: readonly Point[];
  opacity: number;
}

function Stretch({ to, points, opacity }: StretchProps) {
  const line = useMemo(() => polyline(to, points), [to, points]);
  return <path d={line} stroke-opacity={opacity} />;
}

function arrow(radius: number): string {
  const [nose, back, notch, side] = [0.72, -0.5, -0.22, 0.52].map((share) => share * radius);
  return `M${nose} 0L${back} ${side}L${notch} 0L${back} ${-side!}z`;
}

function Drone({ to }: { to: Projection }) {
  const now = state.value;
  if (!now?.position) return null;
  const [u, v] = to.at([now.position[0], now.position[1]]);
  const radius = Math.max(9, HULL * to.scale);
  const fresh = poseFreshness.value;
  const sigma = (now.position_std ?? 0) * to.scale;
  return (
    <g
      class="drone"
      data-age={fresh}
      style={{ transform: `translate(${u.toFixed(1)}px, ${v.toFixed(1)}px)` }}
    >
      <circle class="sigma" r={sigma.toFixed(1)} />
      <g
        class="body"
        style={{
          transform: `rotate(${turn(unwrapped(now.yaw ?? 0), to)}deg)`,
        }}
      >
        <circle class="hull" r={radius} />
        <path class="arrow" d={arrow(radius)} />
      </g>
      {fresh !== "fresh" && (
        <text class="age" y={-radius - 6} text-anchor="middle">
          seen {milliseconds(poseAge.value)} ago
        </text>
      )}
    </g>
  );
}
