"""What the drones of the tables fly: the service's own way, and steps of one cell."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.config.site import Mode, Site, changed
from housefly.errors import RoomError
from housefly.geometry import Vec2
from housefly.lab.experiments.mission import SETTLE, Mission, Task
from housefly.messages import Path
from housefly.pilot.navigator import RoomNavigator
from housefly.room.files import load_room
from housefly.room.grid import OccupancyGrid, build_grid
from housefly.room.model import Room

MODES: tuple[Mode, Mode] = ("default", "paper")
"""By the number in the column ``mode``."""
GOAL = "entrance"
"""Where the service of the paper goes."""
PATIENCE = 2.5
"""A flight lasts this many times the way at cruise speed, so that a slow but steady drone arrives
and rests.
"""
CELL = 0.5
"""Edge of the paper's cells, and length of the step between two of their middles [m]."""


@dataclass(frozen=True, slots=True)
class Premises:
    """A site with its room and the map of one mode."""

    site: Site
    room: Room
    grid: OccupancyGrid


def premises(site: Site, mode: Mode) -> Premises:
    """Return the site in a mode, with its room and its map."""
    in_mode = changed(site, mode=mode)
    room = load_room(site.room.model)
    return Premises(in_mode, room, build_grid(room, in_mode))


def service_path(here: Premises, goal: str = GOAL) -> Path:
    """Return the planned way from home to a place, as the pilot plans it in the mode.

    Raises:
        RoomError: when there is none; the reason is the planner's.
    """
    start, end = here.room.home, here.room.place(goal).viewpoint
    answer = RoomNavigator(here.site, here.room, here.grid).plan(start, end)
    if answer.path is None:
        raise RoomError(f"no way from home to {goal} in mode {here.site.mode}: {answer.reason}")
    return answer.path


def service(here: Premises) -> Mission:
    """Return the outbound flight of the service."""
    path = service_path(here)
    duration = SETTLE + PATIENCE * path.length / here.site.limits.speed
    return Mission(
        Task.PATH, path.waypoints, duration, here.site.map.flight_height, here.room.home_yaw
    )


def step(site: Site, length: float = CELL, duration: float = 12.0) -> Mission:
    """Return a jump of the reference along x by ``length`` [m]."""
    ends: tuple[Vec2, Vec2] = ((0.0, 0.0), (length, 0.0))
    return Mission(Task.STEP, ends, SETTLE + duration, site.map.flight_height)


def hold(site: Site, duration: float = 30.0) -> Mission:
    """Return a stay at one place."""
    return Mission(Task.HOLD, ((0.0, 0.0),), SETTLE + duration, site.map.flight_height)
