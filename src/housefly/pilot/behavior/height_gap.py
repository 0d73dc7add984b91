"""Whether something stands below the drone that no map shows: its own sensor against tracking."""

from __future__ import annotations

from math import isfinite

from housefly.messages.sensing import REPORT_AGE_MAX, DroneStatus
from housefly.pilot.behavior.mission import VehicleStatus

HEIGHT_GAP_MAX = 0.25
"""Something stands below when the floor seems nearer than tracking says by more than this [m]."""
HEIGHT_MIN = 0.2
"""A lower height is not measured, but told for want of an echo [m]."""


def height_gap(vehicle: VehicleStatus) -> float:
    """Return how high above the floor the ground below the drone is [m]; 0 where unknown."""
    report, estimate = vehicle.telemetry, vehicle.estimate
    if report is None or estimate is None or vehicle.status is not DroneStatus.FLYING:
        return 0.0
    if vehicle.telemetry_age > REPORT_AGE_MAX or not isfinite(report.height):
        return 0.0
    return estimate.position[2] - report.height if report.height >= HEIGHT_MIN else 0.0
