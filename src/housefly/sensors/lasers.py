"""The client of each kind of scanner."""

from __future__ import annotations

from collections.abc import Callable

from housefly.clock import Clock
from housefly.config.laser import LaserConfig, LaserKind
from housefly.sensors.laser import LaserClient
from housefly.sensors.ros2_laser import Ros2LaserClient

AnyLaserClient = LaserClient | Ros2LaserClient
"""A client that hands scans to a sink."""

LASERS: dict[LaserKind, Callable[[LaserConfig, Clock], AnyLaserClient]] = {
    "scip": LaserClient,
    "ros2": Ros2LaserClient,
}
"""The client of each ``lasers.kind``."""


def laser_client(config: LaserConfig, clock: Clock) -> AnyLaserClient:
    """Return the client of a scanner."""
    return LASERS[config.kind](config, clock)
