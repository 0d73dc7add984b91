"""What the simulated cameras see of everything that carries markers."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from housefly.config.site import Site
from housefly.geometry import Vec3, rotate
from housefly.messages import Pose
from housefly.numeric import FloatArray
from housefly.twin.drone_body import DroneBody
from housefly.twin.mocap.cameras import MocapCameras
from housefly.twin.movable import Movable, marker_positions
from housefly.twin.people.scene_player import ScenePlayer
from housefly.twin.people.visitor import Visitor
from housefly.twin.physics import Physics

_HEAD: tuple[Vec3, ...] = ((0.1, 0.02, 0.0), (0.0, 0.1, 0.01), (-0.1, 0.0, 0.0), (0.0, -0.09, 0.0))
"""Markers of a person, relative to the top of the head [m]."""


class MarkedBodies:
    """The drones, the visitor, furniture with markers, and the people whom the site names.

    Args:
        site: names of the bodies.
        drones: their bodies in the model, by their names in tracking.
        physics, cameras: who sees what.
        visitor: the person at the door.
        movables: whatever can be moved; only what the site's furniture names carries markers.
        stage: the people.
    """

    def __init__(
        self,
        site: Site,
        drones: Mapping[str, DroneBody],
        physics: Physics,
        cameras: MocapCameras,
        visitor: Visitor,
        movables: tuple[Movable, ...],
        stage: ScenePlayer,
    ) -> None:
        marked = {piece.body for piece in site.furniture}
        self._tracking, self._drones = site.tracking, drones
        self._physics, self._cameras, self._visitor = physics, cameras, visitor
        self._marked = tuple(movable for movable in movables if movable.name in marked)
        self._stage = stage
        self._people = tuple(name for name in site.people.bodies if stage.has(name))

    def seen(self) -> tuple[tuple[str, Pose | None], ...]:
        """Return name and true pose of every body; None for whom nobody sees."""
        return (
            *((name, self._drone(drone)) for name, drone in self._drones.items()),
            (self._tracking.visitor, self._visitor.seen),
            *((movable.name, self._movable(movable)) for movable in self._marked),
            *((name, self._person(name)) for name in self._people),
        )

    def _drone(self, drone: DroneBody) -> Pose | None:
        state = drone.state()
        pose = Pose(state.position, state.orientation)
        return self._seen(pose, _markers(pose, drone.markers), drone.number)

    def _movable(self, movable: Movable) -> Pose | None:
        body, pose = self._physics.movable(movable.name)
        return None if pose is None else self._seen(pose, marker_positions(movable, pose), body)

    def _person(self, name: str) -> Pose | None:
        pose, height = self._stage.present_pose(name), self._stage.height(name)
        if pose is None:
            return None
        markers = np.array([rotate(pose.orientation, (x, y, height + z)) for x, y, z in _HEAD])
        return self._seen(pose, markers + pose.position, self._physics.person_id(name))

    def _seen(self, pose: Pose, markers: FloatArray, own_body: int) -> Pose | None:
        return pose if self._cameras.see(markers, own_body) else None


def _markers(drone: Pose, markers: tuple[Vec3, ...]) -> FloatArray:
    """Return the world positions of the drone's markers [m], shape (n, 3)."""
    positions: FloatArray = (
        np.array([rotate(drone.orientation, marker) for marker in markers]) + drone.position
    )
    return positions
