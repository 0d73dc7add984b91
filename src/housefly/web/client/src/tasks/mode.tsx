import { signal } from "@preact/signals";
import { sentence } from "../format";
import { board, running } from "./board";
import { setMode } from "./tasks-client";
import type { HouseMode } from "../wire/task-messages";

const MODES: HouseMode[] = ["home", "away", "night", "privacy", "maintenance"];
const words = signal("");

async function choose(mode: HouseMode): Promise<void> {
  try {
    words.value = (await setMode(mode)).words;
  } catch (error) {
    words.value = `△ ${(error as Error).message}`;
  }
}

/** The mode of the house, and what it allows. */
export function Mode() {
  return (
    <section class="card house-mode" aria-label="Mode of the house">
      <h2>Mode of the house</h2>
      <div class="modes" role="group" aria-label="Mode">
        {MODES.map((mode) => (
          <button
            type="button"
            key={mode}
            aria-pressed={running.value && board.value?.mode === mode}
            aria-disabled={!running.value}
            onClick={() => void choose(mode)}
          >
            {mode}
          </button>
        ))}
      </div>
      <p class="quiet" role="status">
        {words.value && sentence(words.value)}
      </p>
    </section>
  );
}
