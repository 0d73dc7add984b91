"""What a motion capture client offers to the pilot's shell."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from housefly.messages import Sighting

Sink = Callable[[tuple[Sighting, ...]], None]
"""Gets the sightings of one frame."""


class Tracker(Protocol):
    """One motion capture system; all calls belong to one asyncio loop."""

    async def run(self, sink: Sink) -> None:
        """Connect, hand each frame's sightings to the sink, reconnect for ever; ends only when
        cancelled.
        """
        ...

    @property
    def connected(self) -> bool:
        """Whether frames arrive (within the last second)."""
        ...

    @property
    def problem(self) -> str:
        """Why not, in words, or ""."""
        ...
