import { cellOf, letterAt } from "../map/grid";
import { rectangle, type Projection } from "../map/projection";
import { room } from "../store";
import type { CoverageView } from "../wire/room-messages";
import { coverage, showsCoverage } from "./store";
import { decimal, t } from "../messages/language";

const LEVELS = ["blind", "few", "some", "many"] as const;
/** Letters of the grid where air is at flight height. */
const FLYABLE = ".vi";
const SOME = 4;
const MANY = 7;
const NUMBER_EVERY = 4;

/** How many tracking cameras see each part of the room at flight height, as tints and numbers. */
export function CoverageLayer({ to }: { to: Projection }) {
  const view = coverage.value;
  const grid = room.value?.grid;
  if (!view || !grid || !showsCoverage.value) return null;
  const paths: Record<string, string> = {};
  const numbers: { u: number; v: number; count: number }[] = [];
  view.rows.forEach((row, j) =>
    [...row].forEach((digit, i) => {
      const corner: [number, number] = [
        view.origin[0] + i * view.resolution,
        view.origin[1] + j * view.resolution,
      ];
      const middle: [number, number] = [
        corner[0] + view.resolution / 2,
        corner[1] + view.resolution / 2,
      ];
      if (!FLYABLE.includes(letterAt(grid, ...cellOf(grid, middle)))) return;
      const count = parseInt(digit, 36);
      const [u, v] = to.at(middle);
      const level = levelOf(count, view);
      const cell = rectangle(to, corner, view.resolution, view.resolution);
      paths[level] = (paths[level] ?? "") + cell;
      if (i % NUMBER_EVERY === 2 && j % NUMBER_EVERY === 2)
        numbers.push({ u, v: v + 4, count });
    }),
  );
  return (
    <g class="coverage" aria-label={t("Tracking coverage")}>
      {LEVELS.map((level) => (
        <path key={level} class={level} d={paths[level] ?? ""} />
      ))}
      {numbers.map(({ u, v, count }) => (
        <text key={`${u} ${v}`} x={u} y={v}>
          {count}
        </text>
      ))}
    </g>
  );
}

function levelOf(count: number, view: CoverageView): (typeof LEVELS)[number] {
  if (count < view.enough) return "blind";
  return count < SOME ? "few" : count < MANY ? "some" : "many";
}

export function CoverageLegend() {
  const view = coverage.value;
  if (!view || !showsCoverage.value) return null;
  return (
    <li class="seen">
      {t("number: how many of {n} cameras see {d} m above the floor;", {
        n: view.cameras,
        d: decimal(view.height, 1),
      })}{" "}
      {t("hatched: fewer than {n}, no tracking", { n: view.enough })}
    </li>
  );
}
