import { percent } from "../format";
import { Footprint } from "../map/footprint";
import { placed, type Box, type Spot } from "../map/label-spots";
import { turn, type Projection } from "../map/projection";
import { decimal, t } from "../messages/language";
import type { ObstacleAnswer } from "../wire/room-messages";
import { TRACKED, at, obstacles } from "./store";

const FAINTEST = 0.45;
const SLOW = 0.05;

interface LayerProps {
  to: Projection;
  /** What is covered already; the words of obstacles stand beside it, or nowhere. */
  taken: Box[];
}

/** What no map knows and the scanners see now; of two words in one spot the surer ones stay. */
export function ObstacleLayer({ to, taken }: LayerProps) {
  if (at.value !== null) return null;
  const spots = new Map<string, Spot | undefined>();
  for (const one of [...obstacles.value].sort((a, b) => b.confidence - a.confidence))
    spots.set(one.obstacle, spotOf(one, to, taken));
  return (
    <g class="obstacles">
      {obstacles.value.map((one) => (
        <Obstacle key={one.obstacle} to={to} one={one} spot={spots.get(one.obstacle)} />
      ))}
    </g>
  );
}

const isTracked = (one: ObstacleAnswer): boolean => one.source === TRACKED;
const speedOf = (one: ObstacleAnswer): number => Math.hypot(one.vx, one.vy);
const radiusOf = (one: ObstacleAnswer, to: Projection): number =>
  Math.max(6, one.radius * to.scale);

function wordsOf(one: ObstacleAnswer): string {
  const speed = speedOf(one) > SLOW ? [`${decimal(speedOf(one), 1)} m/s`] : [];
  if (isTracked(one)) return [one.obstacle.slice(TRACKED.length + 1), ...speed].join(", ");
  return [...speed, t("{p} sure", { p: percent(one.confidence) })].join(", ");
}

function spotOf(one: ObstacleAnswer, to: Projection, taken: Box[]): Spot | undefined {
  const saying = {
    at: to.at([one.x, one.y]),
    reach: radiusOf(one, to),
    choices: [[wordsOf(one)]],
    isKept: false,
    isWithin: isTracked(one),
  };
  return placed(saying, to, taken)?.spot;
}

interface ObstacleProps {
  to: Projection;
  one: ObstacleAnswer;
  spot: Spot | undefined;
}

function Obstacle({ to, one, spot }: ObstacleProps) {
  const [u, v] = to.at([one.x, one.y]);
  const [length, width] = [one.length * to.scale, one.width * to.scale];
  return (
    <g
      class={isTracked(one) ? "obstacle tracked" : "obstacle"}
      transform={`translate(${u.toFixed(1)} ${v.toFixed(1)})`}
      opacity={Math.max(FAINTEST, 1 - one.age)}
    >
      {length ? (
        <Footprint to={to} length={length} width={width} yaw={one.yaw} />
      ) : (
        <circle r={radiusOf(one, to)} />
      )}
      {speedOf(one) > SLOW && (
        <path
          d={`M0 0H${(speedOf(one) * to.scale).toFixed(1)}m-6 -4l6 4l-6 4`}
          transform={`rotate(${turn(Math.atan2(one.vy, one.vx), to)})`}
        />
      )}
      {spot && (
        <text x={spot.x} y={spot.y}>
          {wordsOf(one)}
        </text>
      )}
    </g>
  );
}
