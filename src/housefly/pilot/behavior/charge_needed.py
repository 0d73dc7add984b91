"""The charge that a flight of some time needs."""

from __future__ import annotations

from housefly.config.limits import LimitsConfig

LANDING_TIME = 15.0
"""A landing, with what goes before it, takes no longer than this [s]."""
RETURN_RESERVE = 0.02
"""Charge that is left above the floor when a drone that turned home in time stands."""


def charge_for(seconds: float, drain: float, limits: LimitsConfig) -> float:
    """Return the charge [1] that a flight of so long and a landing need; drain in 1/s."""
    return limits.battery_floor + RETURN_RESERVE + drain * (seconds + LANDING_TIME)
