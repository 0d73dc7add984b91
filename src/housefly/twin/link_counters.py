"""What happened on the ports of a simulated drone."""

from __future__ import annotations

from dataclasses import dataclass


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
