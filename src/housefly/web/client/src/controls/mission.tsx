import { hint } from "../commands";
import { choosePlace, forgetGoal, goal, POINT } from "../goal";
import { notice, panel, room } from "../store";
import { decimal, t } from "../messages/language";

/** What may be looked at, each one tap. */
export function Places() {
  // Home has a button of its own.
  const places = (room.value?.places ?? []).filter((place) => place.name !== "home");
  return (
    <div class="places" role="group" aria-label={t("Places")}>
      {places.map((place) => (
        <button
          type="button"
          class="place"
          key={place.name}
          aria-pressed={goal.value?.place === place.name}
          onClick={() => {
            choosePlace(place);
            panel.value = "";
          }}
        >
          {place.title}
        </button>
      ))}
    </div>
  );
}

/** How it would fly there, or why it would not. */
export function Plan() {
  return (
    <div class="plan" role="status">
      <div class="way">
        <Way />
      </div>
      <p class="why">
        {notice.value || hint.value || goal.value?.note || clearance()}
      </p>
    </div>
  );
}

function clearance(): string {
  const way = goal.value?.plan?.path;
  return way
    ? t("The path keeps {d} m away from everything.", { d: decimal(way.clearance, 2) })
    : "";
}

function Way() {
  const aim = goal.value;
  if (!aim) return <span class="quiet">{t("Where to?")}</span>;
  const way = aim.plan?.path;
  const name =
    aim.place || aim.title !== POINT
      ? aim.title
      : t("Point {x}, {y} m", { x: decimal(aim.point[0], 1), y: decimal(aim.point[1], 1) });
  return (
    <>
      <strong>{name}</strong>
      {way && (
        <span>
          {decimal(way.length, 1)} m · {Math.round(aim.plan!.duration)} s
        </span>
      )}
      <button type="button" class="clear" aria-label={t("Forget this goal")} onClick={forgetGoal}>
        ×
      </button>
    </>
  );
}
