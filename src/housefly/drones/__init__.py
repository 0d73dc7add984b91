"""Drone drivers, by model: a new one is one row here, a folder and an airframe file.

Only the driver that is asked for is loaded: its process is the last that may die, and small.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from housefly.clock import Clock
    from housefly.config.drone import DroneConfig
    from housefly.config.limits import LimitsConfig
    from housefly.drones.contract import DroneDriver

DRIVERS = {
    "ardrone": ("housefly.drones.ardrone.driver", "ArDrone"),
}
"""Module and class of each ``drone.kind``; made of its configuration, the limits and a clock."""


def driver_of(config: DroneConfig, limits: LimitsConfig, clock: Clock) -> DroneDriver:
    """Return the driver of a site's drone, not yet connected."""
    module, name = DRIVERS[config.kind]
    driver: DroneDriver = getattr(import_module(module), name)(config, limits, clock)
    return driver
