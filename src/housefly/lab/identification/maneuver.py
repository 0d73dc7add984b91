"""The blocks in flight: each begun at rest in the middle of the box, all given up when anything is
not as it should be.
"""

from __future__ import annotations

from math import hypot, inf

from housefly.geometry import distance
from housefly.lab.identification.box import Box
from housefly.lab.identification.pattern import Block
from housefly.lab.identification.samples import Flown
from housefly.messages import Action, Command, Estimate

NEAR, SLOW, CALM = 0.2, 0.08, 0.8
"""A block begins when the drone was this near to the middle [m], this slow [m/s], for this long
[s].
"""
PATIENCE = 25.0
"""A drone that does not come to rest for this long is given up [s]."""
STALE = 0.25
"""A pose older than this ends the test [s]."""
GAP = 0.15
"""A block in which the pilot did something else for this long is lost, and the test with it [s]."""


class Maneuver:
    """Implements ``behavior.maneuver.Maneuver``: replaces what the pilot would ask while it holds.

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
        """How many blocks were flown."""
        return self._next

    def propose(self, now: float, estimate: Estimate, otherwise: Command) -> Command:
        """Return what is asked now [s] while the pilot holds; ``otherwise`` is what holds the
        place.
        """
        gap, self._asked_at = now - self._asked_at, now
        if self.finished:
            return otherwise
        if self._began is not None and gap > GAP:
            return self._given_up("it was interrupted in the middle of a step", otherwise)
        if not self._box.holds(estimate.position):
            return (
                self._given_up("the drone left the box", otherwise) if self._entered else otherwise
            )
        self._entered = True
        if estimate.pose_age > STALE:
            return self._given_up(f"tracking was lost for {estimate.pose_age:.2f} s", otherwise)
        if self._began is None:
            return self._rested(now, estimate, otherwise)
        block, elapsed = self._plan[self._next], now - self._began
        if elapsed >= block.duration:
            self._next, self._began, self._calm_since, self._waiting_since = (
                self._next + 1,
                None,
                None,
                now,
            )
            return otherwise
        return Command(Action.FLY, block.setpoint(elapsed))

    def _rested(self, now: float, estimate: Estimate, otherwise: Command) -> Command:
        """Wait for the drone to come to rest, then begin the next block."""
        self._waiting_since = now if self._waiting_since is None else self._waiting_since
        vx, vy, vz = estimate.velocity
        calm = distance(estimate.position[:2], self._box.centre) < NEAR and hypot(vx, vy, vz) < SLOW
        self._calm_since = (now if self._calm_since is None else self._calm_since) if calm else None
        if self._calm_since is not None and now - self._calm_since >= CALM:
            self._began = now
            self.flown.append(Flown(self._plan[self._next], now))
            return Command(Action.FLY, self._plan[self._next].setpoint(0.0))
        if now - self._waiting_since > PATIENCE:
            return self._given_up(
                f"the drone did not come to rest within {PATIENCE:.0f} s", otherwise
            )
        return otherwise

    def _given_up(self, problem: str, otherwise: Command) -> Command:
        self.problem = problem
        return otherwise
