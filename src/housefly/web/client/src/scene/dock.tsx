import { computed } from "@preact/signals";
import { Orders } from "../controls/orders";
import { goal } from "../goal";
import { flying, hasDrone, lineLives, panel, verdict } from "../store";
import { Answer, Ask } from "./ask";
import { writing } from "./asked-words";
import { NoDrone } from "./no-drone";

/** Whether orders are what a person needs now; else it rests, and one asks. */
export const ordering = computed(() => {
  const open = panel.value;
  if (!hasDrone.value || open === "ask" || writing.value) return false;
  const { next_order, standing } = verdict.value ?? {};
  const isHome = (next_order ?? "service") === "service" && standing !== "off the pad";
  const rests = lineLives.value && !flying.value && isHome && goal.value === null;
  return !rests || open === "fly" || open === "more";
});

/** Beneath the stage, always as high: a question, or orders; an answer lies above it. */
export function Dock() {
  return (
    <div class="dock">
      {ordering.value ? <Orders /> : <Ask />}
      <Answer />
      {!hasDrone.value && <NoDrone />}
    </div>
  );
}
