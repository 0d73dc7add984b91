"""Environment variables by which the launcher tells each process of a run what it needs."""

from __future__ import annotations

SITE_VARIABLE = "HOUSEFLY_SITE"
"""Path of the checked site, as JSON."""
BUS_VARIABLE = "HOUSEFLY_BUS"
"""Zenoh endpoint on which the pilot listens."""
STOP_PORT_VARIABLE = "HOUSEFLY_STOP_PORT"
"""Loopback UDP port of the STOP path."""
SECRET_VARIABLE = "HOUSEFLY_SECRET"
"""Key of the STOP path."""
TOKEN_VARIABLE = "HOUSEFLY_TOKEN"
"""One-time token of the console's address."""
ROOM_SOCKET_VARIABLE = "HOUSEFLY_ROOM_SOCKET"
"""Unix socket on which the hub answers programs of this user."""
ROOM_KEY_VARIABLE = "HOUSEFLY_ROOM_KEY"
"""Key with which they ask it: other users can read command lines."""
DRIVER_SOCKET_VARIABLE = "HOUSEFLY_DRIVER_SOCKET"
"""Unix socket on which the driver waits for its pilot."""

RECORDING_VARIABLE = "HOUSEFLY_RECORDING"
"""Folder into which the whole run is recorded; not set when none is."""
