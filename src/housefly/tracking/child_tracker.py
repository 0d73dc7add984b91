"""The base of trackers whose library runs in a child process."""

from __future__ import annotations

from housefly.bus.child_client import ChildClient
from housefly.clock import Clock
from housefly.messages import Sighting
from housefly.messages.words import Words
from housefly.tracking.counts import FrameCounts


class ChildTracker(ChildClient[tuple[Sighting, ...]]):
    """Hands the frames of its child to a sink as they arrive.

    Attributes:
        counts: frames and what was dropped.
    """

    def __init__(self, where: str, clock: Clock | None) -> None:
        super().__init__(where, clock)
        self.counts = FrameCounts()

    @property
    def problem(self) -> Words:
        """Why no poses arrive, or why they are refused; UNSAID where all is well."""
        return self._problem or self.counts.unit_problem(self._clock.now()) or super().problem

    def _silence(self) -> str:
        return f"{self._where} is silent; is it there, streaming, and this body seen?"
