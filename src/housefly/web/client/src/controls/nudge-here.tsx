// Whether the drone may be moved by hand now; the code for it is fetched when it first may.
import { computed, signal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useEffect } from "preact/hooks";
import { flying, iFly, lineLives, room, verdict } from "../store";

const loaded = signal<(() => ComponentChild) | null>(null);

/** Whether the site allows it, the drone holds its place, and this page has control. */
export const offered = computed(() => {
  const isAllowed = (room.value?.limits["nudge_speed"] ?? 0) > 0;
  const objections = verdict.value?.orders ?? [];
  const isOpen = iFly.value && lineLives.value && flying.value;
  return isAllowed && isOpen && !objections.some((one) => one.order === "nudge");
});

export function NudgeHere() {
  return offered.value ? <Fetched /> : null;
}

function Fetched() {
  useEffect(() => {
    if (!loaded.peek())
      // Without contact there is nothing to move; the next hover asks again.
      import("./nudge").then(
        (code) => (loaded.value = code.Nudge),
        () => undefined,
      );
  }, []);
  const Nudge = loaded.value;
  return Nudge ? <Nudge /> : null;
}
