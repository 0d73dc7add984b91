import { computed } from "@preact/signals";
import { poseFreshness, room, state } from "../store";
import { decimal, t } from "../messages/language";

const TICK = 0.5;

const CENTIMETRES = 100;
/** The drone's height to the centimetre [m], so that nothing is drawn anew for less. */
const height = computed(() => {
  const metres = state.value?.position?.[2];
  return metres === undefined ? null : Math.round(CENTIMETRES * metres) / CENTIMETRES;
});
const top = computed(() => room.value?.limits.height_max ?? 2);
const share = (metres: number): number => Math.min(1, Math.max(0, metres / top.value));
const above = (metres: number): string => `${(100 * share(metres)).toFixed(1)}%`;

/** How high the drone is: floor at the bottom, the highest allowed height at the top. */
export function HeightStrip() {
  return (
    <div
      class="height"
      role="img"
      aria-label={spoken.value}
      data-age={poseFreshness.value}
    >
      <Value />
      <div class="tube">
        <Ticks />
        <Column />
      </div>
      <span class="unit">m</span>
    </div>
  );
}

const spoken = computed(() =>
  height.value === null
    ? t("Height unknown")
    : t("Height {d} metres", { d: decimal(height.value, 1) }),
);

const Value = () => (
  <span class="value">{height.value === null ? "–" : decimal(height.value, 2)}</span>
);

const Column = () => (
  <span class="column" style={{ transform: `scaleY(${share(height.value ?? 0)})` }} />
);

function Ticks() {
  const ticks = Array.from({ length: Math.floor(top.value / TICK) + 1 }, (_, k) => k * TICK);
  const wanted = room.value?.flight_height ?? null;
  return (
    <>
      {ticks.map((tick) => (
        <span key={tick} class="tick" style={{ bottom: above(tick) }}>
          {Number.isInteger(tick) ? tick : ""}
        </span>
      ))}
      {wanted !== null && (
        <span class="wanted" style={{ bottom: above(wanted) }} title={t("Flight height")} />
      )}
    </>
  );
}
