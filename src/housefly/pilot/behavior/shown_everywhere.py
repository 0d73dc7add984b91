"""Whether the sonar shows something low wherever the drone flies: then the sonar is wrong.

What stands below begins and ends. A sonar that is off by a constant, or noisy, shows something on
the whole of a long way; tracking that is too high looks the same, and is as harmless to land by.
"""

from __future__ import annotations

from collections import deque

from housefly.geometry import Vec2, distance

STEP = 0.25
"""The way is looked at in steps of this length [m] ..."""
STEPS, SHOWN_STEPS = 12, 11
"""... so many of them, and something showed in so many: no piece of furniture is as long."""
LOW = 0.55
"""Who may follow the drone is taller than this [m]: what is lower on average does not walk."""


class ShownEverywhere:
    """Remembers on which steps of the last way something showed below."""

    def __init__(self) -> None:
        self._steps: deque[bool] = deque(maxlen=STEPS)
        self._begun: Vec2 | None = None
        self._shown = 0
        self._height = 0.0

    @property
    def is_wrong(self) -> bool:
        """Whether something low has shown nearly everywhere on the last three metres."""
        return len(self._steps) == STEPS and sum(self._steps) >= SHOWN_STEPS

    def forget(self) -> None:
        """Begin anew: the drone does not fly."""
        self._steps.clear()
        self._begun, self._shown, self._height = None, 0, 0.0

    def step(self, place: Vec2, height: float) -> None:
        """Take in how high what shows below a place [m] is [m]; 0 where nothing does."""
        if self._begun is None:
            self._begun = place
        if height > 0.0:
            self._shown += 1
            self._height += height
        if distance(place, self._begun) < STEP:
            return
        self._steps.append(0.0 < self._height < LOW * self._shown)
        self._begun, self._shown, self._height = place, 0, 0.0
