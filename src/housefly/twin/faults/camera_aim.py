"""Where the drone's camera looks, and when: what fails of it before a picture is taken.

A rate that falls leaves out whole pictures before they are encoded; after that they would be
missing in those that follow.
"""

from __future__ import annotations

from dataclasses import replace

from housefly.geometry import quaternion_from_euler, quaternion_product
from housefly.messages import Pose
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.slots import Slots
from housefly.twin.faults.vocabulary import FaultKind


class CameraAim:
    """The drone's camera, before it takes a picture."""

    def __init__(self) -> None:
        self._slots = Slots()

    def seen_from(self, pose: Pose, active: tuple[Fault, ...], now: float) -> Pose | None:
        """Return the pose of a drone that would see what the next picture shows.

        Args:
            pose: of the drone.
            active: faults of the pictures.
            now: world time [s].

        None when no picture is taken now.
        """
        for fault in active:
            if fault.kind is FaultKind.SLOW and not self._slots.opens(fault, now):
                return None
            if fault.kind is FaultKind.WRONG:
                aside = quaternion_from_euler(0.0, 0.0, fault.size)
                pose = replace(pose, orientation=quaternion_product(pose.orientation, aside))
        return pose
