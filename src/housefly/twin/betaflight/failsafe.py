"""What a simulated Betaflight does once sticks stay away; as in flight/failsafe.c."""

from __future__ import annotations

from enum import Enum

from housefly.wires.betaflight.settings import FailsafeProcedure, FailsafeSettings

RECOVERY = 0.5
"""RadioSticks must have come for so long before they are believed again [s]."""
THROTTLE_LOW_FOR = 10.0
"""A throttle that was low for so long before means that it stands: it disarms [s]."""


class Phase(Enum):
    """Where the failsafe is."""

    IDLE = "idle"
    LANDING = "landing"
    STOPPED = "stopped"


class FcFailsafe:
    """The second stage of one drone's failsafe.

    Args:
        now: when it was switched on [s].

    Attributes:
        phase: where it is.
        is_up: whether sticks are believed.
    """

    def __init__(self, now: float) -> None:
        self.phase, self.is_up = Phase.IDLE, False
        self._lost_at: float | None = now
        self._lands_until = self._throttle_up_at = 0.0

    def update(
        self,
        now: float,
        silence: float,
        settings: FailsafeSettings,
        *,
        is_lost: bool,
        is_armed: bool,
        throttle_is_low: bool,
    ) -> None:
        """Follow the sticks, once a control period.

        Args:
            now: [s].
            silence: how long ago they came last [s].
            settings: how it is set.
            is_lost: whether they count as lost.
            is_armed: whether motors turn.
            throttle_is_low: whether the throttle is off.
        """
        if is_lost:
            self._lost_at = now
        elif self._lost_at is not None and now - self._lost_at > RECOVERY:
            self.is_up, self._lost_at = True, None
        if silence > settings.delay:
            self.is_up = False
        if is_armed and not throttle_is_low:
            self._throttle_up_at = now
        self._follow(now, settings, is_armed=is_armed)

    def _follow(self, now: float, settings: FailsafeSettings, *, is_armed: bool) -> None:
        match self.phase:
            case Phase.IDLE if is_armed and not self.is_up:
                is_standing = now - self._throttle_up_at > THROTTLE_LOW_FOR
                lands = settings.procedure is not FailsafeProcedure.DROP and not is_standing
                self.phase = Phase.LANDING if lands else Phase.STOPPED
                self._lands_until = now + settings.landing_time
            case Phase.LANDING if self.is_up:
                self.phase = Phase.IDLE
            case Phase.LANDING if now > self._lands_until or not is_armed:
                self.phase = Phase.STOPPED
            case Phase.STOPPED if self.is_up and not is_armed:
                self.phase = Phase.IDLE
            case _:
                return
