import { at } from "../live/store";
import { liveAgain, replay, trouble } from "../replay/replay";
import { panel } from "../store";
import { TimeBar } from "../timebar/time-bar";

/** Time at the foot of the stage: when somebody wants it, and as long as the past is shown. */
export function Foot() {
  const isShown =
    panel.value === "past" ||
    at.value !== null ||
    replay.value !== null ||
    trouble.value + liveAgain.value !== "";
  return isShown ? (
    <div class="foot">
      <TimeBar />
    </div>
  ) : null;
}
