"""What a motion capture client offers to the pilot's shell."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from housefly.messages import Sighting
from housefly.messages.words import Words

SightingSink = Callable[[tuple[Sighting, ...]], None]
"""Receives the sightings of one frame."""


class Tracker(Protocol):
    """One motion capture system; all calls belong to one asyncio loop."""

    async def run(self, sink: SightingSink) -> None:
        """Connect, hand on each frame's sightings, reconnect for ever; ends only when cancelled."""
        ...

    @property
    def connected(self) -> bool:
        """Whether frames arrive (within the last second)."""
        ...

    @property
    def problem(self) -> Words:
        """Why not; UNSAID where all is well."""
        ...
