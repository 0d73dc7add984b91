"""Unix time that never goes back: what the room remembers stays in the order of what happened."""

from __future__ import annotations

import time
from collections.abc import Callable
from threading import Lock

from housefly.messages.words import literal
from housefly.sensors.contracts import SensorHealth

STEP = 1.0
"""A difference between the two clocks of more than this [s] is a step, less is their drift."""


class WallClock:
    """Unix time from the monotonic clock; takes steps of the wall clock forward, not back.

    A machine whose clock is set back by two hours would otherwise report everything as older than
    what it knows, and the memory would stand still for two hours.

    Args:
        wall: Unix time [s].
        monotonic: monotonic time [s].
        newest: Unix time of the newest thing remembered [s]; the clock starts behind it.

    Attributes:
        set_back: by how much the wall clock was set back and not followed [s].
    """

    def __init__(
        self,
        wall: Callable[[], float] = time.time,
        monotonic: Callable[[], float] = time.monotonic,
        newest: float = float("-inf"),
    ) -> None:
        self.set_back = 0.0
        self._wall, self._monotonic, self._lock = wall, monotonic, Lock()
        self._offset = max(wall(), newest) - monotonic()

    def offset(self) -> float:
        """Return the Unix time at which the monotonic clock was zero [s]; it never falls."""
        with self._lock:
            ahead = self._wall() - self._monotonic() - self._offset
            if ahead > 0.0:
                self._offset += ahead
            self.set_back = -ahead if ahead < -STEP else 0.0
            return self._offset

    def now(self) -> float:
        """Return Unix time [s]; it never goes back."""
        return self.offset() + self._monotonic()

    def health(self) -> tuple[SensorHealth, ...]:
        """Return that the wall clock was set back, if it was."""
        self.offset()
        if not self.set_back:
            return ()
        problem = literal(
            f"the machine's clock was set back by {self.set_back:.0f} s; the memory counts on from"
            " before, so its times run ahead by that until Housefly is started again"
        )
        return (SensorHealth("clock", "clock", "the machine's clock", False, problem=problem),)
