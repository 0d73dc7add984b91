"""Which stranger's program flies which model, by a variable of the environment that names it."""

from __future__ import annotations

import os
from collections.abc import Mapping
from importlib import import_module
from pathlib import Path

from housefly.twin.contracts import TwinDrone
from housefly.twin.drone_servers import DroneServer
from housefly.twin.link_filters import LinkFilters

PROGRAMS = {
    "arducopter": ("ARDUCOPTER", "housefly.twin.firmware.arducopter", "ArduCopterProgram"),
    "betaflight": ("BETAFLIGHT", "housefly.twin.firmware.betaflight", "BetaflightProgram"),
}
"""By model: the variable that names the program, module and class of what lets it fly."""


def program_server(
    kind: str,
    drone: TwinDrone,
    address: str,
    *,
    beyond_loopback: bool,
    filters: LinkFilters,
    environment: Mapping[str, str] = os.environ,
) -> DroneServer | None:
    """Return what lets a stranger's program fly a drone, not yet started; None where none is named.

    Args:
        kind: its model.
        drone: what flies.
        address: IP address to answer at.
        beyond_loopback: allow an address, and interfaces, that other machines can reach.
        filters: what stands between client and drone.
        environment: names the program.

    Raises:
        ConfigError: an address, or an interface, that other machines can reach.
    """
    variable, module, name = PROGRAMS.get(kind, ("", "", ""))
    path = environment.get(variable, "") if variable else ""
    if not path:
        return None
    server: DroneServer = getattr(import_module(module), name)(
        drone, address, program=Path(path), beyond_loopback=beyond_loopback, filters=filters
    )
    return server
