import { at } from "../live/store";
import type { Point } from "../store";
import { shownDrone } from "../view3d/shown";
import { atTheEdge, ZOOM_MAX } from "./camera";
import type { Projection } from "./projection";
import { bringTo, showWhole, zoom, zoomStep } from "./view";
import { t } from "../messages/language";

const INSET = 32;

/** Nearer and farther, for those who have neither wheel nor two fingers. */
export function ZoomButtons() {
  const now = zoom.value;
  return (
    <div class="zoom" role="group" aria-label={t("Zoom of the map")}>
      <button
        type="button"
        aria-label={t("Zoom in")}
        title={t("Zoom in (+)")}
        aria-disabled={now >= ZOOM_MAX}
        onClick={() => zoomStep(1)}
      >
        +
      </button>
      <button
        type="button"
        aria-label={t("Zoom out")}
        title={t("Zoom out (-)")}
        aria-disabled={now <= 1}
        onClick={() => zoomStep(-1)}
      >
        −
      </button>
    </div>
  );
}

/** Back to the whole room; only there when it is not on the screen. */
export function WholeRoomButton() {
  if (zoom.value <= 1) return null;
  return (
    <button
      type="button"
      class="whole-room"
      title={t("Whole room (0)")}
      onClick={(event) => {
        // The button goes away; whoever pressed it with a key stays on the map.
        const map = event.currentTarget.parentElement?.querySelector<SVGElement>(":scope > svg");
        if (event.detail === 0) map?.focus();
        showWhole();
      }}
    >
      {t("Whole room")}
    </button>
  );
}

/** An arrow at the edge to a drone that is out of view; it brings the drone to the middle. */
export function ToTheDrone({ to }: { to: Projection }) {
  const drone = shownDrone.value;
  if (!drone || (at.value !== null && drone.kind !== "recorded")) return null;
  const place: Point = [drone.place[0], drone.place[1]];
  const edge = atTheEdge(to.at(place), to, INSET);
  if (!edge) return null;
  const [left, top] = edge.spot;
  return (
    <button
      type="button"
      class="to-drone"
      data-kind={drone.kind}
      aria-label={t("The drone is out of view: show it")}
      title={t("Show the drone")}
      style={{ left: `${left.toFixed(0)}px`, top: `${top.toFixed(0)}px` }}
      onClick={() => bringTo(place)}
    >
      <svg viewBox="-12 -12 24 24" aria-hidden="true">
        <path d="M9 0L-6 7L-3 0L-6 -7z" transform={`rotate(${edge.turn.toFixed(0)})`} />
      </svg>
    </button>
  );
}
