"""Drone drivers, by model: one of ours is one row here, one of others an installed package.

Only the driver that is asked for is loaded: its process is the last that may die, and small.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from housefly.config.airframe import installed_models

if TYPE_CHECKING:
    from housefly.clock import Clock
    from housefly.config.drone import DroneConfig
    from housefly.config.limits import LimitsConfig
    from housefly.drones.contract import DroneDriver

DRIVERS = {
    "ardrone": ("housefly.drones.ardrone.driver", "ArDrone"),
    "arducopter": ("housefly.drones.mavlink.driver", "MavlinkDrone"),
    "px4": ("housefly.drones.mavlink.driver", "MavlinkDrone"),
    "tello": ("housefly.drones.tello.driver", "Tello"),
    "crazyflie": ("housefly.drones.crazyflie.driver", "Crazyflie"),
    "crazyflie_brushless": ("housefly.drones.crazyflie.driver", "Crazyflie"),
    "betaflight": ("housefly.drones.betaflight.driver", "Betaflight"),
}
"""Module and class of each ``drone.kind``; made of its configuration, the limits and a clock."""


def driver_of(config: DroneConfig, limits: LimitsConfig, clock: Clock) -> DroneDriver:
    """Return the driver of a site's drone, not yet connected."""
    module, name = DRIVERS.get(config.kind) or _installed(config.kind)
    driver: DroneDriver = getattr(import_module(module), name)(config, limits, clock)
    return driver


def _installed(kind: str) -> tuple[str, str]:
    return f"{installed_models()[kind]}.driver", "Driver"
