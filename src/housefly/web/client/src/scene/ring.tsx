import { signal } from "@preact/signals";
import { sentence } from "../format";
import { hint } from "../said";
import { simulated } from "../store";
import { pressBell } from "../tasks/tasks-client";
import { t, translated } from "../messages/language";

const pressing = signal(false);

/** The bell of a simulated room: somebody comes and rings, and what the house does is said. */
async function ring(from: Element): Promise<void> {
  if (pressing.value) return;
  pressing.value = true;
  try {
    const { rung, words } = await pressBell();
    hint(`${rung ? "" : "△ "}${sentence(translated(words))}`, from);
  } catch (error) {
    hint(`△ ${translated((error as Error).message)}`, from);
  }
  pressing.value = false;
}

export function RingButton() {
  if (!simulated.value) return null;
  return (
    <button
      type="button"
      class="ring"
      aria-disabled={pressing.value}
      onClick={(event) => void ring(event.currentTarget)}
    >
      <BellIcon />
      <span>{t("Ring the doorbell")}</span>
    </button>
  );
}

const BellIcon = () => (
  <svg viewBox="0 0 24 24" width="22" height="22" aria-hidden="true">
    <path
      fill="currentColor"
      d="M12 2a2 2 0 0 1 2 2v.4a6 6 0 0 1 4 5.6v5l2 3H4l2-3v-5a6 6 0 0 1 4-5.6V4a2 2 0 0 1 2-2z"
    />
    <path fill="currentColor" d="M9.5 19.5h5a2.5 2.5 0 0 1-5 0z" />
  </svg>
);
