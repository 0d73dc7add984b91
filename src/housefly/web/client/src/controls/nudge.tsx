import { hold, letGo, letGoOfAll, limit, moving, on, refused, type Push } from "./nudge-input";
import type { Key } from "../messages/en";
import { sentence } from "../format";
import { t, translated } from "../messages/language";

interface Way {
  name: Key;
  sign: string;
  area: string;
  push: Push;
}

const WAYS: Way[] = [
  { name: "Up the map", sign: "▲", area: "up", push: [0, 1, 0] },
  { name: "Left on the map", sign: "◀", area: "left", push: [-1, 0, 0] },
  { name: "Right on the map", sign: "▶", area: "right", push: [1, 0, 0] },
  { name: "Down the map", sign: "▼", area: "down", push: [0, -1, 0] },
  { name: "Climb", sign: "⤒", area: "climb", push: [0, 0, 1] },
  { name: "Sink", sign: "⤓", area: "sink", push: [0, 0, -1] },
];

/** Move a hovering drone for as long as something is held. */
export function Nudge() {
  return (
    <div class="nudge" role="group" aria-label={t("Move by hand")} data-on={on.value}>
      <button
        type="button"
        class="toggle"
        role="switch"
        aria-checked={on.value}
        onClick={() => (on.value = !on.value)}
      >
        {t("Move by hand")}
      </button>
      {on.value && (
        <>
          <div class="ways">
            {WAYS.map((way) => (
              <WayButton key={way.area} {...way} />
            ))}
          </div>
          <p class="says" role="status">
            {words()}
          </p>
        </>
      )}
    </div>
  );
}

function words(): string {
  if (refused.value) return sentence(translated(refused.value));
  if (limit.value) return sentence(translated(limit.value));
  return moving.value
    ? t("Moving while you hold.")
    : t("Hovering. Hold an arrow, W A S D or a stick.");
}

function WayButton({ name, sign, area, push }: Way) {
  const end = (): void => letGo(area);
  return (
    <button
      type="button"
      class="way"
      style={{ gridArea: area }}
      aria-label={t(name)}
      title={t(name)}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        hold(area, push);
      }}
      onPointerUp={end}
      onPointerCancel={letGoOfAll}
      onLostPointerCapture={end}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => event.key === "Enter" && hold(area, push)}
      onKeyUp={(event) => event.key === "Enter" && end()}
      onBlur={end}
    >
      {sign}
    </button>
  );
}
