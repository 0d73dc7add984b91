"""Answers "how do I get from start to goal?" with a path, or with the reason in words."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from housefly.geometry import Vec2, distance
from housefly.messages.order_fault import COORDINATE_MAX
from housefly.messages.steering import Path, PlanAnswer
from housefly.messages.words import UNSAID, Words, figure
from housefly.numeric import running_sum
from housefly.pilot.planning.dijkstra import (
    UNREACHED,
    FreeMask,
    distances,
    shortest_path,
)
from housefly.pilot.planning.shortcut import sees, straightened
from housefly.room.grid import Cell, CellIndex, OccupancyGrid

START, GOAL = Words("the start"), Words("the goal")
"""The two ends of a way."""


def plan(
    grid: OccupancyGrid,
    start: Vec2,
    goal: Vec2,
    speed: float,
    *,
    every_cell: bool = False,
    shortcut: bool = False,
) -> PlanAnswer:
    """Return a shortest path for the drone's middle, or why there is none.

    Args:
        grid: where the middle of the drone may be.
        start: where it is [m].
        goal: where it should go [m].
        speed: expected speed along the path [m/s], for the duration.
        every_cell: keep the middle of every cell as a waypoint, as mode ``paper`` flies; else only
            corners, and the last waypoint is the goal itself.
        shortcut: straighten the path at any angle.
    """
    free: FreeMask = grid.cells == Cell.FREE
    objection = _objection(grid, START, start)
    if objection:
        return PlanAnswer(start, goal, None, objection, _nearest(grid, free, start))
    here, there = grid.cell_of(start), grid.cell_of(goal)
    objection = _objection(grid, GOAL, goal)
    cells = () if objection else shortest_path(free, here, there)
    if not cells:
        reason = objection or Words(
            "there is no free way from {name} to {place}", name=_name(start), place=_name(goal)
        )
        return PlanAnswer(
            start, goal, None, reason, _nearest(grid, distances(free, here) != UNREACHED, goal)
        )
    waypoints = tuple(grid.centre_of(cell) for cell in cells)
    if not every_cell:
        waypoints = straightened(grid, waypoints) if shortcut else _corners(waypoints)
        waypoints = _ending_at(grid, waypoints, goal)
    path = Path(waypoints, path_length(waypoints), path_clearance(grid, waypoints))
    return PlanAnswer(start, goal, path, duration=path.length / speed)


def path_length(waypoints: tuple[Vec2, ...]) -> float:
    """Return the sum of the legs [m]."""
    return running_sum(distance(a, b) for a, b in pairwise(waypoints))


def path_clearance(grid: OccupancyGrid, waypoints: tuple[Vec2, ...]) -> float:
    """Return the smallest distance [m] from the path to a real obstacle."""
    smallest = grid.clearance_at(waypoints[0])
    for a, b in pairwise(waypoints):
        steps = max(1, int(np.ceil(4.0 * distance(a, b) / grid.resolution)))
        points = (
            (a[0] + (b[0] - a[0]) * k / steps, a[1] + (b[1] - a[1]) * k / steps)
            for k in range(1, steps + 1)
        )
        smallest = min(smallest, *(grid.clearance_at(point) for point in points))
    return smallest


def _objection(grid: OccupancyGrid, end: Words, point: Vec2) -> Words:
    """Return why the drone may not be at this point, or nothing."""
    if not _is_of_this_world(point):
        return Words("{end} is not a position: {place}", end=end, place=str(point))
    cell = grid.cell_of(point)
    if not grid.contains(cell):
        return Words("{end} {place} lies outside the map", end=end, place=_name(point))
    return UNSAID if grid.is_free(cell) else _taken(grid, cell, end, _name(point))


def _taken(grid: OccupancyGrid, cell: CellIndex, end: Words, place: str) -> Words:
    """Return why no end of a way is in this cell."""
    match grid.kind(cell):
        case Cell.OCCUPIED:
            return Words("{end} {place} lies in an obstacle", end=end, place=place)
        case Cell.VIRTUAL:
            return Words("{end} {place} lies in a no-fly area", end=end, place=place)
        case Cell.INFLATED:
            near = figure(float(grid.clearance[cell]), ".2f")
            return Words(
                "{end} {place} is too close to an obstacle ({d} m)", end=end, place=place, d=near
            )
        case _:
            return Words("{end} {place} lies outside the room", end=end, place=place)


def _nearest(grid: OccupancyGrid, allowed: FreeMask, point: Vec2) -> Vec2 | None:
    """Return the middle of the allowed cell nearest to a point [m]; the first among equals."""
    if not _is_of_this_world(point) or not allowed.any():
        return None
    ix, iy = np.nonzero(allowed)
    dx = grid.origin[0] + (ix + 0.5) * grid.resolution - point[0]
    dy = grid.origin[1] + (iy + 0.5) * grid.resolution - point[1]
    best = int(np.argmin(dx * dx + dy * dy))
    nearest: CellIndex = (int(ix[best]), int(iy[best]))
    return grid.centre_of(nearest)


def _is_of_this_world(point: Vec2) -> bool:
    return abs(point[0]) <= COORDINATE_MAX and abs(point[1]) <= COORDINATE_MAX


def _corners(points: tuple[Vec2, ...]) -> tuple[Vec2, ...]:
    """Return the ends and the points where an axis-parallel path turns."""
    inner = (
        here
        for before, here, after in zip(points, points[1:], points[2:], strict=False)
        if abs(
            (here[0] - before[0]) * (after[1] - here[1])
            - (here[1] - before[1]) * (after[0] - here[0])
        )
        > 1e-9
    )
    return (points[0], *inner, points[-1]) if len(points) > 1 else points


def _ending_at(grid: OccupancyGrid, points: tuple[Vec2, ...], goal: Vec2) -> tuple[Vec2, ...]:
    """Return the path with the goal itself instead of the middle of its cell."""
    if len(points) > 1 and sees(grid, points[-2], goal):
        return (*points[:-1], goal)
    return points if distance(points[-1], goal) < 1e-9 else (*points, goal)


def _name(point: Vec2) -> str:
    return f"({point[0]:.2f}, {point[1]:.2f}) m"
