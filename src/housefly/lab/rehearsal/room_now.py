"""The room as it is now, as a value: what a rehearsal begins with."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec3
from housefly.messages import Obstacle, Phase, PilotStep
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.tasks.execution.live_obstacles import LiveObstacles
from housefly.tasks.execution.task_room import SeenPerson

_COMING_DOWN = frozenset({Phase.RETURNING, Phase.LANDING})


@dataclass(frozen=True, slots=True)
class RoomNow:
    """What is known of the room at one time.

    Attributes:
        at: on the pilot's clock [s].
        unix: the same moment as Unix time [s].
        drone: where the drone stands or hovers, world [m]; None where that is not known, or while
            it comes down anyway: it begins on its pad then.
        yaw: where it faces [rad].
        battery: its charge, 0 to 1; None when unknown.
        people: who is seen.
        obstacles: what no map shows, tracked furniture included.
        is_airborne: whether it hovers or flies there.
    """

    at: float = 0.0
    unix: float = 0.0
    drone: Vec3 | None = None
    yaw: float = 0.0
    battery: float | None = None
    people: tuple[SeenPerson, ...] = ()
    obstacles: tuple[Obstacle, ...] = ()
    is_airborne: bool = False


def room_now(live: LiveObstacles, step: PilotStep | None, now: float, unix: float) -> RoomNow:
    """Return the room as it is now.

    Args:
        live: people and obstacles.
        step: the pilot's newest; None before the first.
        now: on the pilot's clock [s].
        unix: the same moment as Unix time [s].
    """
    people, obstacles = live.people(now), live.obstacles(now)
    if step is None:
        return RoomNow(now, unix, people=people, obstacles=obstacles)
    estimate, told = step.outputs.estimate, step.inputs.telemetry
    is_airborne = told is not None and told.status in AIRBORNE_STATUSES
    is_there = told is not None and step.outputs.phase not in _COMING_DOWN
    return RoomNow(
        at=now,
        unix=unix,
        drone=estimate.position if estimate is not None and is_there else None,
        yaw=0.0 if estimate is None else estimate.yaw,
        battery=None if told is None else told.battery,
        people=people,
        obstacles=obstacles,
        is_airborne=is_airborne and is_there,
    )
