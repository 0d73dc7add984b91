import {
  hover,
  hoverObjection,
  home,
  homeObjection,
  land,
  landObjection,
  reset,
  resume,
  takeOff,
} from "../commands";
import type { ReadonlySignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { refusal } from "../preflight";
import { cut } from "../store";
import { HoldButton } from "./hold-button";
import { HomeIcon, HoverIcon, LandIcon, ResetIcon, ResumeIcon, TakeOffIcon } from "./icons";

interface Press {
  label: string;
  objection: ReadonlySignal<string>;
  action: () => void;
  children: ComponentChildren;
}

function PressButton({ label, objection, action, children }: Press) {
  return (
    <button
      type="button"
      class="action"
      title={objection.value || label}
      aria-description={objection.value}
      aria-disabled={objection.value !== ""}
      onClick={action}
    >
      {children}
    </button>
  );
}

/** The drone's plain orders; none of them needs a goal. */
export function Actions() {
  return (
    <div class="actions" role="group" aria-label="Drone">
      {cut.value ? (
        <HoldButton hold={reset} class="action" label="Reset after a cut">
          <ResetIcon />
          <span>Reset</span>
          <small>hold</small>
        </HoldButton>
      ) : (
        <HoldButton hold={takeOff} class="action" label="Take off">
          <TakeOffIcon />
          <span>Take off</span>
          <small>{refusal.value ? "not ready" : "hold"}</small>
        </HoldButton>
      )}
      <PressButton label="Land here" objection={landObjection} action={land}>
        <LandIcon />
        <span>Land</span>
      </PressButton>
      <PressButton label="Stay where it is" objection={hoverObjection} action={hover}>
        <HoverIcon />
        <span>Hover</span>
      </PressButton>
      <PressButton label="Fly home and land" objection={homeObjection} action={home}>
        <HomeIcon />
        <span>Home</span>
      </PressButton>
      <HoldButton hold={resume} class="action" label="Resume after STOP">
        <ResumeIcon />
        <span>Resume</span>
        <small>hold</small>
      </HoldButton>
    </div>
  );
}
