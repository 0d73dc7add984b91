// The occupancy grid as the server sends it: rows of letters, lowest y first.
import type { Point } from "../store";
import type { GridView } from "../wire/messages";

export type Cell = [number, number];

export function cellOf(grid: GridView, point: Point): Cell {
  return [Math.floor((point[0] - grid.origin[0]) / grid.resolution), Math.floor((point[1] - grid.origin[1]) / grid.resolution)];
}

export function centreOf(grid: GridView, cell: Cell): Point {
  return [grid.origin[0] + (cell[0] + 0.5) * grid.resolution, grid.origin[1] + (cell[1] + 0.5) * grid.resolution];
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

/** Cells of one kind, joined along x, so that a fine grid is a few hundred shapes and not ten thousand. */
export function runs(grid: GridView, letter: string): Run[] {
  const found: Run[] = [];
  grid.rows.forEach((row, j) => {
    for (let i = 0; i < grid.width; i++) {
      if (row[i] !== letter) continue;
      const start = i;
      while (i + 1 < grid.width && row[i + 1] === letter) i++;
      found.push({ i: start, j, width: i - start + 1 });
    }
  });
  return found;
}
