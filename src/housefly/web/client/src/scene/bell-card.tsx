import { createHold } from "../hold";
import { HoldButton } from "../controls/hold-button";
import { lookAt, serviceObjection } from "../commands";
import { answerBell, atTheDoor, bellAsks, door } from "./bell";
import { t } from "../messages/language";

const HOLD = 0.6;
const look = createHold(HOLD, serviceObjection, (from) => {
  if (!door.value) return;
  void lookAt(door.value.name, from);
  answerBell();
});

/** Somebody rang and no rule cares: one hold looks who it is. */
export function BellCard() {
  if (!bellAsks.value) return null;
  return (
    <article class="question bell-card" aria-label={t("Doorbell")}>
      <p class="words" role="alert">
        {atTheDoor.value}
      </p>
      <p class="quiet">
        {t("The bell rings. Hold to fly there and look; it comes home by itself.")}
      </p>
      <div class="choices">
        <HoldButton
          hold={look}
          class="primary"
          label={t("Look who is at {place}", { place: door.value?.title ?? "" })}
        >
          <span>{t("Look^order")}</span>
          <small aria-hidden="true">{t("hold")}</small>
        </HoldButton>
        <button type="button" class="secondary" onClick={answerBell}>
          {t("Ignore")}
        </button>
      </div>
    </article>
  );
}
