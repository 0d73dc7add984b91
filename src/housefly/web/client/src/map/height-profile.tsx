import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { freshness, poseAge, room, state } from "../store";
import { runs } from "./curve";
import { braking, curve, heightAt, topSpeed, type Curve } from "./curve-values";

const HEIGHT = 64;
const INSIDE = { left: 26, right: 10, top: 10, bottom: 15 };
/** The drone's hull is so high and wide [m]. */
const HULL = { high: 0.13, wide: 0.52 };

const width = signal(0);

interface Frame {
  across(mark: number): number;
  up(height: number): number;
  perMetre: number;
  perHeight: number;
}

function frameOf(way: Curve, top: number): Frame {
  const high = HEIGHT - INSIDE.top - INSIDE.bottom;
  const perMetre = Math.max(1, width.value - INSIDE.left - INSIDE.right) / (way.marks.at(-1)! || 1);
  return {
    across: (mark) => INSIDE.left + perMetre * mark,
    up: (height) => INSIDE.top + high * (1 - Math.max(0, Math.min(1, height / top))),
    perMetre,
    perHeight: high / top,
  };
}

/** The height along the curve that is flown: speed as colour, the drone, and where it can rest. */
export function HeightProfile() {
  const way = curve.value;
  if (!way) return null;
  return <Profile way={way} />;
}

function Profile({ way }: { way: Curve }) {
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => (width.value = entry!.contentRect.width));
    observer.observe(box.current!);
    return () => observer.disconnect();
  }, []);
  const top = room.value?.limits.height_max ?? 2;
  const frame = frameOf(way, top);
  return (
    <div class="profile" ref={box}>
      {width.value > 0 && (
        <svg width={width.value} height={HEIGHT} role="img" aria-label={inWords(way)}>
          <Axes frame={frame} top={top} />
          <Line frame={frame} way={way} />
          <Here frame={frame} way={way} />
          <text class="note" x={width.value - INSIDE.right} y={HEIGHT - 3} text-anchor="end">
            {inWords(way)}
          </text>
        </svg>
      )}
    </div>
  );
}

function inWords(way: Curve): string {
  const [low, high] = [Math.min(...way.heights), Math.max(...way.heights)];
  const heights =
    high - low < 0.05 ? `${high.toFixed(1)} m` : `${low.toFixed(1)} to ${high.toFixed(1)} m`;
  const seconds = Math.round(way.times.at(-1)!);
  const fastest = Math.max(...way.speeds).toFixed(1);
  const length = way.marks.at(-1)!.toFixed(1);
  return `height ${heights} over ${length} m in ${seconds} s, up to ${fastest} m/s`;
}

function Axes({ frame, top }: { frame: Frame; top: number }) {
  const ticks = Array.from({ length: Math.floor(top) + 1 }, (_, k) => k);
  return (
    <g class="axes" aria-hidden="true">
      {ticks.map((tick) => (
        <g key={tick}>
          <path d={`M${INSIDE.left} ${frame.up(tick)}H${width.value - INSIDE.right}`} />
          <text x={INSIDE.left - 4} y={frame.up(tick) + 4} text-anchor="end">
            {tick} m
          </text>
        </g>
      ))}
    </g>
  );
}

function drawn(frame: Frame, way: Curve, first: number, last: number): string {
  const points = way.marks.slice(first, last + 1).map((mark, k) => {
    const [u, v] = [frame.across(mark), frame.up(way.heights[first + k]!)];
    return `${u.toFixed(1)} ${v.toFixed(1)}`;
  });
  return `M${points.join("L")}`;
}

function Line({ frame, way }: { frame: Frame; way: Curve }) {
  const flown = braking.value?.at ?? 0;
  return (
    <>
      {runs(way, topSpeed.value).map(({ first, last, kind }) => (
        <path
          key={first}
          class="speed"
          data-speed={kind}
          data-flown={way.marks[last]! <= flown}
          d={drawn(frame, way, first, last)}
        />
      ))}
    </>
  );
}

/** The drone where tracking sees it, as uncertain as the filter says, and where it would rest. */
function Here({ frame, way }: { frame: Frame; way: Curve }) {
  const [now, brakes] = [state.value, braking.value];
  if (!now?.position || !brakes) return null;
  const [u, v] = [frame.across(brakes.at), frame.up(now.position[2])];
  const [sigma, sigmaUp] = [now.position_std ?? 0, now.height_std ?? 0];
  const rest = frame.across(brakes.rest);
  const half = Math.max(3, (HULL.wide / 2) * frame.perMetre);
  const left = Math.max(INSIDE.left, u - half);
  return (
    <g class="here" data-age={freshness(poseAge.value)}>
      {brakes.distance > 0 && (
        <path class="rest" d={`M${rest} ${frame.up(heightAt(way, brakes.rest)) - 8}v16`} />
      )}
      <rect
        class="hull"
        x={left}
        y={v - Math.max(2, (HULL.high / 2) * frame.perHeight)}
        width={Math.max(4, Math.min(width.value - INSIDE.right, u + half) - left)}
        height={Math.max(4, HULL.high * frame.perHeight)}
        rx="2"
      />
      <ellipse
        class="sigma"
        cx={u}
        cy={v}
        rx={(sigma * frame.perMetre).toFixed(1)}
        ry={(sigmaUp * frame.perHeight).toFixed(1)}
      />
      <text class="sigmas" x={INSIDE.left} y={HEIGHT - 3}>
        {`± ${millimetres(sigma)} in the plane, ± ${millimetres(sigmaUp)} in height`}
        {brakes.distance > 0 && `; stops in ${brakes.distance.toFixed(2)} m`}
      </text>
    </g>
  );
}

function millimetres(metres: number): string {
  return metres < 1 ? `${Math.round(1000 * metres)} mm` : `${metres.toFixed(1)} m`;
}
