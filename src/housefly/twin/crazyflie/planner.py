"""The high-level commander of the simulated Crazyflie: smooth ways of seventh order."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.geometry import Vec3, wrap_angle
from housefly.wires.crazyflie.high_level import (
    GoTo,
    HighLevelOrder,
    Land,
    StopTrajectory,
    TakeOff,
)
from housefly.wires.crazyflie.setpoints import GenericSetpoint, Place, Stop


class PlanState(Enum):
    """What the planner is about."""

    FLYING = "flying"
    LANDING = "landing"
    STOPPED = "stopped"


@dataclass(frozen=True, slots=True)
class Way:
    """From one place to another within a time.

    Attributes:
        start, goal: places, with the heading faced there.
        began: [s].
        duration: [s].
        is_take_off: whether it begins on the floor.
    """

    start: Place
    goal: Place
    began: float
    duration: float
    is_take_off: bool = False

    def is_over(self, now: float) -> bool:
        """Return whether its time is over, now [s]."""
        return now >= self.began + self.duration

    def at(self, now: float) -> Place:
        """Return where it is now [s]: at rest and without a push at both ends."""
        if self.is_over(now):
            return self.goal
        t = max(0.0, (now - self.began) / self.duration)
        share = t**4 * (35.0 - t * (84.0 - t * (70.0 - 20.0 * t)))
        start, goal = self.start, self.goal
        return Place(
            start.x + share * (goal.x - start.x),
            start.y + share * (goal.y - start.y),
            start.z + share * (goal.z - start.z),
            start.yaw + share * wrap_angle(goal.yaw - start.yaw),
        )


class Planner:
    """Flies what it was told last.

    Attributes:
        state: what it is about.
    """

    def __init__(self) -> None:
        self.state = PlanState.STOPPED
        self._way: Way | None = None

    @property
    def is_taking_off(self) -> bool:
        """Whether its newest way began on the floor."""
        return self.state is PlanState.FLYING and self._way is not None and self._way.is_take_off

    def is_finished(self, now: float) -> bool:
        """Return whether there is nothing left to fly, now [s]."""
        return self._way is None or self._way.is_over(now)

    def stop(self) -> None:
        """Forget everything; from now on it wants the motors off."""
        self.state, self._way = PlanState.STOPPED, None

    def obey(self, order: HighLevelOrder, here: Vec3, yaw: float, now: float) -> int:
        """Begin what is ordered; return 0, or 1 where that is not possible now.

        Args:
            order: what.
            here: where the drone is, or is meant to be where it flies a way already [m].
            yaw: likewise [rad].
            now: [s].
        """
        if isinstance(order, StopTrajectory):
            self.stop()
            return 0
        if isinstance(order, TakeOff) and self.state is not PlanState.STOPPED:
            return 1
        if isinstance(order, Land) and self.state is PlanState.LANDING:
            return 1
        start = Place(*here, yaw) if self._way is None else self._way.at(now)
        self.state = PlanState.LANDING if isinstance(order, Land) else PlanState.FLYING
        self._way = Way(start, _goal(order, start), now, order.duration, isinstance(order, TakeOff))
        return 0

    def setpoint(self, now: float) -> GenericSetpoint:
        """Return what it wants flown now [s]: the motors off where there is nothing to fly."""
        if self.state is PlanState.LANDING and self.is_finished(now):
            self.stop()
        return Stop() if self._way is None else self._way.at(now)


def _goal(order: TakeOff | Land | GoTo, start: Place) -> Place:
    if not isinstance(order, GoTo):
        yaw = start.yaw if order.yaw is None else order.yaw
        return Place(start.x, start.y, order.height, yaw)
    x, y, z = order.place
    if order.is_relative:
        return Place(start.x + x, start.y + y, start.z + z, start.yaw + order.yaw)
    return Place(x, y, z, order.yaw)
