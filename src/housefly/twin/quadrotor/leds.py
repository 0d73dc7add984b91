"""The simulated drone's four lights: which animation they play.

Numbers: Parrot ARDroneLib SDK 2.0.1, led_animation.h. A duration of 0 plays for ever.
"""

from __future__ import annotations

from math import inf, isfinite

STANDARD_ANIMATION = 6
"""Front lights green, rear lights red: what is shown when nothing is played."""
_ANIMATIONS = range(21)


class Leds:
    """Plays one animation at a time."""

    def __init__(self) -> None:
        self._animation, self._until = STANDARD_ANIMATION, inf

    def play(self, animation: int, frequency_hz: float, seconds: float, now: float) -> bool:
        """Begin an animation and return True, or False for one that does not exist.

        Args:
            animation: its number.
            frequency_hz: how often it is repeated.
            seconds: how long [s].
            now: world time [s].
        """
        if animation not in _ANIMATIONS or seconds < 0.0:
            return False
        if not (isfinite(frequency_hz) and frequency_hz > 0.0):
            return False
        self._animation, self._until = animation, now + seconds if seconds else inf
        return True

    def animation(self, now: float) -> int:
        """Return the number of the animation that is played at a world time [s]."""
        return self._animation if now < self._until else STANDARD_ANIMATION
