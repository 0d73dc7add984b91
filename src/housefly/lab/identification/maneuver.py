"""Fly the blocks, each from rest in the middle of the box; abort when anything goes wrong."""

from __future__ import annotations

from math import hypot, inf

from housefly.geometry import distance
from housefly.lab.identification.box import Box
from housefly.lab.identification.pattern import Block
from housefly.lab.identification.samples import Flown
from housefly.messages import Estimate, Setpoint

REST_DISTANCE, _REST_SPEED, REST_TIME = 0.2, 0.08, 0.8
"""A block begins when the drone is this close to the middle [m], this slow [m/s], this long [s]."""
_REST_TIMEOUT = 25.0
"""A drone that does not come to rest within this time is given up [s]."""
_MAX_POSE_AGE = 0.25
"""A pose older than this aborts the maneuver [s]."""
_MAX_INTERRUPTION = 0.15
"""A block that is interrupted for this long aborts the maneuver [s]."""


class IdentificationManeuver:
    """Implements ``pilot.contracts.Maneuver``: replaces the pilot's command while it holds.

    Attributes:
        problem: why the test was given up, "" while it was not.
        flown: the blocks that were begun, with the times of their beginning; all but the last are
            whole.
    """

    def __init__(self, plan: tuple[Block, ...], box: Box) -> None:
        self._plan, self._box = plan, box
        self._next = 0
        self._began: float | None = None
        self._calm_since: float | None = None
        self._waiting_since: float | None = None
        self._asked_at = -inf
        self._entered = False
        self.problem = ""
        self.flown: list[Flown] = []

    @property
    def finished(self) -> bool:
        """Whether nothing is left to fly."""
        return bool(self.problem) or self._next >= len(self._plan)

    @property
    def done(self) -> int:
        """Number of blocks flown."""
        return self._next

    def propose(self, now: float, estimate: Estimate) -> Setpoint | None:
        """Return what is asked now [s] while the pilot holds, or None to hold on."""
        gap, self._asked_at = now - self._asked_at, now
        if self.finished:
            return None
        if self._began is not None and gap > _MAX_INTERRUPTION:
            return self._given_up("it was interrupted in the middle of a step")
        if not self._box.holds(estimate.position):
            return self._given_up("the drone left the box") if self._entered else None
        self._entered = True
        if estimate.pose_age > _MAX_POSE_AGE:
            return self._given_up(f"tracking was lost for {estimate.pose_age:.2f} s")
        if self._began is None:
            return self._rest(now, estimate)
        block, elapsed = self._plan[self._next], now - self._began
        if elapsed < block.duration:
            return block.setpoint(elapsed)
        self._next += 1
        self._began, self._calm_since, self._waiting_since = None, None, now
        return None

    def _rest(self, now: float, estimate: Estimate) -> Setpoint | None:
        """Wait for the drone to come to rest, then begin the next block."""
        self._waiting_since = now if self._waiting_since is None else self._waiting_since
        is_near = distance(estimate.position[:2], self._box.centre) < REST_DISTANCE
        calm = is_near and hypot(*estimate.velocity) < _REST_SPEED
        self._calm_since = (now if self._calm_since is None else self._calm_since) if calm else None
        if self._calm_since is not None and now - self._calm_since >= REST_TIME:
            self._began = now
            self.flown.append(Flown(self._plan[self._next], now))
            return self._plan[self._next].setpoint(0.0)
        if now - self._waiting_since > _REST_TIMEOUT:
            return self._given_up(f"the drone did not come to rest within {_REST_TIMEOUT:.0f} s")
        return None

    def _given_up(self, problem: str) -> Setpoint | None:
        self.problem = problem
        return None
