import { computed, signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { choosePoint } from "../goal";
import { percent } from "../format";
import { CoverageLayer, CoverageLegend } from "../live/coverage";
import { PastBanner } from "../live/past-banner";
import { Layers, showsMargins, showsThings } from "../live/layers";
import {
  at,
  hindering,
  nameOf,
  showsCoverage,
  situations,
  things,
  trouble,
} from "../live/store";
import { ObstacleLayer, placeless, ThingsLayer } from "../live/things";
import { isWorry, worthSaying } from "../live/words";
import { SwapButton } from "../panels/video";
import { RecordedBanner } from "../replay/recorded";
import { RecordedLayer } from "../replay/recorded-layer";
import { replaying } from "../replay/replay";
import { room } from "../store";
import { SpeedLegend } from "./curve";
import { inSpace, RoomInSpace, SpaceButton } from "../view3d/space-button";
import { DroneLayer } from "./drone";
import { GoalLayer, PathLayer } from "./goal-layer";
import { insideOf } from "./grid";
import { HeightStrip } from "./height";
import { HeightProfile } from "./height-profile";
import { fit, type Projection } from "./projection";
import { RoomLayer } from "./room";

const MARGIN = 14;
const size = signal<[number, number]>([0, 0]);

export const projection = computed(() => {
  const view = room.value;
  const [width, height] = size.value;
  return view && width > 0 && height > 0
    ? fit(insideOf(view.grid) ?? view.bounds, width, height, MARGIN)
    : null;
});

interface FrameProps {
  label: string;
  onPoint?: (point: [number, number]) => void;
  children: (to: Projection) => ComponentChildren;
}

/** A floor plan as large as there is room for; one at a time is on the screen. */
export function PlanFrame({ label, onPoint, children }: FrameProps) {
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      size.value = [entry!.contentRect.width, entry!.contentRect.height];
    });
    observer.observe(frame.current!);
    return () => observer.disconnect();
  }, []);
  const to = projection.value;
  const click = (event: MouseEvent): void => {
    const box = (event.currentTarget as SVGElement).getBoundingClientRect();
    onPoint?.(to!.back([event.clientX - box.left, event.clientY - box.top]));
  };
  return (
    <div class="plan-view" ref={frame}>
      {to ? (
        <svg
          width={to.width}
          height={to.height}
          tabindex={onPoint ? 0 : -1}
          role="group"
          aria-label={label}
          data-scale={to.scale}
          onClick={click}
        >
          {children(to)}
        </svg>
      ) : (
        <p class="veil">Waiting for the room</p>
      )}
    </div>
  );
}

/** The floor plan: who and what is where, and click where the drone should go. */
export function MapView() {
  const recorded = replaying.value;
  const past = at.value !== null || recorded;
  const heard = things.value.size > 0 && !trouble.value;
  return (
    <section
      class="view map live"
      aria-label="Map of the room"
      data-past={past}
      data-recorded={recorded}
      data-margins={showsMargins.value}
      data-coverage={showsCoverage.value}
    >
      {inSpace.value ? (
        <RoomInSpace />
      ) : (
        <PlanFrame
          label="Floor plan with the drone. Arrow keys move the goal; a list of places follows."
          {...(past ? {} : { onPoint: (point: [number, number]) => choosePoint(point) })}
        >
          {(to) => (
            <>
              <RoomLayer to={to} visitors={!heard && !past} />
              <CoverageLayer to={to} />
              {!past && <PathLayer to={to} />}
              {!past && <GoalLayer to={to} />}
              {showsThings.value && <ObstacleLayer to={to} />}
              {showsThings.value && <ThingsLayer to={to} />}
              {recorded ? <RecordedLayer to={to} /> : !past && <DroneLayer to={to} />}
            </>
          )}
        </PlanFrame>
      )}
      {!past && <HeightStrip />}
      {!past && <HeightProfile />}
      <Notes />
      <Layers />
      <SpaceButton />
      {recorded ? <RecordedBanner /> : <PastBanner />}
      <SwapButton to="map" />
    </section>
  );
}

/** What the map cannot draw, in words. */
function Notes() {
  const lost = placeless();
  return (
    <ul class="legend" aria-label="Legend">
      <CoverageLegend />
      <SpeedLegend />
      {showsMargins.value && <li class="virtual">kept free by order</li>}
      {showsMargins.value && <li class="inflated">too close to fly</li>}
      {hindering.value > 0 && (
        <li class="plain">△ {hindering.value} in the way that no map knows</li>
      )}
      {worthSaying(situations.value)
        .filter((one) => isWorry(one.kind))
        .map((one) => (
          <li class="trouble" key={`${one.kind} ${one.thing}`}>
            △ {nameOf(one.thing)}: {one.kind.replace(/^person /, "")},{" "}
            {percent(one.confidence)} sure{one.evidence && `; ${one.evidence}`}
          </li>
        ))}
      {lost.length > 0 && (
        <li class="plain">
          Place unknown: {lost.map((one) => `${one.name} (in ${nameOf(one.inside)})`).join(", ")}
        </li>
      )}
      {trouble.value && (
        <li class="plain">
          <span role="status">
            △ People and things are not shown: {trouble.value.split(":")[0]}.
          </span>
        </li>
      )}
    </ul>
  );
}
