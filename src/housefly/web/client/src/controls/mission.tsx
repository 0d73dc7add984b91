import { go, hint, service } from "../commands";
import { choosePlace, forgetGoal, goal } from "../goal";
import { explanation } from "../preflight";
import { notice, room } from "../store";
import { HoldButton } from "./hold-button";

/** Where to, how, and the two ways to send the drone there. */
export function Mission() {
  return (
    <div class="mission">
      <Places />
      <Plan />
      <div class="send">
        <HoldButton hold={service} class="primary" label="Send to look and come back">
          <span>Send to look and come back</span>
          <small>hold</small>
        </HoldButton>
        <HoldButton hold={go} class="secondary" label="Fly there and stay">
          <span>Fly there and stay</span>
          <small>hold</small>
        </HoldButton>
      </div>
    </div>
  );
}

function Places() {
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

function Plan() {
  return (
    <div class="plan" role="status">
      <p class="way">
        <Way />
      </p>
      <p class="why">
        {explanation.value || notice.value || hint.value || goal.value?.note || clearance()}
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
  const name = aim.place
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
