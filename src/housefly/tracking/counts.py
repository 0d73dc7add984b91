"""Statistics of a tracking client."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import inf, isfinite

from housefly.bus.reconnect import DATA_AGE_MAX
from housefly.geometry import Vec3
from housefly.messages.words import UNSAID, Words
from housefly.tracking.poses import POSITION_MAX

UNIT_QUESTION = Words("is its unit millimetres? choose metres in the tracking software")


@dataclass(slots=True)
class FrameCounts:
    """What arrived so far, and what was dropped.

    Attributes:
        frames: frames used.
        repeated: frames dropped because they were the last one again.
        backward: frames dropped because they were older than the last one.
        refused: poses dropped because they were not finite, not a rotation, or a kilometre away.
        misstamped: frames with an impossible latency; their capture time is that of their arrival.
        jumps: how often the server's clock jumped by a second or more.
        flooded: frames dropped because more arrived than any tracking system sends.
        malformed: datagrams that are not the protocol.
        other_hosts: datagrams from a machine other than the one asked.
        unnamed: poses of bodies whose name is not known (yet).
    """

    frames: int = 0
    repeated: int = 0
    backward: int = 0
    refused: int = 0
    misstamped: int = 0
    jumps: int = 0
    flooded: int = 0
    malformed: int = 0
    other_hosts: int = 0
    unnamed: int = 0
    _far: str = field(default="", repr=False)
    _far_at: float = field(default=-inf, repr=False)

    def refuse(self, body: str, position: Vec3, now: float) -> None:
        """Count a refused pose, and remember one that is where no tracked room reaches [m, s]."""
        self.refused += 1
        if all(map(isfinite, position)) and max(map(abs, position)) > POSITION_MAX:
            x, y, z = position
            self._far = f"{body!r} at ({x:.0f}, {y:.0f}, {z:.0f}) m"
            self._far_at = now

    def unit_problem(self, now: float) -> Words:
        """Return that poses are refused because they cannot be metres; UNSAID if none are."""
        recent = now - self._far_at <= DATA_AGE_MAX
        return (
            Words("poses are refused, {pose}: {ask}", pose=self._far, ask=UNIT_QUESTION)
            if recent
            else UNSAID
        )
