import { signal } from "@preact/signals";
import { sentence } from "../format";
import { Told } from "../messages/told";
import { board, running } from "./board";
import { setMode } from "./tasks-client";
import type { HouseMode } from "../wire/task-messages";
import { t, translated } from "../messages/language";

export const MODES: HouseMode[] = ["home", "away", "night", "privacy", "maintenance"];
const words = signal("");

async function choose(mode: HouseMode): Promise<void> {
  try {
    words.value = (await setMode(mode)).words;
  } catch (error) {
    words.value = (error as Error).message;
  }
}

/** The mode of the house, and what it allows. */
export function Mode() {
  return (
    <section class="card house-mode" aria-label={t("Mode of the house")}>
      <h2>{t("Mode of the house")}</h2>
      <div class="modes" role="group" aria-label={t("Mode")}>
        {MODES.map((mode) => (
          <button
            type="button"
            key={mode}
            aria-pressed={running.value && board.value?.mode === mode}
            aria-disabled={!running.value}
            onClick={() => void choose(mode)}
          >
            {t(`${mode}^mode`)}
          </button>
        ))}
      </div>
      <p class="quiet" role="status">
        <Told words={words.value && sentence(translated(words.value))} />
      </p>
    </section>
  );
}
