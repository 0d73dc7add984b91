import { mayGoDark } from "../wake-lock";
import { install, installing } from "./install";
import { notifies, permission, switchOff, switchOn } from "./notify";
import { canSound } from "./sounds";

/** What this phone or computer does for whoever holds it: rings, stays awake, has an app. */
export function ThisDevice() {
  const how = installing();
  return (
    <section class="device" aria-label="This device">
      <h3>This device</h3>
      <label class="choice">
        <input
          type="checkbox"
          checked={notifies.value}
          onChange={(event) => (event.currentTarget.checked ? void switchOn() : switchOff())}
        />
        Ring for the doorbell and for faults
      </label>
      {notifies.value && <p class="quiet">{ringing()}</p>}
      {how === "offered" && (
        <button type="button" class="quiet-button" onClick={() => void install()}>
          Install as an app
        </button>
      )}
      {how === "by hand" && <p class="quiet">As an app: Share, then Add to Home Screen.</p>}
      {mayGoDark.value && (
        <p class="quiet">This browser does not keep the screen on while the drone flies.</p>
      )}
    </section>
  );
}

function ringing(): string {
  const sound = canSound.value ? "It sounds" : "It sounds from your next touch on,";
  const here = `${sound} while the page is open`;
  if (permission.value === "granted") return `${here}, and notifies beside other pages.`;
  if (permission.value === "denied")
    return `${here}. Notifications are forbidden: its settings in the browser allow them.`;
  return `${here}.`;
}
