"""The room with its rigid bodies: MuJoCo integrates them, finds contacts and casts rays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.geometry import Vec2, quaternion_from_euler
from housefly.messages import Pose
from housefly.room.model import Room
from housefly.twin.contracts import AWAY_Z
from housefly.twin.drone_body import DroneBody
from housefly.twin.drone_stands import drone_stands
from housefly.twin.movable import AWAY_POSE, MOVABLE_PREFIX, Movable
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.people.bodies import PERSON_PREFIX
from housefly.twin.people.script import PersonScript
from housefly.twin.scene_mjcf import scene_mjcf
from housefly.twin.simulated_body import PHYSICS_PERIOD, PHYSICS_STEPS

_VISITOR_BODY = "visitor"


class Physics:
    """Drones among the furniture; moves by whole control periods.

    Attributes:
        drones: in the order of the site.
    """

    def __init__(
        self,
        site: Site,
        room: Room,
        people: tuple[PersonScript, ...] = (),
        movables: tuple[Movable, ...] = (),
    ) -> None:
        self.model: Any = mujoco.MjModel.from_xml_string(scene_mjcf(site, room, people, movables))
        self.model.opt.timestep = PHYSICS_PERIOD
        self.data: Any = mujoco.MjData(self.model)
        self.floors = frozenset({int(self.model.geom("floor").id)})
        self.drones = tuple(
            DroneBody(self.model, self.data, stand.body, stand.config, self.floors)
            for stand in drone_stands(site, room)
        )
        self.visitor_id: int = mujoco.mj_name2id(
            self.model, mujoco.mjtObj.mjOBJ_BODY, _VISITOR_BODY
        )
        self._visitor = (
            int(self.model.body_mocapid[self.visitor_id]) if self.visitor_id >= 0 else -1
        )
        self._visitor_at = self.data.mocap_pos[self._visitor].copy() if self._visitor >= 0 else None
        self._visitor_sites = [
            n
            for n in range(self.model.nsite)
            if self.model.site(n).name.startswith("visitor_marker_")
        ]
        self._people = _people_mocap_ids(self.model)
        mujoco.mj_forward(self.model, self.data)

    def advance(self, between: Callable[[], None] | None = None) -> None:
        """Hold what pushes the drones for one control period; call something between its steps."""
        if between is None:
            mujoco.mj_step(self.model, self.data, PHYSICS_STEPS)
            return
        mujoco.mj_step(self.model, self.data)
        for _ in range(1, PHYSICS_STEPS):
            between()
            mujoco.mj_step(self.model, self.data)

    def set_visitor(self, present: bool) -> None:
        """Move the visitor, if the room has one, to the door or out of the building."""
        if self._visitor_at is None:
            return
        self.data.mocap_pos[self._visitor] = self._visitor_at + (
            0.0 if present else np.array((0.0, 0.0, AWAY_Z))
        )
        mujoco.mj_kinematics(self.model, self.data)

    def set_people(self, poses: tuple[Pose, ...]) -> None:
        """Move the people, in the order of their scripts; sight and touch follow with a step."""
        for number, pose in zip(self._people, poses, strict=True):
            self.data.mocap_pos[number], self.data.mocap_quat[number] = (
                pose.position,
                pose.orientation,
            )

    def show(self) -> None:
        """Let rays meet whatever was moved since the last step."""
        mujoco.mj_kinematics(self.model, self.data)

    def put(self, name: str, place: Vec2 | None, yaw: float) -> None:
        """Stand a movable thing on the floor [m], turned by yaw [rad]; None removes it."""
        number = self.model.body_mocapid[self.model.body(f"{MOVABLE_PREFIX}{name}").id]
        self.data.mocap_pos[number] = AWAY_POSE.position if place is None else (*place, 0.0)
        self.data.mocap_quat[number] = quaternion_from_euler(0.0, 0.0, yaw)
        mujoco.mj_kinematics(self.model, self.data)

    def movable(self, name: str) -> tuple[int, Pose | None]:
        """Return the body id and pose of a movable thing; None while it is out of the room."""
        body = int(self.model.body(f"{MOVABLE_PREFIX}{name}").id)
        number = self.model.body_mocapid[body]
        x, y, z = self.data.mocap_pos[number].tolist()
        qw, qx, qy, qz = self.data.mocap_quat[number].tolist()
        return body, Pose((x, y, z), (qw, qx, qy, qz)) if z > AWAY_Z / 2 else None

    def person_id(self, name: str) -> int:
        """Return the body id of somebody."""
        return int(self.model.body(f"{PERSON_PREFIX}{name}").id)

    def visitor_pose(self) -> Pose | None:
        """Return where the visitor stands now; None in a room without one."""
        if self._visitor_at is None:
            return None
        x, y, z = self.data.mocap_pos[self._visitor].tolist()
        qw, qx, qy, qz = self.data.mocap_quat[self._visitor].tolist()
        return Pose((x, y, z), (qw, qx, qy, qz))

    def visitor_markers(self) -> NDArray[np.float64]:
        """Return the world positions of the visitor's markers [m], shape (n, 3)."""
        positions: NDArray[np.float64] = self.data.site_xpos[self._visitor_sites].copy()
        return positions


def _people_mocap_ids(model: Any) -> tuple[int, ...]:
    """Return the mocap ids of the people of a model, in the order of the script."""
    people = (n for n in range(model.nbody) if model.body(n).name.startswith(PERSON_PREFIX))
    return tuple(int(model.body_mocapid[n]) for n in people)
