"""The flight plans of the tables: the service's path, and steps of one cell."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.config.site import Mode, Site, changed
from housefly.errors import RoomError
from housefly.geometry import Vec2
from housefly.lab.experiments.flight_plan import SETTLE, FlightPlan, Task
from housefly.lab.experiments.planned_flight import planned_flight
from housefly.messages import Path
from housefly.pilot.behavior.mission import Refused
from housefly.pilot.navigator import RoomNavigator
from housefly.room.files import load_room
from housefly.room.grid import OccupancyGrid, build_grid
from housefly.room.model import Room

MODES: tuple[Mode, Mode] = ("default", "paper")
"""By the number in the column ``mode``."""
_GOAL = "entrance"
"""Where the service of the paper goes."""
_DURATION_FACTOR = 2.5
"""A flight lasts this many times the path at cruise speed, so that a slow, steady drone arrives."""
PAPER_CELL = 0.5
"""Edge of the paper's cells, and length of a step between two of them [m]."""


@dataclass(frozen=True, slots=True)
class MappedSite:
    """A site in one mode, with its room and grid."""

    site: Site
    room: Room
    grid: OccupancyGrid


def mapped_site(site: Site, mode: Mode) -> MappedSite:
    """Return the site in a mode, with its room and grid."""
    in_mode = changed(site, mode=mode)
    room = load_room(site.room.model)
    return MappedSite(in_mode, room, build_grid(room, in_mode))


def service_path(here: MappedSite, goal: str = _GOAL) -> Path:
    """Return the way from home to a place on the mode's grid, which the paper's figures show.

    Raises:
        RoomError: when there is none; the reason is the planner's.
    """
    start, end = here.room.home, here.room.place(goal).viewpoint
    answer = RoomNavigator(here.site, here.room, here.grid).plan(start, end)
    if answer.path is None:
        raise RoomError(f"no way from home to {goal} in mode {here.site.mode}: {answer.reason}")
    return answer.path


def service_plan(here: MappedSite) -> FlightPlan:
    """Return the outbound flight of the service, along what the pilot flies in the mode.

    Raises:
        RoomError: when there is no way; the reason is the planner's.
    """
    duration = SETTLE + _DURATION_FACTOR * service_path(here).length / here.site.limits.speed
    planned = planned_flight(
        RoomNavigator(here.site, here.room, here.grid),
        (*here.room.home, here.site.map.flight_height),
        here.room.home_yaw,
        here.room.place(_GOAL).viewpoint,
        duration,
    )
    if isinstance(planned, Refused):
        raise RoomError(f"no way to {_GOAL} in mode {here.site.mode}: {planned.reason}")
    return planned


def step_plan(site: Site, length: float = PAPER_CELL, duration: float = 12.0) -> FlightPlan:
    """Return a jump of the reference along x by ``length`` [m]."""
    ends: tuple[Vec2, Vec2] = ((0.0, 0.0), (length, 0.0))
    return FlightPlan(Task.STEP, ends, SETTLE + duration, site.map.flight_height)


def hold_plan(site: Site, duration: float = 30.0) -> FlightPlan:
    """Return a stay at one place."""
    return FlightPlan(Task.HOLD, ((0.0, 0.0),), SETTLE + duration, site.map.flight_height)
