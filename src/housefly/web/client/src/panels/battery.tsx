import { room, state, stateAge, freshness } from "../store";
import { minutes, percent } from "../format";
import { t } from "../messages/language";

/** Charge in three parts: what is free to use, what the way home costs, what landing needs. */
export function Battery() {
  const charge = state.value?.battery ?? 0;
  const floor = room.value?.limits.battery_floor ?? 0;
  const home = Math.min(Math.max(0, charge - floor), state.value?.battery_return ?? 0);
  const landing = Math.min(charge, floor);
  const usable = Math.max(0, charge - floor - home);
  const seconds = state.value?.flight_s;
  const known = state.value?.battery != null;
  const parts = [
    { kind: "land", share: landing, words: t("{p} to land", { p: percent(landing) }) },
    { kind: "home", share: home, words: t("{p} to come home", { p: percent(home) }) },
    { kind: "usable", share: usable, words: t("{p} usable", { p: percent(usable) }) },
  ];
  const spoken = parts.map((part) => part.words).join(", ");
  return (
    <div class="card battery" data-age={freshness(stateAge.value)}>
      <div class="row">
        <h2>{t("Battery")}</h2>
        <span class="number">{known ? percent(charge) : "–"}</span>
        <span class="quiet">
          {known && seconds != null ? t("about {time} of flight", { time: minutes(seconds) }) : ""}
        </span>
      </div>
      <div
        class="bar"
        role="img"
        aria-label={known ? `${t("Battery")} ${percent(charge)}: ${spoken}` : t("Battery unknown")}
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
