import { createHold } from "../hold";
import { HoldButton } from "../controls/hold-button";
import { lookAt, serviceObjection } from "../commands";
import { answerBell, atTheDoor, bellAsks, door } from "./bell";

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
    <article class="question bell-card" aria-label="Doorbell">
      <p class="words" role="alert">
        {atTheDoor.value}
      </p>
      <p class="quiet">The bell rings. Hold to fly there and look; it comes home by itself.</p>
      <div class="choices">
        <HoldButton hold={look} class="primary" label={`Look who is at ${door.value?.title}`}>
          <span>Look</span>
          <small aria-hidden="true">hold</small>
        </HoldButton>
        <button type="button" class="secondary" onClick={answerBell}>
          Ignore
        </button>
      </div>
    </article>
  );
}
