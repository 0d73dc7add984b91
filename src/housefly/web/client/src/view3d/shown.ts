// The drone that plan and space show: the present one, or that of the recording.
import { computed } from "@preact/signals";
import { moment, recordedAt, replay } from "../replay/replay";
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
