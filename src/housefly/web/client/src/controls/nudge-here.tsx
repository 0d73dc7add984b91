// Whether the drone may be moved by hand now.
import { computed } from "@preact/signals";
import { lazyPart } from "../lazy-part";
import { flying, iFly, lineLives, room, verdict } from "../store";

const Nudge = lazyPart(async () => (await import("../later")).Nudge);

/** Whether the site allows it, the drone holds its place, and this page has control. */
export const offered = computed(() => {
  const isAllowed = (room.value?.limits["nudge_speed"] ?? 0) > 0;
  const objections = verdict.value?.orders ?? [];
  const isOpen = iFly.value && lineLives.value && flying.value;
  return isAllowed && isOpen && !objections.some((one) => one.order === "nudge");
});

export function NudgeHere() {
  return offered.value ? <Nudge /> : null;
}
