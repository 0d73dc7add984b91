"""State and counters that the simulated AR.Drone's four ports share."""

from __future__ import annotations

from dataclasses import dataclass, field

from housefly.twin.address import PeerAddress

LINK_LOST_AFTER = 2.0
"""Silence on the AT port [s] that resets the sequence and stops navdata (docs/wires.md, 4)."""


@dataclass(slots=True)
class Counters:
    """Counts of what arrived, left and was refused."""

    datagrams: int = 0
    commands: int = 0
    stale_commands: int = 0
    malformed: int = 0
    refused_settings: int = 0
    navdata_sent: int = 0
    navdata_unsent: int = 0
    refused_requests: int = 0
    config_dumps: int = 0
    frames_sent: int = 0
    frames_dropped: int = 0


@dataclass(slots=True)
class Link:
    """State of the connection to the client.

    Attributes:
        acknowledged: state bit 6: a setting arrived and its acknowledgement was not cleared yet.
        bootstrap: state bit 11: no client has chosen demo or full navdata yet.
        client: where navdata goes; the last requester wins, as on the real drone.
        last_command_at: world time of the last command that parsed [s]; None before the first.
        counters: what happened on the ports.
    """

    acknowledged: bool = False
    bootstrap: bool = True
    client: PeerAddress | None = None
    last_command_at: float | None = None
    counters: Counters = field(default_factory=Counters)

    def silent_since(self, now: float, seconds: float) -> bool:
        """Return whether commands came before, but none in the last ``seconds``."""
        return self.last_command_at is not None and now - self.last_command_at > seconds
