"""From a campaign to drones: one group for each way that is flown, cut into equal chunks.

A drone is one point of the grid with one seed. Which drone has which number depends on the campaign
alone, so chunks can be flown in any order, anywhere, and again.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Mode, Site, changed
from housefly.errors import ConfigError
from housefly.lab.campaigns.draws import shares_of
from housefly.lab.campaigns.spec import CampaignSpec
from housefly.lab.experiments.cases import BY_NAME, DEFAULT, PAPER, Cases, cases
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.lab.experiments.planned_flight import planned_flight
from housefly.pilot.behavior.mission import Refused
from housefly.pilot.navigator import RoomNavigator
from housefly.room.files import load_room
from housefly.room.grid import build_grid

MIN_CHUNK, MAX_CHUNK = 250, 4000
"""Smallest and largest number of drones per chunk; a stop loses no more than one chunk."""
_CHUNKS_WANTED = 200
"""Number of chunks of a medium campaign, so that every worker gets some."""
MODE_NAMES: dict[int, Mode] = {DEFAULT: "default", PAPER: "paper"}
PLANNED_WITH = {
    "speed": "limits__speed",
    "vertical_speed_max": "limits__vertical_speed_max",
    "tilt_max": "limits__tilt_max",
    "model_drag": "drone__drag",
}
"""Columns that a trajectory in space is planned with, and the keys of a site that they stand for.
"""


@dataclass(frozen=True, slots=True)
class PlanGroup:
    """The grid points that share one flight plan: those of a mode, and in space also of a speed.

    Attributes:
        name: the mode, and what else the way was planned with.
        site: in the group's mode.
        mission: what they fly.
        cells: numbers of the points in the whole grid.
        points: values of the grid's columns, one row a point.
    """

    name: str
    site: Site
    mission: FlightPlan
    cells: tuple[int, ...]
    points: tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class Chunk:
    """Drones ``start`` to ``stop`` of one group; ``number`` counts chunks in the campaign."""

    number: int
    group: int
    start: int
    stop: int

    @property
    def drones(self) -> int:
        """How many drones it has."""
        return self.stop - self.start


@dataclass(frozen=True, slots=True)
class Plan:
    """Everything that is flown.

    Attributes:
        spec: the campaign.
        groups: by mode and way.
        chunks: of all groups.
    """

    spec: CampaignSpec
    groups: tuple[PlanGroup, ...]
    chunks: tuple[Chunk, ...]

    @property
    def drones(self) -> int:
        """How many drones fly in all."""
        return self.spec.drones

    def cases_of(self, chunk: Chunk) -> tuple[Cases, NDArray[np.int64]]:
        """Return the drones of a chunk and the number of each one's point in the grid."""
        group, spec = self.groups[chunk.group], self.spec
        point, seed = np.divmod(np.arange(chunk.start, chunk.stop), spec.seeds)
        columns: dict[str, Any] = dict(spec.fixed)
        values = np.asarray(group.points, dtype=float).reshape(len(group.points), len(spec.grid))
        columns.update({name: values[point, index] for index, name in enumerate(spec.grid)})
        first, count = int(seed.min()), int(np.ptp(seed)) + 1
        for name, draw in spec.draw.items():
            shares = shares_of(name, spec.first_seed + first, count)
            columns[name] = draw.at(shares, BY_NAME[name])[seed - first]
        columns["seed"] = spec.first_seed + seed
        return (
            cases(group.site, chunk.stop - chunk.start, **columns),
            np.asarray(group.cells, dtype=np.int64)[point],
        )


def chunk_size(drones: int) -> int:
    """Return the drones per chunk of a campaign of this size; cores and workers do not matter."""
    return min(max(-(-drones // _CHUNKS_WANTED), MIN_CHUNK), MAX_CHUNK)


def plan_campaign(spec: CampaignSpec, site: Site, chunk: int | None = None) -> Plan:
    """Return the campaign ready to fly, in chunks of ``chunk`` drones (by its size when None).

    Raises:
        ConfigError: the site's room has no such place, or no way leads there.
    """
    points = tuple(product(*spec.grid.values()))
    groups: list[PlanGroup] = []
    for number, mode in MODE_NAMES.items():
        own = [cell for cell, point in enumerate(points) if _mode(spec, site, point) == number]
        if own:
            groups.extend(_groups_of_mode(spec, changed(site, mode=mode), own, points))
    return Plan(
        spec, tuple(groups), tuple(_chunks(groups, spec.seeds, chunk or chunk_size(spec.drones)))
    )


def _groups_of_mode(
    spec: CampaignSpec, site: Site, cells: list[int], points: tuple[tuple[Any, ...], ...]
) -> Iterator[PlanGroup]:
    """Yield the points of a mode by the way that they fly."""
    is_in_space = bool(spec.mission.goal) and site.flies_in_space
    if is_in_space and "speed" in spec.draw:
        raise ConfigError(
            "draw.speed",
            "a trajectory is planned for each speed beforehand: put speed into [grid] or [fixed]",
        )
    by_limits: dict[tuple[tuple[str, float], ...], list[int]] = {}
    for cell in cells:
        columns = dict(zip(spec.grid, points[cell], strict=True)) | spec.fixed
        limits = [(name, float(columns[name])) for name in PLANNED_WITH if name in columns]
        by_limits.setdefault(tuple(limits) if is_in_space else (), []).append(cell)
    for limits_of, own in by_limits.items():
        planned_on = changed(site, **{PLANNED_WITH[name]: value for name, value in limits_of})
        yield PlanGroup(
            name=", ".join((site.mode, *(f"{name} {value:g}" for name, value in limits_of))),
            site=site,
            mission=_flight_plan(spec, planned_on),
            cells=tuple(own),
            points=tuple(tuple(float(value) for value in points[cell]) for cell in own),
        )


def _chunks(groups: list[PlanGroup], seeds: int, size: int) -> Iterator[Chunk]:
    number = 0
    for index, group in enumerate(groups):
        drones = len(group.points) * seeds
        for start in range(0, drones, size):
            yield Chunk(number, index, start, min(start + size, drones))
            number += 1


def _mode(spec: CampaignSpec, site: Site, point: tuple[Any, ...]) -> int:
    values = dict(zip(spec.grid, point, strict=True)) | spec.fixed
    return int(values["mode"]) if "mode" in values else (PAPER if site.mode == "paper" else DEFAULT)


def _flight_plan(spec: CampaignSpec, site: Site) -> FlightPlan:
    """Return the flight plan of one mode; a way through the room is what the live pilot flies."""
    given, height = spec.mission, site.map.flight_height
    if given.waypoints:
        return FlightPlan(Task(given.task), given.waypoints, given.duration_s, height)
    room = load_room(site.room.model)
    try:
        start, goal = room.place(given.start), room.place(given.goal)
    except KeyError as error:
        raise ConfigError("mission", str(error.args[0])) from error
    planned = planned_flight(
        RoomNavigator(site, room, build_grid(room, site)),
        (*start.viewpoint, height),
        room.home_yaw,
        goal.viewpoint,
        given.duration_s,
        Task(given.task),
    )
    if isinstance(planned, Refused):
        raise ConfigError(
            "mission.goal",
            f"no way from {given.start} to {given.goal} in mode {site.mode}: {planned.reason}",
        )
    return planned
