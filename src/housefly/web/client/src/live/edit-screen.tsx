import "../later-style";
import { useEffect } from "preact/hooks";
import { PlanFrame } from "../map/map";
import { RoomLayer } from "../map/room";
import { CoverageLayer, CoverageLegend } from "./coverage";
import { EditLayer } from "./edit-layer";
import { EditPanel } from "./edit-panel";
import { beginEditing } from "./edits";
import { CoverageButton } from "./layers";
import { showsCoverage } from "./store";
import { t } from "../messages/language";

/** Places and no-fly zones on the map, in a mode of its own: no touch here sends the drone. */
export function EditScreen() {
  useEffect(beginEditing, []);
  return (
    <main class="edit-deck">
      <section
        class="view map live"
        aria-label={t("Map being edited")}
        data-coverage={showsCoverage.value}
        data-editing="true"
      >
        <PlanFrame label={t("Floor plan being edited. The list of places and zones follows.")}>
          {(to) => (
            <>
              <RoomLayer to={to} visitors={false} />
              <CoverageLayer to={to} />
              <EditLayer to={to} />
            </>
          )}
        </PlanFrame>
        <ul class="legend" aria-label={t("Legend")}>
          <li class="plain">
            <CoverageButton />
          </li>
          <CoverageLegend />
          <li class="virtual">{t("kept free by order")}</li>
          <li class="inflated">{t("too close")}</li>
        </ul>
      </section>
      <EditPanel />
    </main>
  );
}
