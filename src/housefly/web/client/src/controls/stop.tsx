import { resume, stop } from "../commands";
import { flying, iFly, lineLives, screen, stopPress, verdict } from "../store";
import { sentence } from "../format";
import { HoldButton } from "./hold-button";
import { ResumeIcon, StopIcon } from "./icons";
import { t, translated } from "../messages/language";

/** How far STOP is, by the pilot's own word; and by this page's where nothing arrives. */
function progress(): { state: string; name: string; then: string } {
  const pressed = stopPress.value;
  const told = verdict.value?.stop;
  if (pressed.state === "failed")
    return { state: "failed", name: t("STOP FAILED"), then: sentence(pressed.words) };
  if (told?.progress === "confirmed") {
    const words = translated(told.words);
    const then = lineLives.value ? words : t("When this page last heard: {words}", { words });
    return { state: "confirmed", name: t("STOPPED"), then };
  }
  if (told?.progress === "failed")
    return { state: "failed", name: t("STOP FAILED"), then: sentence(translated(told.words)) };
  if (told?.progress === "sent")
    return { state: "sent", name: t("STOP sent"), then: translated(told.words) };
  if (pressed.state === "sending") return { state: "sent", name: "STOP", then: t("sending …") };
  return { state: "none", name: "STOP", then: t("hover at once and stay") };
}

/**
 * STOP: always in its corner, one press, for everybody; a whole bar when motors may turn.
 * Resume is beside it where no larger one is.
 */
export function StopBar() {
  const { state, name, then } = progress();
  const holds = (verdict.value?.stop.progress ?? "none") !== "none";
  return (
    <footer class="stopbar" data-whole={flying.value || !lineLives.value || state !== "none"}>
      <button
        type="button"
        class="stop"
        data-progress={state}
        onPointerDown={press}
        onClick={click}
      >
        <StopIcon />
        <span class="words">
          <strong>{name}</strong>
          <span class="then" role="status">
            {then}
          </span>
        </span>
        <kbd aria-hidden="true">{t("Space")}</kbd>
      </button>
      {holds && (screen.value !== "live" || !iFly.value) && (
        <HoldButton hold={resume} class="resume" label={t("Resume after STOP")}>
          <ResumeIcon />
          <span>{t("Resume")}</span>
          <small aria-hidden="true">{t("hold")}</small>
        </HoldButton>
      )}
    </footer>
  );
}

// STOP acts when the finger comes down; the click that follows must not send it twice.
let pressed = false;

function press(event: PointerEvent): void {
  if (event.button !== 0) return;
  pressed = true;
  void stop();
}

function click(): void {
  if (!pressed) void stop();
  pressed = false;
}
