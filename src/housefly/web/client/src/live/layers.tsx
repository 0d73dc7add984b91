// What the live map shows beside the room itself; kept over a reload.
import { effect, signal } from "@preact/signals";
import { open } from "../store";
import { EarlierButton, SpaceButton } from "../view3d/space-button";
import { toggleCoverage } from "./room-client";
import { showsCoverage } from "./store";
import { t } from "../messages/language";

const KEY = "housefly layers";
const known: Record<string, boolean> = JSON.parse(localStorage.getItem(KEY) ?? "{}");

export const showsThings = signal(known["things"] ?? true);
export const showsMargins = signal(known["margins"] ?? false);

effect(() => {
  const kept = { things: showsThings.value, margins: showsMargins.value };
  localStorage.setItem(KEY, JSON.stringify(kept));
});

export function CoverageButton() {
  return (
    <button
      type="button"
      aria-pressed={showsCoverage.value}
      onClick={() => void toggleCoverage()}
    >
      {t("Tracking coverage")}
    </button>
  );
}

/** Layers of the map, and the way to editing it. */
export function Layers() {
  return (
    <details class="layers">
      <summary>{t("Layers")}</summary>
      <div>
        <button
          type="button"
          aria-pressed={showsThings.value}
          onClick={() => (showsThings.value = !showsThings.value)}
        >
          {t("People and things")}
        </button>
        <button
          type="button"
          aria-pressed={showsMargins.value}
          onClick={() => (showsMargins.value = !showsMargins.value)}
        >
          {t("Safety margins")}
        </button>
        <CoverageButton />
        <SpaceButton />
        <EarlierButton />
        <button type="button" onClick={() => open("edit")}>
          {t("Edit the room")}
        </button>
      </div>
    </details>
  );
}
