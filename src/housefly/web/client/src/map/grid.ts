// The occupancy grid as the server sends it: rows of letters, lowest y first.
import type { Point } from "../store";
import type { GridView } from "../wire/messages";

export type Cell = [number, number];

export function cellOf(grid: GridView, point: Point): Cell {
  return [
    Math.floor((point[0] - grid.origin[0]) / grid.resolution),
    Math.floor((point[1] - grid.origin[1]) / grid.resolution),
  ];
}

export function centreOf(grid: GridView, cell: Cell): Point {
  return [
    grid.origin[0] + (cell[0] + 0.5) * grid.resolution,
    grid.origin[1] + (cell[1] + 0.5) * grid.resolution,
  ];
}

/** The letter of a cell; "x" outside. */
export function letterAt(grid: GridView, i: number, j: number): string {
  return grid.rows[j]?.[i] ?? "x";
}

export interface Run {
  i: number;
  j: number;
  width: number;
}

/** Cells of some kinds, joined along x: a fine grid becomes a few hundred shapes. */
export function runs(grid: GridView, letters: string): Run[] {
  const found: Run[] = [];
  grid.rows.forEach((row, j) => {
    for (let i = 0; i < grid.width; i++) {
      if (!letters.includes(row[i]!)) continue;
      const start = i;
      while (i + 1 < grid.width && letters.includes(row[i + 1]!)) i++;
      found.push({ i: start, j, width: i - start + 1 });
    }
  });
  return found;
}

/** The part of the world that is not outside: x_min, y_min, x_max, y_max [m]. */
export function insideOf(grid: GridView): [number, number, number, number] | null {
  const found = runs(grid, ".#vi");
  if (found.length === 0) return null;
  const low = Math.min(...found.map((run) => run.j));
  const high = Math.max(...found.map((run) => run.j + 1));
  const left = Math.min(...found.map((run) => run.i));
  const right = Math.max(...found.map((run) => run.i + run.width));
  const at = (cells: number, axis: 0 | 1): number => grid.origin[axis] + cells * grid.resolution;
  return [at(left, 0), at(low, 1), at(right, 0), at(high, 1)];
}
