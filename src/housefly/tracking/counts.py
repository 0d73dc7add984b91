"""What came over the wire of a tracking system so far."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(slots=True)
class FrameCounts:
    """What came over the wire so far.

    Attributes:
        frames: frames used.
        repeated: frames dropped because they were the last one again.
        backward: frames dropped because they were older than the last one.
        refused: poses dropped because they were not finite, not a rotation, or a kilometre away.
        misstamped: frames whose latency could not be, and whose capture time was taken from their
            arrival.
        jumps: how often the server's clock leapt by a second or more.
        flooded: frames dropped because more came than any tracking system sends.
        malformed: datagrams or messages that are not the protocol.
        strangers: datagrams from another machine than the one asked.
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
    strangers: int = 0
    unnamed: int = 0
