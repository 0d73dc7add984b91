"""Keeps a world in step with the clock."""

from __future__ import annotations

from collections.abc import Callable

from housefly.bus.rate import Rate
from housefly.clock import Clock
from housefly.twin.contracts import TwinWorld

_TICK_HZ = 200.0
"""Steps per second; the navdata rate of the real drone."""
MAX_CATCH_UP = 0.3
"""Longest stall to catch up with [s]: to the pilot it is a link that stood still.

Time beyond it is lost and counted: a drone would fly too far without its pilot.
"""


class RealTimeRunner:
    """Advances a world to the present.

    Attributes:
        slipped: time [s] that the world has lost for good because the machine stalled.
    """

    def __init__(self, world: TwinWorld, clock: Clock) -> None:
        self.slipped = 0.0
        self._world = world
        self._clock = clock
        self._offset = world.now - clock.now()

    def catch_up(self) -> None:
        """Advance the world to the present, by ``MAX_CATCH_UP`` at most."""
        behind = self._clock.now() + self._offset - self._world.now
        if behind > MAX_CATCH_UP:
            self.slipped += behind - MAX_CATCH_UP
            self._offset -= behind - MAX_CATCH_UP
            behind = MAX_CATCH_UP
        if behind > 0.0:
            self._world.advance(behind)

    async def run(self, after_step: Callable[[], None] = lambda: None) -> None:
        """Keep the world in the present until cancelled; call ``after_step`` after each step."""
        rate = Rate(_TICK_HZ, self._clock)
        while True:
            await rate.sleep()
            self.catch_up()
            after_step()
