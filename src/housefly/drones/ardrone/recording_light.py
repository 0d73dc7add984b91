"""When the AR.Drone's lights are told to blink, because its camera is recorded.

AT*LED is not acknowledged: it is repeated, and the drone ends the animation by itself, so that a
lost datagram, a driver or a pilot that dies leave no light burning.
"""

from __future__ import annotations

from housefly.wires.ardrone import at

LIGHT_TIMEOUT = 1.5
"""Without another word that the camera is recorded the light goes out after this [s]."""
REPEAT_PERIOD = 1.0
"""How often the animation is sent while it goes on [s]."""
LED_INTERVAL_MIN = 0.1
"""Shortest time between two datagrams [s]."""
_CHANGE_REPEATS = 3
"""So many datagrams tell of a change: one may be lost."""
RECORDING_LED = at.Led(animation=2, frequency_hz=2.0, seconds=2)
"""Blinking red."""
STANDARD_LED = at.Led(animation=6, frequency_hz=1.0, seconds=1)


class RecordingLight:
    """Decides what leaves when; sends nothing itself."""

    def __init__(self) -> None:
        self._wanted_until = float("-inf")
        self._shows = False
        self._sent_at = float("-inf")
        self._repeats = 0

    def ask(self, records: bool, now: float) -> None:
        """Note whether the camera is recorded now [s]; counts for ``LIGHT_TIMEOUT``."""
        self._wanted_until = now + LIGHT_TIMEOUT if records else float("-inf")

    def due(self, now: float) -> at.Led | None:
        """Return what to send now [s], or None; what is returned counts as sent."""
        wanted = now <= self._wanted_until
        if wanted is not self._shows:
            self._shows, self._repeats = wanted, _CHANGE_REPEATS
        period = LED_INTERVAL_MIN if self._repeats else REPEAT_PERIOD
        if now - self._sent_at < period or not (wanted or self._repeats):
            return None
        self._sent_at, self._repeats = now, max(0, self._repeats - 1)
        return RECORDING_LED if wanted else STANDARD_LED
