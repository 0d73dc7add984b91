import { computed, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { choosePoint } from "../goal";
import { SwapButton } from "../panels/video";
import { room } from "../store";
import { DroneLayer } from "./drone";
import { GoalLayer, WayLayer } from "./goal-layer";
import { insideOf } from "./grid";
import { HeightStrip } from "./height";
import { fit } from "./projection";
import { RoomLayer } from "./room";

const MARGIN = 14;
const size = signal<[number, number]>([0, 0]);

export const projection = computed(() => {
  const view = room.value;
  const [width, height] = size.value;
  return view && width > 0 && height > 0 ? fit(insideOf(view.grid) ?? view.bounds, width, height, MARGIN) : null;
});

/** The floor plan: click where the drone should go. */
export function MapView() {
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      size.value = [entry!.contentRect.width, entry!.contentRect.height];
    });
    observer.observe(frame.current!);
    return () => observer.disconnect();
  }, []);
  return (
    <section class="view map" aria-label="Map of the room">
      <div class="plan-view" ref={frame}>
        <Plan />
      </div>
      <HeightStrip />
      <Legend />
      <SwapButton to="map" />
    </section>
  );
}

function Plan() {
  const to = projection.value;
  if (!to) return <p class="veil">Waiting for the room</p>;
  const click = (event: MouseEvent): void => {
    const box = (event.currentTarget as SVGElement).getBoundingClientRect();
    choosePoint(to.back([event.clientX - box.left, event.clientY - box.top]));
  };
  return (
    <svg
      width={to.width}
      height={to.height}
      tabIndex={0}
      role="img"
      aria-label="Floor plan with the drone. Arrow keys move the goal; a list of places follows."
      data-scale={to.scale}
      onClick={click}
    >
      <RoomLayer to={to} />
      <WayLayer to={to} />
      <GoalLayer to={to} />
      <DroneLayer to={to} />
    </svg>
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
