// What the view in space draws of the drone: the present, or the recording that is looked at.
import { computed } from "@preact/signals";
import { curve, type Curve } from "../map/curve-values";
import { moment, recordedAt, recordedCurve, replay } from "../replay/replay";
import { freshness, poseAge, state } from "../store";

export interface ShownDrone {
  place: [number, number, number];
  yaw: number;
  /** A recorded or old pose is drawn as nothing live is. */
  kind: "live" | "old" | "recorded";
}

export const shownDrone = computed<ShownDrone | null>(() => {
  const flight = replay.value;
  if (flight) {
    const then = recordedAt(flight, moment.value);
    return then?.place ? { place: then.place, yaw: then.yaw, kind: "recorded" } : null;
  }
  const now = state.value;
  if (!now?.position) return null;
  const kind = freshness(poseAge.value) === "fresh" ? "live" : "old";
  return { place: now.position, yaw: now.yaw ?? 0, kind };
});

export const shownCurve = computed<Curve | null>(() =>
  replay.value ? recordedCurve.value : curve.value,
);
