"""What the mission knows of the drone in one step."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec2
from housefly.messages import DroneStatus, Estimate


@dataclass(frozen=True, slots=True)
class VehicleStatus:
    """What the drone says, where it is, and whether the gate lands it.

    Attributes:
        now: time [s].
        status: last reported by the drone.
        battery: charge, 0 to 1.
        telemetry_age: [s].
        estimate: where it is, None before the first sighting.
        landing_forced: the safety gate is landing the drone.
    """

    now: float
    status: DroneStatus
    battery: float
    telemetry_age: float
    estimate: Estimate | None
    landing_forced: bool

    @property
    def place(self) -> Vec2 | None:
        """Position in the plane [m]."""
        return self.estimate.position[:2] if self.estimate else None

    @property
    def pose_age(self) -> float:
        """Age of the pose [s]; infinite before the first."""
        return self.estimate.pose_age if self.estimate else float("inf")
