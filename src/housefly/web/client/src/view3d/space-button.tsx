import { signal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useEffect } from "preact/hooks";
import { t } from "../messages/language";

/** Whether the room is shown in space, in place of the plan. */
export const inSpace = signal(false);
const loaded = signal<(() => ComponentChild) | null>(null);
const failed = signal("");

/** The room in space; its code is fetched when somebody wants it, for it is ten times the rest. */
export function RoomInSpace() {
  useEffect(() => {
    failed.value = "";
    import("./room-in-space").then(
      (code) => (loaded.value = code.SpaceView),
      () => 
        (failed.value = t("The view in space could not be fetched: no contact with the server.")),
    );
  }, []);
  const View = loaded.value;
  return (
    <div class="plan-view space-view">
      {View ? <View /> : <p class="veil">{failed.value || t("Fetching the view in space …")}</p>}
    </div>
  );
}

/** From the plan to the view in space, and back. */
export function SpaceButton() {
  return (
    <button
      type="button"
      class="to-space"
      aria-pressed={inSpace.value}
      onClick={() => (inSpace.value = !inSpace.value)}
    >
      {inSpace.value ? t("Plan") : t("3-D")}
    </button>
  );
}
