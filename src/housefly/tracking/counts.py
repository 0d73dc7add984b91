"""Statistics of a tracking client."""

from __future__ import annotations

from dataclasses import dataclass


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
