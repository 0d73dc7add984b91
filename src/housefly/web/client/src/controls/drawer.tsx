import { computed } from "@preact/signals";
import { cutMotors, go, homeHeld, reset, takeOff } from "../commands";
import { goal } from "../goal";
import { cut, flying, panel, verdict } from "../store";
import { HoldButton } from "./hold-button";
import { CutIcon, HomeIcon, ResetIcon, TakeOffIcon } from "./icons";

const notReady = computed(() => verdict.value?.may_take_off === false && !flying.value);

/** Orders that are rarely meant; to cut the motors is red, the last, and says what follows. */
export function Drawer() {
  if (panel.value !== "more") return null;
  return (
    <div class="drawer" role="group" aria-label="More orders">
      {goal.value && (
        <HoldButton hold={go} class="action" label="Fly there and stay">
          <span>Fly there and stay</span>
          <small aria-hidden="true">hold</small>
        </HoldButton>
      )}
      {cut.value ? (
        <HoldButton hold={reset} class="action" label="Reset after a cut">
          <ResetIcon />
          <span>Reset</span>
          <small aria-hidden="true">hold</small>
        </HoldButton>
      ) : (
        <HoldButton hold={takeOff} class="action" label="Take off">
          <TakeOffIcon />
          <span>Take off</span>
          <small aria-hidden="true">{notReady.value ? "not ready" : "hold"}</small>
        </HoldButton>
      )}
      <HoldButton hold={homeHeld} class="action" label="Fly home and land">
        <HomeIcon />
        <span>Home</span>
        <small aria-hidden="true">hold</small>
      </HoldButton>
      <HoldButton hold={cutMotors} class="cut" label="Cut motors: motors stop, drone falls">
        <CutIcon />
        <span>Cut motors</span>
        <small>it falls, hold 1 s</small>
      </HoldButton>
      <button type="button" class="action" onClick={() => (panel.value = "")}>
        Close
      </button>
    </div>
  );
}
