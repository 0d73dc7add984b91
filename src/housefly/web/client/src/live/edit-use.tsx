// What was saved comes into use at once: the pilot starts again, which it does only on the ground.
import { computed, effect, signal } from "@preact/signals";
import { HoldButton } from "../controls/hold-button";
import { createHold } from "../hold";
import { room, verdict } from "../store";
import type { RoomView } from "../wire/messages";
import { busy, changed, editObjection, load, putIntoUse, saved, tell, trouble } from "./edits";
import { t } from "../messages/language";

const HOLD = 0.6;
/** After this time something is wrong [s]. */
const PATIENCE = 90;

/** The room that the old pilot told; null while nobody starts anything again. */
const before = signal<RoomView | null>(null);
let timer = 0;

/** Why the pilot may not be started again now, or "": the server and the pilot look again. */
const standing = computed(() => {
  const now = verdict.value;
  if (now?.airborne)
    return t("In the air the drone keeps the map that it took off with: land first.");
  if (!now || now.may_be_airborne || now.airborne === null)
    return t("Nobody knows whether the drone flies: the new map waits.");
  return "";
});

const objection = computed(
  () => editObjection.value || standing.value || (busy.value ? t("That is being done.") : ""),
);

const hold = createHold(HOLD, objection, () => void begin());

async function begin(): Promise<void> {
  const old = room.peek();
  await putIntoUse();
  if (trouble.peek() || !old) return;
  before.value = old;
  timer = window.setTimeout(() => {
    before.value = null;
    tell(t("The pilot has not come back. The terminal of Housefly says why."));
  }, 1000 * PATIENCE);
}

// A pilot that has started again tells its room, with the new places and zones in it.
effect(() => {
  if (!before.value || room.value === before.value) return;
  clearTimeout(timer);
  before.value = null;
  void load().then(() => saved.peek()?.in_use && tell(t("In use: the drone has this map now.")));
});

/** Offered after Save, while the drone stands; in the air it is said why not. */
export function UseNow() {
  const view = saved.value;
  if (before.value)
    return (
      <p role="status">
        <strong>{t("The pilot starts again.")}</strong> {t("No flight meanwhile.")}
      </p>
    );
  if (!view || view.in_use || !view.use_time || changed.value) return null;
  if (standing.value) return <p class="quiet">{standing.value}</p>;
  return (
    <div class="chips use-now">
      <HoldButton hold={hold} label={t("Use it now")}>
        <span>{t("Use it now")}</span>
        <small aria-hidden="true">{t("hold")}</small>
      </HoldButton>
      <p class="quiet">
        {t("The pilot starts again, about {n} s. No flight meanwhile.", {
          n: Math.round(view.use_time),
        })}
      </p>
    </div>
  );
}
