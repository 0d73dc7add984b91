"""The person at the door as tracking sees them: a body that stands still, or is away."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from housefly.messages import Pose
from housefly.twin.mocap.cameras import MocapCameras
from housefly.twin.physics import Physics
from housefly.twin.quadrotor.body import HULL_GROUP, VISUAL_GROUP


class Visitor:
    """Presence and pose of the visitor.

    Whether the cameras see them is computed when they come or go, and on ``update_visibility``.
    """

    def __init__(self, physics: Physics, cameras: MocapCameras) -> None:
        self._physics, self._cameras = physics, cameras
        self._seen: Pose | None = None
        self._present = False

    @property
    def present(self) -> bool:
        """Whether the visitor is there."""
        return self._present

    @property
    def seen(self) -> Pose | None:
        """True pose when the visitor is there and the cameras see them, else None."""
        return self._seen

    def set_present(self, present: bool) -> None:
        """Come to the door, or leave."""
        self._physics.set_visitor(present)
        self._present = present
        self.update_visibility()

    def update_visibility(self) -> None:
        """Compute again whether the cameras see the visitor; somebody may stand in between."""
        pose = self._physics.visitor_pose() if self._present else None
        visible = pose is not None and self._cameras.see(
            self._physics.visitor_markers(), self._physics.visitor_id, _ALL_BUT_THE_DRONE
        )
        self._seen = pose if visible else None


_ALL_BUT_THE_DRONE: NDArray[np.uint8] = np.array(
    [group not in (VISUAL_GROUP, HULL_GROUP) for group in range(6)], np.uint8
)
