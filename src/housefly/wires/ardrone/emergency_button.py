"""The emergency bit: a toggle that acts on its rising edge.

It is therefore held until a report shows the wanted state, however many datagrams are lost, and
then released; a second press needs a report newer than the release.
"""

from __future__ import annotations

PRESS_TIME_MAX = 1.0
"""Longest press of the emergency button [s]; later reports could make it press twice."""
_RELEASE_TIME_MIN = 0.15
"""Shortest pause between two presses [s]."""


class EmergencyButton:
    """Held until the drone changes, then released before the next press."""

    def __init__(self) -> None:
        self._pressed_at: float | None = None
        self._released_at: float | None = None

    def release(self, now: float) -> None:
        """Let go; does nothing when the button is not held."""
        if self._pressed_at is not None:
            self._pressed_at, self._released_at = None, now

    def hold(self, now: float, report_at: float | None) -> bool:
        """Return whether the bit is set now.

        Args:
            now: [s].
            report_at: arrival of the newest report that asks for a press [s].
        """
        if self._pressed_at is not None:
            if now - self._pressed_at < PRESS_TIME_MAX:
                return True
            self.release(now)
        elif self._released_at is None or (
            report_at is not None and report_at - self._released_at > _RELEASE_TIME_MIN
        ):
            self._pressed_at = now
            return True
        return False

    def reset(self, now: float) -> None:
        """Let the next press not wait for a report, unless the button was held just now."""
        self.release(now)
        if self._released_at is not None and now - self._released_at > _RELEASE_TIME_MIN:
            self._released_at = None
