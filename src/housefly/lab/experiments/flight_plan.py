"""What all drones of an experiment are to do."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from hashlib import sha256

from housefly.geometry import Vec2
from housefly.pilot.behavior.path_profile import PathProfile


class Task(Enum):
    """How the reference moves.

    PATH: along the waypoints or the trajectory, as the live pilot moves it in the case's mode.
    STEP: stands at the
        first waypoint for
    ``SETTLE`` seconds, then at the last one. HOLD: stands at the first one.
    """

    PATH = "path"
    STEP = "step"
    HOLD = "hold"


SETTLE = 2.0
"""How long every drone hovers at the first waypoint before the task begins [s]."""


@dataclass(frozen=True, slots=True)
class FlightPlan:
    """One task in an empty room.

    Attributes:
        task: how the reference moves.
        waypoints: world xy [m]; the drone starts at rest above the first.
        duration: of the flight, ``settle`` included [s].
        height: z_ref, where it also starts [m].
        yaw: heading at the start [rad].
        arrival_yaw: heading wanted at the end [rad]; None keeps the path's.
        settle: how long the drone hovers before the task begins [s].
        trajectory: through space, which a PATH in mode default flies in place of corners; None
            for none.
    """

    task: Task
    waypoints: tuple[Vec2, ...]
    duration: float
    height: float = 1.1
    yaw: float = 0.0
    arrival_yaw: float | None = None
    settle: float = SETTLE
    trajectory: PathProfile | None = field(default=None, repr=False, compare=False)

    @property
    def digest(self) -> str:
        """A mark of all that it asks, down to the last bit of a trajectory."""
        mark = sha256(repr(self).encode())
        for numbers in self.trajectory or ():
            mark.update(repr(numbers.shape).encode() + numbers.tobytes())
        return mark.hexdigest()[:16]
