"""What may take the place of holding: a test, flown behind the same last gate."""

from __future__ import annotations

from typing import Protocol

from housefly.messages import Estimate, Setpoint


class Maneuver(Protocol):
    """Asked once a step while the pilot holds a place and the drone is seen."""

    def propose(self, now: float, estimate: Estimate) -> Setpoint | None:
        """Return the setpoint to fly now [s], or None to hold the place."""
        ...
