"""What may take the place of holding: a test, flown by whoever knows what it needs, behind the same
last gate.
"""

from __future__ import annotations

from typing import Protocol

from housefly.messages import Command, Estimate


class Maneuver(Protocol):
    """Asked once a step while the pilot holds a place, nothing is stopped, and the drone is seen."""

    def propose(self, now: float, estimate: Estimate, otherwise: Command) -> Command:
        """Return the command to be judged by the last gate.

        Args:
            now: time [s].
            estimate: where the drone is.
            otherwise: the command that holds the place.
        """
        ...
