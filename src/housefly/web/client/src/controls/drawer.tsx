import { computed } from "@preact/signals";
import { cutMotors, go, homeHeld, reset, takeOff } from "../commands";
import { goal } from "../goal";
import { cut, flying, panel, verdict } from "../store";
import { HoldButton } from "./hold-button";
import { CutIcon, HomeIcon, ResetIcon, TakeOffIcon } from "./icons";
import { t } from "../messages/language";

const notReady = computed(() => verdict.value?.may_take_off === false && !flying.value);

/** Orders that are rarely meant; to cut the motors is red, the last, and says what follows. */
export function Drawer() {
  if (panel.value !== "more") return null;
  return (
    <div class="drawer" role="group" aria-label={t("More orders")}>
      {goal.value && (
        <HoldButton hold={go} class="action" label={t("Fly there and stay")}>
          <span>{t("Fly there and stay")}</span>
          <small aria-hidden="true">{t("hold")}</small>
        </HoldButton>
      )}
      {cut.value ? (
        <HoldButton hold={reset} class="action" label={t("Reset after a cut")}>
          <ResetIcon />
          <span>{t("Reset")}</span>
          <small aria-hidden="true">{t("hold")}</small>
        </HoldButton>
      ) : (
        <HoldButton hold={takeOff} class="action" label={t("Take off")}>
          <TakeOffIcon />
          <span>{t("Take off")}</span>
          <small aria-hidden="true">{notReady.value ? t("not ready") : t("hold")}</small>
        </HoldButton>
      )}
      <HoldButton hold={homeHeld} class="action" label={t("Fly home and land")}>
        <HomeIcon />
        <span>{t("Home")}</span>
        <small aria-hidden="true">{t("hold")}</small>
      </HoldButton>
      <HoldButton hold={cutMotors} class="cut" label={t("Cut motors: motors stop, drone falls")}>
        <CutIcon />
        <span>{t("Cut motors")}</span>
        <small>{t("it falls, hold 1 s")}</small>
      </HoldButton>
      <button type="button" class="action" onClick={() => (panel.value = "")}>
        {t("Close")}
      </button>
    </div>
  );
}
