import { freshness, poseAge, room, state } from "../store";
import { decimal, t } from "../messages/language";

const TICK = 0.5;

/** How high the drone is: floor at the bottom, the highest allowed height at the top. */
export function HeightStrip() {
  const top = room.value?.limits.height_max ?? 2;
  const height = state.value?.position?.[2] ?? null;
  const wanted = room.value?.flight_height ?? null;
  const share = (metres: number): string =>
    `${(100 * Math.min(1, Math.max(0, metres / top))).toFixed(1)}%`;
  const ticks = Array.from({ length: Math.floor(top / TICK) + 1 }, (_, k) => k * TICK);
  return (
    <div
      class="height"
      role="img"
      aria-label={
        height === null ? t("Height unknown") : t("Height {d} metres", { d: decimal(height, 1) })
      }
      data-age={freshness(poseAge.value)}
    >
      <span class="value">{height === null ? "–" : decimal(height, 2)}</span>
      <div class="tube">
        {ticks.map((tick) => (
          <span key={tick} class="tick" style={{ bottom: share(tick) }}>
            {Number.isInteger(tick) ? tick : ""}
          </span>
        ))}
        <span class="column" style={{ height: share(height ?? 0) }} />
        {wanted !== null && (
          <span class="wanted" style={{ bottom: share(wanted) }} title={t("Flight height")} />
        )}
      </div>
      <span class="unit">m</span>
    </div>
  );
}
