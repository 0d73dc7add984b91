import { TimeBar } from "../timebar/time-bar";

/** The foot of the live scene: time. */
export function Foot() {
  return (
    <div class="foot">
      <TimeBar />
    </div>
  );
}
