import { hint } from "../commands";
import { choosePlace, forgetGoal, goal, POINT } from "../goal";
import { said } from "../said";
import { notice, room } from "../store";

/** What may be looked at, each one tap. */
export function Places() {
  // Home has a button of its own.
  const places = (room.value?.places ?? []).filter((place) => place.name !== "home");
  return (
    <div class="places" role="group" aria-label="Places">
      {places.map((place) => (
        <button
          type="button"
          class="place"
          key={place.name}
          aria-pressed={goal.value?.place === place.name}
          onClick={() => choosePlace(place)}
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
        {said.value?.words || notice.value || hint.value || goal.value?.note || clearance()}
      </p>
    </div>
  );
}

function clearance(): string {
  const way = goal.value?.plan?.path;
  return way ? `The path keeps ${way.clearance.toFixed(2)} m away from everything.` : "";
}

function Way() {
  const aim = goal.value;
  if (!aim) return <span class="quiet">Where to?</span>;
  const way = aim.plan?.path;
  const name =
    aim.place || aim.title !== POINT
      ? aim.title
      : `Point ${aim.point[0].toFixed(1)}, ${aim.point[1].toFixed(1)} m`;
  return (
    <>
      <strong>{name}</strong>
      {way && (
        <span>
          {way.length.toFixed(1)} m · {Math.round(aim.plan!.duration)} s
        </span>
      )}
      <button type="button" class="clear" aria-label="Forget this goal" onClick={forgetGoal}>
        ×
      </button>
    </>
  );
}
