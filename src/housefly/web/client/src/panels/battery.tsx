import { room, state, stateAge, freshness } from "../store";
import { minutes, percent } from "../format";

/** Charge in three parts: what is free to use, what the way home costs, what landing needs. */
export function Battery() {
  const charge = state.value?.battery ?? 0;
  const floor = room.value?.limits.battery_floor ?? 0;
  const home = Math.min(Math.max(0, charge - floor), state.value?.battery_return ?? 0);
  const usable = Math.max(0, charge - floor - home);
  const seconds = state.value?.flight_s;
  const known = state.value?.battery != null;
  const parts = [
    { kind: "land", share: Math.min(charge, floor), words: "to land" },
    { kind: "home", share: home, words: "to come home" },
    { kind: "usable", share: usable, words: "usable" },
  ];
  const spoken = parts.map((part) => `${percent(part.share)} ${part.words}`).join(", ");
  return (
    <div class="card battery" data-age={freshness(stateAge.value)}>
      <div class="row">
        <h2>Battery</h2>
        <span class="number">{known ? percent(charge) : "–"}</span>
        <span class="quiet">
          {known && seconds != null ? `about ${minutes(seconds)} of flight` : ""}
        </span>
      </div>
      <div
        class="bar"
        role="img"
        aria-label={known ? `Battery ${percent(charge)}: ${spoken}` : "Battery unknown"}
      >
        {parts.map((part) => (
          <span key={part.kind} class={part.kind} style={{ width: `${100 * part.share}%` }} />
        ))}
      </div>
      <div class="legend">
        <span class="land">land {percent(floor)}</span>
        <span class="home">home {percent(home)}</span>
        <span class="usable">usable {percent(usable)}</span>
      </div>
    </div>
  );
}
