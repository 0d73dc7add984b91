import { computed, type ReadonlySignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import {
  flyHome,
  homeHeld,
  hover,
  hoverObjection,
  land,
  landObjection,
  reset,
  resume,
  service,
  takeOver,
} from "../commands";
import { goal, POINT } from "../goal";
import { headline } from "../headline";
import type { Hold } from "../hold";
import { flying, iFly, lineLives, me, panel, toggle, verdict } from "../store";
import { looking } from "../preflight";
import { isPhone } from "../scene/phone";
import { Drawer } from "./drawer";
import { HoldButton } from "./hold-button";
import { HomeIcon, HoverIcon, LandIcon, MoreIcon, PlaceIcon, ResetIcon, ResumeIcon } from "./icons";
import { Plan, Places } from "./mission";
import { Opens } from "./opens";
import { NudgeHere } from "./nudge-here";
import { t } from "../messages/language";

/** Where to, the one button for what comes next, and what is always beside it. */
export function Orders() {
  return (
    <section class="command card" aria-label={t("Orders")}>
      {panel.value === "fly" && !isPhone.value && <Places />}
      <Plan />
      <div class="acts">
        <Next />
        <PressButton label={t("Land here")} objection={landObjection} action={land}>
          <LandIcon />
          <span>{t("Land")}</span>
        </PressButton>
        {(iFly.value || me.value === 0) && (
          <PressButton label={t("Stay where it is")} objection={hoverObjection} action={hover}>
            <HoverIcon />
            <span>{t("Hover")}</span>
          </PressButton>
        )}
        <Opens name="fly" class="action">
          <PlaceIcon />
          <span>{t("Fly to …")}</span>
        </Opens>
        <Opens name="more" class="action">
          <MoreIcon />
          <span>{t("More")}</span>
        </Opens>
      </div>
      <Drawer />
      <NudgeHere />
    </section>
  );
}

interface Press {
  label: string;
  objection: ReadonlySignal<string>;
  action: (from: Element) => void;
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
      onClick={(event) => action(event.currentTarget)}
    >
      {children}
    </button>
  );
}

interface Step {
  hold: Hold;
  words: string;
  label: string;
  icon?: ComponentChildren;
}

/** What is held next, by the verdict and the goal that was chosen; null for nothing. */
const step = computed<Step | null>(() => {
  const wanted = verdict.value?.next_order ?? null;
  if (wanted === "resume")
    return {
      hold: resume,
      words: t("Resume"),
      label: t("Resume after STOP"),
      icon: <ResumeIcon />,
    };
  if (wanted === "reset")
    return {
      hold: reset,
      words: t("Reset"),
      label: t("Reset after a cut"),
      icon: <ResetIcon />,
    };
  const aim = goal.value;
  if (aim && (wanted === "service" || flying.value)) {
    const named = aim.place || aim.title !== POINT;
    const words = named
      ? t("Look at {place} and come back", { place: aim.title })
      : t("Look there and come back");
    return { hold: service, words, label: words };
  }
  const landedAway = wanted === "service" && verdict.value?.standing === "off the pad";
  if (wanted === "home" || landedAway)
    return {
      hold: landedAway ? flyHome : homeHeld,
      words: t("Fly home"),
      label: t("Fly home and land"),
      icon: <HomeIcon />,
    };
  if (wanted === "service")
    return { hold: service, words: t("Choose where to look"), label: t("Look and come back") };
  return null;
});

/** The next sensible thing. Its meaning changes only with a new button, never under a finger. */
function Next() {
  if (me.value !== 0 && !iFly.value && lineLives.value) return <Watching />;
  const next = lineLives.value ? step.value : null;
  if (!next) return <Nothing />;
  return (
    <HoldButton
      key={next.words}
      hold={next.hold}
      class={`primary ${next.hold === resume ? "resume" : ""}`}
      label={next.label}
    >
      {next.icon}
      <span>{next.words}</span>
      <small aria-hidden="true">{t("hold")}</small>
    </HoldButton>
  );
}

/** Nothing to hold: on the ground the way to the reasons, in the air what happens by itself. */
function Nothing() {
  if (flying.value || !lineLives.value || looking.value)
    return (
      <p class="primary said-only">{lineLives.value ? headline.value.text : t("No contact")}</p>
    );
  return (
    <button
      type="button"
      class="primary"
      aria-expanded={panel.value === "checks"}
      onClick={() => toggle("checks")}
    >
      {t("Not ready: see why")}
    </button>
  );
}

function Watching() {
  const who = verdict.value?.control;
  if (!who)
    return (
      <button type="button" class="primary" onClick={(e) => void takeOver(false, e.currentTarget)}>
        {t("Take control")}
      </button>
    );
  return (
    <p class="caption">
      <strong>{t("You watch.")}</strong>{" "}
      <span>{t("{who} has control; STOP and Land work.", { who })}</span>
    </p>
  );
}
