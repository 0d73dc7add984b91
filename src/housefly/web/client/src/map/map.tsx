import { computed, signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { choosePoint } from "../goal";
import { SwapButton } from "../panels/video";
import { room } from "../store";
import { DroneLayer } from "./drone";
import { GoalLayer, PathLayer } from "./goal-layer";
import { insideOf } from "./grid";
import { HeightStrip } from "./height";
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
          role={onPoint ? "img" : "group"}
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

/** The floor plan: click where the drone should go. */
export function MapView() {
  return (
    <section class="view map" aria-label="Map of the room">
      <PlanFrame
        label="Floor plan with the drone. Arrow keys move the goal; a list of places follows."
        onPoint={choosePoint}
      >
        {(to) => (
          <>
            <RoomLayer to={to} />
            <PathLayer to={to} />
            <GoalLayer to={to} />
            <DroneLayer to={to} />
          </>
        )}
      </PlanFrame>
      <HeightStrip />
      <Legend />
      <SwapButton to="map" />
    </section>
  );
}

function Legend() {
  return (
    <ul class="legend" aria-label="Legend">
      <li class="free">free</li>
      <li class="occupied">occupied</li>
      <li class="virtual">kept free by order</li>
      <li class="inflated">safety margin</li>
    </ul>
  );
}
