import { computed, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { poseFreshness, room, state } from "../store";
import { Runs } from "./curve";
import { braking, curve, flown, heightAt, topSpeed, type Curve } from "./curve-values";
import { decimal, t } from "../messages/language";

/** Space around the chart [px]; a slim one, as on phones, has no words in it. */
const INSIDE = {
  full: { left: 26, right: 10, top: 10, bottom: 15 },
  slim: { left: 26, right: 8, top: 6, bottom: 6 },
};
const SLIM = 50;
/** The drone's hull is so high and wide [m]. */
const HULL = { high: 0.13, wide: 0.52 };
/** Where the drone stands in a chart without a curve, from its left edge [px]. */
const ASIDE = 14;

const size = signal<[number, number]>([0, 0]);

interface Frame {
  across(mark: number): number;
  up(height: number): number;
  left: number;
  right: number;
  foot: number;
  perMetre: number;
  perHeight: number;
  isSlim: boolean;
}

const top = computed(() => room.value?.limits.height_max ?? 2);

/** How the chart is laid out, the same while the curve is. */
const layout = computed<Frame>(() => {
  const length = curve.value?.marks.at(-1) ?? 0;
  const [width, height] = size.value;
  const isSlim = height < SLIM;
  const inside = INSIDE[isSlim ? "slim" : "full"];
  const high = height - inside.top - inside.bottom;
  const perMetre = Math.max(1, width - inside.left - inside.right) / (length || 1);
  return {
    across: (mark) => inside.left + perMetre * mark,
    up: (metres) => inside.top + high * (1 - Math.max(0, Math.min(1, metres / top.value))),
    left: inside.left,
    right: width - inside.right,
    foot: height - 3,
    perMetre,
    perHeight: high / top.value,
    isSlim,
  };
});

/** The drone's height to the centimetre, in words, or null. */
const heightWords = computed(() => {
  const metres = state.value?.position?.[2];
  return metres === undefined ? null : `${decimal(metres, 2)} m`;
});

/** The height along the curve that is flown: speed as colour, the drone, and where it can rest. */
export function HeightProfile() {
  const chart = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      size.value = [entry!.contentRect.width, entry!.contentRect.height];
    });
    observer.observe(chart.current!);
    return () => observer.disconnect();
  }, []);
  return (
    <div class="profile" data-curve={curve.value !== null} data-age={poseFreshness.value}>
      <Value />
      <div class="chart" ref={chart}>
        {size.value[0] > 0 && <Chart />}
      </div>
    </div>
  );
}

const Value = () => <span class="value">{heightWords.value ?? "–"}</span>;

/** What the chart says, in words. */
const words = computed(() => {
  const height = state.value?.position?.[2];
  if (curve.value) return inWords(curve.value);
  return height === undefined
    ? t("height unknown")
    : t("height {d} m, no curve is flown", { d: decimal(height, 1) });
});

function Chart() {
  const frame = layout.value;
  const way = curve.value;
  return (
    <svg width={size.value[0]} height={size.value[1]} role="img" aria-label={words.value}>
      <Axes frame={frame} />
      {way ? <Line frame={frame} way={way} /> : <FlightHeight frame={frame} />}
      {way ? <Here frame={frame} way={way} /> : <Aside frame={frame} />}
      {way && !frame.isSlim && (
        <text class="note" x={frame.right} y={frame.foot} text-anchor="end">
          {words.value}
        </text>
      )}
    </svg>
  );
}

/** Where there is no curve: the height at which the drone flies, and the drone at its own. */
function FlightHeight({ frame }: { frame: Frame }) {
  const wanted = room.value?.flight_height;
  if (wanted === undefined) return null;
  return <path class="wanted" d={`M${frame.left} ${frame.up(wanted)}H${frame.right}`} />;
}

function Aside({ frame }: { frame: Frame }) {
  const height = state.value?.position?.[2];
  if (height === undefined) return null;
  return (
    <g class="here" data-age={poseFreshness.value}>
      <Hull frame={frame} at={frame.left + ASIDE} height={height} half={ASIDE - 2} />
    </g>
  );
}

interface HullProps {
  frame: Frame;
  at: number;
  height: number;
  half: number;
}

function Hull({ frame, at, height, half }: HullProps) {
  const left = Math.max(frame.left, at - half);
  return (
    <rect
      class="hull"
      x={left}
      y={frame.up(height) - Math.max(2, (HULL.high / 2) * frame.perHeight)}
      width={Math.max(4, Math.min(frame.right, at + half) - left)}
      height={Math.max(4, HULL.high * frame.perHeight)}
      rx="2"
    />
  );
}

function inWords(way: Curve): string {
  const [low, high] = [Math.min(...way.heights), Math.max(...way.heights)];
  const heights =
    high - low < 0.05
      ? `${decimal(high, 1)} m`
      : t("{low} to {high} m", { low: decimal(low, 1), high: decimal(high, 1) });
  return t("height {heights} over {length} m in {n} s, up to {fastest} m/s", {
    heights,
    length: decimal(way.marks.at(-1)!, 1),
    n: Math.round(way.times.at(-1)!),
    fastest: decimal(Math.max(...way.speeds), 1),
  });
}

function Axes({ frame }: { frame: Frame }) {
  const ticks = Array.from({ length: Math.floor(top.value) + 1 }, (_, k) => k);
  return (
    <g class="axes" aria-hidden="true">
      {ticks.map((tick) => (
        <g key={tick}>
          <path d={`M${frame.left} ${frame.up(tick)}H${frame.right}`} />
          {(!frame.isSlim || tick === 0 || tick === ticks.length - 1) && (
            <text x={frame.left - 4} y={frame.up(tick) + 4} text-anchor="end">
              {tick} m
            </text>
          )}
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

const Line = ({ frame, way }: { frame: Frame; way: Curve }) => (
  <Runs
    way={way}
    top={topSpeed.value}
    done={flown.value}
    line={(first, last) => drawn(frame, way, first, last)}
    by={frame}
  />
);

/** The drone where tracking sees it, as uncertain as the filter says, and where it would rest. */
function Here({ frame, way }: { frame: Frame; way: Curve }) {
  const [now, brakes] = [state.value, braking.value];
  if (!now?.position || !brakes) return null;
  const [u, v] = [frame.across(brakes.at), frame.up(now.position[2])];
  const [sigma, sigmaUp] = [now.position_std ?? 0, now.height_std ?? 0];
  const rest = frame.across(brakes.rest);
  const half = Math.max(3, (HULL.wide / 2) * frame.perMetre);
  return (
    <g class="here" data-age={poseFreshness.value}>
      {brakes.distance > 0 && (
        <path class="rest" d={`M${rest} ${frame.up(heightAt(way, brakes.rest)) - 8}v16`} />
      )}
      <Hull frame={frame} at={u} height={now.position[2]} half={half} />
      <ellipse
        class="sigma"
        cx={u}
        cy={v}
        rx={(sigma * frame.perMetre).toFixed(1)}
        ry={(sigmaUp * frame.perHeight).toFixed(1)}
      />
      {!frame.isSlim && (
        <text class="sigmas" x={frame.left} y={frame.foot}>
          {t("± {one} in the plane, ± {other} in height", {
            one: millimetres(sigma),
            other: millimetres(sigmaUp),
          })}
          {brakes.distance > 0 && t("; stops in {d} m", { d: decimal(brakes.distance, 2) })}
        </text>
      )}
    </g>
  );
}

function millimetres(metres: number): string {
  return metres < 1 ? `${Math.round(1000 * metres)} mm` : `${decimal(metres, 1)} m`;
}
