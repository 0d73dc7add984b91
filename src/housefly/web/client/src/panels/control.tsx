import { givesControl, takeControl, takeOver } from "../commands";
import { HoldButton } from "../controls/hold-button";
import { ThisDevice } from "../device/this-device";
import { refuse } from "../said";
import { flying, iFly, me, panel, toggle, verdict, viewers } from "../store";
import { ask, myName, rename } from "../wire/socket";

/** Who is here, who has control, and how it changes hands. */
export function Control() {
  if (panel.value !== "control") return null;
  return (
    <section class="sheet" role="dialog" aria-label="Control">
      <h2>Control</h2>
      <p class="quiet">
        One person has control. Everybody else watches, and can still stop or land the drone.
      </p>
      <label class="field">
        Your name
        <input
          type="text"
          maxLength={24}
          value={myName()}
          placeholder={`Viewer ${me.value}`}
          onChange={(event) => rename(event.currentTarget.value.trim())}
        />
      </label>
      <ul class="people">
        {viewers.value.viewers.map((one) => (
          <li key={one.id}>
            <span>
              {one.name}
              {one.id === me.value && " (you)"}
            </span>
            {verdict.value?.pilot === one.id && <strong>has control</strong>}
            {iFly.value && one.id !== me.value && (
              <button type="button" class="quiet-button" onClick={() => void lease("give", one.id)}>
                Hand over
              </button>
            )}
          </li>
        ))}
      </ul>
      <div class="row">
        <Take />
        <button type="button" class="quiet-button" onClick={() => toggle("invite")}>
          Invite
        </button>
        <button type="button" class="quiet-button" onClick={() => (panel.value = "")}>
          Close
        </button>
      </div>
      <ThisDevice />
    </section>
  );
}

function Take() {
  if (iFly.value) {
    return (
      <button type="button" class="quiet-button" onClick={() => void lease("release", 0)}>
        Release control
      </button>
    );
  }
  if (flying.value && verdict.value?.pilot != null) {
    return (
      <HoldButton hold={takeControl} class="secondary" label="Take over control">
        <span>Take over</span>
        <small aria-hidden="true">hold</small>
      </HoldButton>
    );
  }
  return (
    <button type="button" class="quiet-button" onClick={() => void takeOver(false)}>
      Take control
    </button>
  );
}

async function lease(action: "release" | "give", to: number): Promise<void> {
  givesControl();
  const answer = await ask({ type: "lease", action, to });
  if (answer.type === "refused") refuse(answer.reason, null);
}
