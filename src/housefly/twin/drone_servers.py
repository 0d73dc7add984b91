"""What serves a simulated drone on its wire, by model; an installed package brings its own."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from pathlib import Path
from typing import Protocol, runtime_checkable

from housefly.config.airframe import installed_models
from housefly.errors import ConfigError
from housefly.twin.address import check_address
from housefly.twin.contracts import DroneCamera, EncodedPicture, TwinDrone
from housefly.twin.link_counters import Counters
from housefly.twin.link_filters import LinkFilters


class DroneServer(Protocol):
    """The drone's side of its wire; made of the simulated drone and the address to answer at."""

    async def start(self) -> None:
        """Open the wire; raises LinkError when a port cannot be had."""
        ...

    async def stop(self) -> None:
        """Close it."""
        ...


@runtime_checkable
class FilmingServer(DroneServer, Protocol):
    """The same of a drone with a camera."""

    @property
    def counters(self) -> Counters:
        """What happened on its ports so far."""
        ...

    @property
    def camera(self) -> DroneCamera:
        """The camera whose pictures the client wants."""
        ...

    def publish(self, picture: EncodedPicture) -> None:
        """Send a picture to whoever wants pictures; returns at once."""
        ...


SERVERS = {
    "ardrone": ("housefly.twin.ardrone.server", "ArDroneServer"),
    "arducopter": ("housefly.twin.mavlink.server", "MavlinkServer"),
    "betaflight": ("housefly.twin.betaflight.server", "BetaflightServer"),
    "crazyflie": ("housefly.twin.crazyflie.server", "CrazyflieServer"),
    "crazyflie_brushless": ("housefly.twin.crazyflie.server", "CrazyflieServer"),
    "px4": ("housefly.twin.mavlink.server", "Px4Server"),
    "tello": ("housefly.twin.tello.server", "TelloServer"),
}
"""Module and class of what serves each of our own models."""
PROGRAMS = {
    "arducopter": ("ARDUCOPTER", "housefly.twin.firmware.arducopter", "ArduCopterProgram"),
    "betaflight": ("BETAFLIGHT", "housefly.twin.firmware.betaflight", "BetaflightProgram"),
}
"""By model: the variable of the environment that names a stranger's firmware, module and class of
what lets it fly.
"""
PORTS: dict[str, tuple[tuple[int, str], ...]] = {
    "ardrone": ((5554, "UDP"), (5556, "UDP"), (5555, "TCP"), (5559, "TCP")),
    "arducopter": ((14550, "UDP"), (5760, "TCP")),
    "betaflight": ((5761, "TCP"),),
    "crazyflie": ((19850, "UDP"),),
    "crazyflie_brushless": ((19850, "UDP"),),
    "px4": ((14580, "UDP"), (5760, "TCP")),
    "tello": ((8889, "UDP"), (8890, "UDP"), (11111, "UDP")),
}
"""What each of these listens on; of a Tello, with what its client listens on."""


def server_of(
    kind: str,
    drone: TwinDrone,
    address: str,
    *,
    beyond_loopback: bool,
    filters: LinkFilters,
    environment: Mapping[str, str] | None = None,
) -> DroneServer:
    """Return what serves a drone of a model, not yet started.

    Args:
        kind: its model.
        drone: what flies.
        address: IP address to answer at.
        beyond_loopback: allow an address, and of a program interfaces, that other machines can
            reach.
        filters: what stands between client and drone; only our own servers have them.
        environment: may name a stranger's program that flies it; None names none.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``; a model whose
            wire nothing simulates.
    """
    variable, module, name = PROGRAMS.get(kind, ("", "", ""))
    if program := (environment or {}).get(variable, ""):
        flown: DroneServer = getattr(import_module(module), name)(
            drone, address, program=Path(program), beyond_loopback=beyond_loopback, filters=filters
        )
        return flown
    if kind in SERVERS:
        module, name = SERVERS[kind]
        own: DroneServer = getattr(import_module(module), name)(
            drone, address, beyond_loopback=beyond_loopback, filters=filters
        )
        return own
    if kind not in installed_models():
        raise ConfigError(
            "drone.kind", f"is {kind!r}: nothing simulates its wire; it flies in lock step only"
        )
    check_address("drone.address", address, beyond_loopback)
    server: DroneServer = import_module(f"{installed_models()[kind]}.twin").Server(drone, address)
    return server
