"""Environment variables by which the launcher tells each process of a run what it needs."""

from __future__ import annotations

from collections.abc import Mapping

SITE_VARIABLE = "HOUSEFLY_SITE"
"""Path of the checked site, as JSON."""
BUS_VARIABLE = "HOUSEFLY_BUS"
"""Zenoh endpoint on which the room's process listens."""
STOP_PORTS_VARIABLE = "HOUSEFLY_STOP_PORTS"
"""Loopback UDP ports of the STOP path by drone, as ``red=40001,blue=40002``."""
SECRET_VARIABLE = "HOUSEFLY_SECRET"
"""Key of the STOP path."""
TOKEN_VARIABLE = "HOUSEFLY_TOKEN"
"""One-time token of the console's address."""
ROOM_KEY_VARIABLE = "HOUSEFLY_ROOM_KEY"
"""Key with which they ask it: other users can read command lines."""
SOCKETS_VARIABLE = "HOUSEFLY_SOCKETS"
"""Folder of the run's private sockets."""
RECORDING_VARIABLE = "HOUSEFLY_RECORDING"
"""Folder into which the whole run is recorded; not set when none is."""


def stop_ports_to_text(ports: Mapping[str, int]) -> str:
    """Return the ports of STOP as the environment holds them."""
    return ",".join(f"{name}={port}" for name, port in ports.items())


def stop_ports_of_text(text: str) -> dict[str, int]:
    """Return the ports of STOP by drone; raises ValueError for a text that holds none."""
    pairs = (item.partition("=") for item in text.split(",") if item)
    return {name: int(port) for name, _, port in pairs}
