import { signal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useEffect } from "preact/hooks";
import { Opens } from "../controls/opens";
import { t } from "../messages/language";

const KEY = "housefly space";

/** Whether a graphics card draws in space here: without one the processor would be kept busy. */
function drawsEasily(): boolean {
  const context = document.createElement("canvas").getContext("webgl2");
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  const name = names && context!.getParameter(names.UNMASKED_RENDERER_WEBGL);
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return !!name && !/swiftshader|llvmpipe|software|basic render/i.test(name as string);
}

/** Whether the room is shown in space, in place of the plan: as somebody chose, or if it can. */
export const inSpace = signal((localStorage.getItem(KEY) ?? String(drawsEasily())) === "true");

function turn(): void {
  inSpace.value = !inSpace.value;
  localStorage.setItem(KEY, String(inSpace.value));
}

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

/** The past of the room and its flights, at the foot of the stage. */
export const EarlierButton = () => (
  <Opens name="past" class="earlier">
    {t("Earlier")}
  </Opens>
);

/** From the plan to the view in space, and back. */
export function SpaceButton() {
  return (
    <button
      type="button"
      class="to-space"
      onClick={turn}
    >
      {inSpace.value ? t("Plan") : t("3-D")}
    </button>
  );
}
