import { computed } from "@preact/signals";
import { room, state, stateFreshness } from "../store";
import { minutes, percent } from "../format";
import { t } from "../messages/language";

const MILLES = 1000;
/** To a thousandth, so that nothing is drawn anew for less. */
const rounded = (share: number): number => Math.round(MILLES * share) / MILLES;
const known = computed(() => state.value?.battery != null);
const charge = computed(() => rounded(state.value?.battery ?? 0));
const wayHome = computed(() => rounded(state.value?.battery_return ?? 0));
const left = computed(() => {
  const seconds = state.value?.flight_s;
  return known.value && seconds != null ? minutes(seconds) : "";
});

/** Charge in three parts: what is free to use, what the way home costs, what landing needs. */
export function Battery() {
  const floor = room.value?.limits.battery_floor ?? 0;
  const home = Math.min(Math.max(0, charge.value - floor), wayHome.value);
  const landing = Math.min(charge.value, floor);
  const usable = Math.max(0, charge.value - floor - home);
  const parts = [
    { kind: "land", share: landing, words: t("{p} to land", { p: percent(landing) }) },
    { kind: "home", share: home, words: t("{p} to come home", { p: percent(home) }) },
    { kind: "usable", share: usable, words: t("{p} usable", { p: percent(usable) }) },
  ];
  const spoken = parts.map((part) => part.words).join(", ");
  return (
    <div class="card battery" data-age={stateFreshness.value}>
      <div class="row">
        <h2>{t("Battery")}</h2>
        <span class="number">{known.value ? percent(charge.value) : "–"}</span>
        <span class="quiet">
          {left.value && t("about {time} of flight", { time: left.value })}
        </span>
      </div>
      <div
        class="bar"
        role="img"
        aria-label={
          known.value
            ? `${t("Battery")} ${percent(charge.value)}: ${spoken}`
            : t("Battery unknown")
        }
      >
        {parts.map((part) => (
          <span key={part.kind} class={part.kind} style={{ width: `${100 * part.share}%` }} />
        ))}
      </div>
      <div class="legend">
        <span class="land">{t("land {p}", { p: percent(floor) })}</span>
        <span class="home">{t("home {p}", { p: percent(home) })}</span>
        <span class="usable">{t("usable {p}", { p: percent(usable) })}</span>
      </div>
    </div>
  );
}
