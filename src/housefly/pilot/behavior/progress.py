"""What happened to the errand: signals from the drone's word, the place reached and the time spent."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot, inf

from housefly.config.site import LimitsConfig
from housefly.geometry import distance
from housefly.messages import DroneStatus, OrderKind, Phase
from housefly.pilot.behavior.captain import Course
from housefly.pilot.behavior.errand import Errand, Signal
from housefly.pilot.behavior.scene import Scene
from housefly.pilot.behavior.tracking import Track

HOME_TOLERANCE = 0.08
"""The drone is above its pad when nearer than this [m] ..."""
HOME_PATIENCE = 6.0
"""... or, when it does not get that near for this long [s], nearer than the tolerance of any goal.
"""
SLOW = 0.15
"""The drone has arrived only when slower than this [m/s]."""
SETTLE = 0.4
"""The conditions of arrival must hold for this long [s]."""
FACE_PATIENCE = 5.0
"""Looking counts from here when the drone never quite faces the subject [s]."""
OVERDUE_FACTOR, OVERDUE_EXTRA = 3.0, 30.0
"""A flight is overdue after this multiple of its expected time, plus so many seconds."""
WAIT_PATIENCE = 20.0
"""A drone that waits for its way to become free turns home after this, and lands after another such
time [s].
"""

BY_STATUS = {
    DroneStatus.FLYING: Signal.AIRBORNE,
    DroneStatus.LANDING: Signal.SINKING,
    DroneStatus.LANDED: Signal.GROUNDED,
    DroneStatus.EMERGENCY: Signal.EMERGENCY,
}
"""The signal in each word of the drone; taking off and unknown say nothing new."""


@dataclass(frozen=True, slots=True)
class Clocks:
    """Since when things hold [s]; infinite while they do not.

    Attributes:
        near: near enough to the goal and slow.
        ended: the reference stands at the end of the path.
        facing: facing what is to be looked at.
    """

    near: float = inf
    ended: float = inf
    facing: float = inf

    def after(self, now: float, near: bool, ended: bool, facing: bool) -> Clocks:
        """Return the clocks after one more look."""
        return Clocks(
            min(self.near, now) if near else inf,
            min(self.ended, now) if ended else inf,
            min(self.facing, now) if facing else self.facing,
        )


def is_near(
    scene: Scene, track: Track, tolerance: float, errand: Errand, clocks: Clocks, paper: bool
) -> bool:
    """Return whether the drone is where the path ends.

    In mode paper nearer than eps3 is enough (q4); in mode default it must also be slow, and nearer
    still above its pad.
    """
    if scene.estimate is None or not track.finished:
        return False
    (x, y, _), (vx, vy, _) = scene.estimate.position, scene.estimate.velocity
    off = distance((x, y), track.position)
    if paper:
        return off < tolerance
    exact = errand.mission.kind is OrderKind.HOME and scene.now - clocks.ended < HOME_PATIENCE
    return hypot(vx, vy) < SLOW and off < (min(HOME_TOLERANCE, tolerance) if exact else tolerance)


def signals(
    errand: Errand, course: Course, clocks: Clocks, scene: Scene, limits: LimitsConfig, facing: bool
) -> list[Signal]:
    """Return what happened, in the order in which it counts.

    Args:
        errand: what the drone is doing.
        course: what it tracks.
        clocks: since when it is near and facing.
        scene: the drone's word, its place.
        limits: timeouts.
        facing: whether the heading is the wanted one.
    """
    found = [BY_STATUS[scene.status]] if scene.status in BY_STATUS else []
    if scene.landing_forced:
        found.append(Signal.FORCED_DOWN)
    if (
        errand.phase in (Phase.OUTBOUND, Phase.RETURNING)
        and scene.now - clocks.near >= SETTLE
        and not course.waiting
    ):
        found.extend(_arrivals(errand, facing))
    if course.waiting and scene.now - course.since > WAIT_PATIENCE:
        found.append(Signal.BLOCKED)
    if (
        errand.phase is Phase.LOOKING
        and scene.now - _looking_since(errand, clocks) >= errand.mission.look_s
    ):
        found.append(Signal.LOOKED)
    if scene.now - errand.since > allowed_time(errand, course, limits):
        found.append(Signal.OVERDUE)
    return found


def allowed_time(errand: Errand, course: Course, limits: LimitsConfig) -> float:
    """Return how long the present phase may take [s]."""
    flight = OVERDUE_FACTOR * course.duration + OVERDUE_EXTRA
    return {
        Phase.IDLE: inf,
        Phase.TAKING_OFF: limits.take_off_timeout,
        Phase.OUTBOUND: flight,
        Phase.LOOKING: errand.mission.look_s + 2.0 * FACE_PATIENCE,
        Phase.HOLDING: inf,
        Phase.RETURNING: flight,
        Phase.LANDING: limits.landing_timeout,
    }[errand.phase]


def _arrivals(errand: Errand, facing: bool) -> list[Signal]:
    if errand.mission.kind is OrderKind.SERVICE:
        return [Signal.ARRIVED_TO_LOOK]
    if errand.mission.kind is OrderKind.GO:
        return [Signal.ARRIVED_TO_STAY]
    return [Signal.ARRIVED_HOME] if facing else []


def _looking_since(errand: Errand, clocks: Clocks) -> float:
    return min(max(clocks.facing, errand.since), errand.since + FACE_PATIENCE)
