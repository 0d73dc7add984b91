import { useEffect } from "preact/hooks";
import { PlanFrame } from "../map/map";
import { RoomLayer } from "../map/room";
import { CoverageLayer, CoverageLegend } from "./coverage";
import { EditLayer } from "./edit-layer";
import { EditPanel } from "./edit-panel";
import { changed, editing, toggleEditing } from "./edits";
import { Find } from "./find";
import { Events, History, PastBanner } from "./history";
import { listen, toggleCoverage } from "./room-client";
import { Sensors } from "./sensors";
import { at, nameOf, hindering, showsCoverage, situations, trouble } from "./store";
import { ObstacleLayer, placeless, ThingsLayer } from "./things";
import { Readiness } from "../panels/preflight";
import { percent } from "../format";
import { isWorry, worthSaying } from "./words";

/** The room: where everything is, how we know, and how it was before. */
export function RoomScreen() {
  useEffect(listen, []);
  const edits = editing.value;
  return (
    <main class="room-deck" data-editing={edits}>
      <Readiness />
      {!edits && <Find />}
      <section
        class="view map live"
        aria-label="Live map of the room"
        data-past={at.value !== null}
        data-coverage={showsCoverage.value}
        data-editing={edits}
      >
        <PlanFrame
          label={
            edits
              ? "Floor plan being edited. The list of places and zones follows."
              : "Floor plan with people and things. Each can be reached with Tab."
          }
        >
          {(to) => (
            <>
              <RoomLayer to={to} visitors={false} />
              <CoverageLayer to={to} />
              {edits ? (
                <EditLayer to={to} />
              ) : (
                <>
                  <ObstacleLayer to={to} />
                  <ThingsLayer to={to} />
                </>
              )}
            </>
          )}
        </PlanFrame>
        <Notes />
        <PastBanner />
      </section>
      {edits ? (
        <EditPanel />
      ) : (
        <>
          <History />
          <Events>
            <Holds />
          </Events>
          <Sensors />
        </>
      )}
    </main>
  );
}

function Notes() {
  const lost = placeless();
  return (
    <ul class="legend" aria-label="Legend">
      <li class="plain">
        <button
          type="button"
          aria-pressed={showsCoverage.value}
          onClick={() => void toggleCoverage()}
        >
          Tracking coverage
        </button>
      </li>
      <li class="plain">
        <button type="button" aria-pressed={editing.value} onClick={toggleEditing}>
          Edit{changed.value ? " (not saved)" : ""}
        </button>
      </li>
      <CoverageLegend />
      {editing.value && <li class="virtual">kept free by order</li>}
      {editing.value && <li class="inflated">too close</li>}
      {!editing.value && lost.length > 0 && (
        <li class="plain">
          Place unknown: {lost.map((one) => `${one.name} (in ${nameOf(one.inside)})`).join(", ")}
        </li>
      )}
      {trouble.value && (
        <li class="trouble" role="alert">
          △ {trouble.value}
        </li>
      )}
    </ul>
  );
}

/** What holds now, in words: the map says the same beside the people. */
function Holds() {
  if (at.value !== null || (situations.value.length === 0 && hindering.value === 0)) return null;
  return (
    <ul class="holds" aria-label="What holds now">
      {worthSaying(situations.value).map((one) => (
        <li key={`${one.kind} ${one.thing}`} class={isWorry(one.kind) ? "worry" : "plain"}>
          <strong>
            {isWorry(one.kind) && "△ "}
            {nameOf(one.thing)}: {one.kind.replace(/^person /, "")}
          </strong>
          <span class="quiet">
            {percent(one.confidence)} sure{one.evidence && `; ${one.evidence}`}
          </span>
        </li>
      ))}
      {hindering.value > 0 && <li class="quiet">{hindering.value} in the way of the drone</li>}
    </ul>
  );
}
