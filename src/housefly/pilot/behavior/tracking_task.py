"""What the drone tracks at the moment: a path, or a place that it holds."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec2
from housefly.messages import Path
from housefly.pilot.behavior.path_profile import PathProfile


@dataclass(frozen=True, slots=True, eq=False)
class TrackingTask:
    """A path to follow or a place to hold; a new object is a new task.

    Attributes:
        profile: of the path in use, None while holding a place.
        path: the path in use or in prospect, for people.
        duration: expected flight time on it [s].
        hold: place to stay at [m], None to stay where the drone is.
        hold_yaw: heading to keep there [rad].
        waiting: why it waits for the way to become free, in words; "" when it does not.
        since: since when it waits [s].
    """

    profile: PathProfile | None = None
    path: Path | None = None
    duration: float = 0.0
    hold: Vec2 | None = None
    hold_yaw: float = 0.0
    waiting: str = ""
    since: float = 0.0
