"""A small furnished room and a planner without clearance, for ``fake_pilot``."""

from __future__ import annotations

from collections import deque
from itertools import pairwise
from math import dist

from housefly.geometry import Vec2
from housefly.hub.api.pilot_queries import GridView, OutlineView, PlaceView, RoomView
from housefly.messages import Path, PlanAnswer, PreflightCheck
from housefly.messages.words import literal

FAKE_PILOT_SPEED = 0.5
"""Speed of the fake drone [m/s]."""

EXAMPLE_CHECKS = (
    PreflightCheck(
        code="charge",
        title=literal("the battery is charged"),
        fault=literal("the battery is too low"),
        passed=True,
        required=True,
        value=literal("86%"),
        limit=literal("at least 20%"),
        why=literal("it has to come home, and to land"),
        mend=literal("charge it, or change the battery"),
    ),
    PreflightCheck(
        code="sees_people",
        title=literal("a sensor sees people without markers"),
        fault=literal("people without markers are unseen"),
        passed=True,
        required=False,
        value=literal("yes"),
        limit=literal("yes"),
        why=literal("it makes way only for people whom a sensor sees"),
        mend=literal("keep people out of the room"),
    ),
)
"""Two pre-flight checks of which all is well: one that is required, one that is told only."""

_Cell = tuple[int, int]


def example_room() -> RoomView:
    """Return a small furnished room."""
    width, height, resolution = 60, 32, 0.125
    table, sofa, rug = (20, 12, 34, 20), (40, 24, 58, 30), (2, 24, 14, 30)

    def letter(i: int, j: int) -> str:
        for name, (x0, y0, x1, y1) in (("#", table), ("#", sofa), ("v", rug)):
            if x0 <= i < x1 and y0 <= j < y1:
                return name
            if name == "#" and x0 - 3 <= i < x1 + 3 and y0 - 3 <= j < y1 + 3:
                return "i"
        return "." if 2 < i < width - 3 and 2 < j < height - 3 else "i"

    def outline(thing: str, cells: tuple[int, int, int, int], colour: str) -> OutlineView:
        x0, y0, x1, y1 = (resolution * value for value in cells)
        return OutlineView(thing, ((x0, y0), (x1, y0), (x1, y1), (x0, y1)), 0.8, colour)

    rows = tuple("".join(letter(i, j) for i in range(width)) for j in range(height))
    return RoomView(
        site="Rehearsal",
        mode="default",
        bounds=(0.0, 0.0, width * resolution, height * resolution),
        grid=GridView((0.0, 0.0), resolution, width, height, rows),
        outlines=(outline("table", table, "#b08d57"), outline("sofa", sofa, "#6b7a8f")),
        places=(
            PlaceView("home", "Home", (1.0, 1.0), (2.0, 1.0, 1.0)),
            PlaceView("entrance", "Entrance", (6.4, 1.0), (7.5, 1.0, 1.2)),
            PlaceView("sofa", "Sofa", (4.2, 3.3), (6.0, 3.4, 0.6)),
        ),
        home=(1.0, 1.0),
        flight_height=1.1,
        visitor=(7.1, 1.0),
        limits={
            "speed": FAKE_PILOT_SPEED,
            "height_max": 2.0,
            "battery_floor": 0.15,
            "pose_age_level": 0.25,
            "pose_age_land": 2.0,
        },
    )


def plan_on(grid: GridView, start: Vec2, goal: Vec2) -> PlanAnswer:
    """Return a shortest path over the free cells, found breadth first."""
    first, last = _cell(grid, start), _cell(grid, goal)
    if not _free(grid, last):
        return PlanAnswer(
            start,
            goal,
            None,
            literal("an obstacle is too close to this point"),
            _nearest_free(grid, goal),
        )
    came: dict[_Cell, _Cell] = {first: first}
    waiting = deque([first])
    while waiting and last not in came:
        i, j = waiting.popleft()
        for neighbour in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)):
            if neighbour not in came and _free(grid, neighbour):
                came[neighbour] = (i, j)
                waiting.append(neighbour)
    if last not in came:
        return PlanAnswer(start, goal, None, literal("no free way leads to this point"))
    cells = [last]
    while cells[-1] != first:
        cells.append(came[cells[-1]])
    corners = _corners(cells[::-1])
    way = (start, *(_centre(grid, cell) for cell in corners[1:-1]), goal)
    length = sum(dist(a, b) for a, b in pairwise(way))
    return PlanAnswer(
        start, goal, Path(way, length, 0.42), duration=length / FAKE_PILOT_SPEED + 2.0
    )


def _corners(cells: list[_Cell]) -> list[_Cell]:
    def straight(k: int) -> bool:
        (a, b), (c, d), (e, f) = cells[k - 1 : k + 2]
        return (c - a, d - b) == (e - c, f - d)

    return [cell for k, cell in enumerate(cells) if k in (0, len(cells) - 1) or not straight(k)]


def _cell(grid: GridView, point: Vec2) -> _Cell:
    return int((point[0] - grid.origin[0]) / grid.resolution), int(
        (point[1] - grid.origin[1]) / grid.resolution
    )


def _centre(grid: GridView, cell: _Cell) -> Vec2:
    return (
        grid.origin[0] + (cell[0] + 0.5) * grid.resolution,
        grid.origin[1] + (cell[1] + 0.5) * grid.resolution,
    )


def _free(grid: GridView, cell: _Cell) -> bool:
    return (
        0 <= cell[0] < grid.width
        and 0 <= cell[1] < grid.height
        and grid.rows[cell[1]][cell[0]] == "."
    )


def _nearest_free(grid: GridView, point: Vec2) -> Vec2 | None:
    free = ((i, j) for j in range(grid.height) for i in range(grid.width) if _free(grid, (i, j)))
    return min(
        (_centre(grid, cell) for cell in free), key=lambda centre: dist(centre, point), default=None
    )
