"""The rigid body in its room: MuJoCo integrates it, finds contacts and casts rays.

The free joint's forces act in the world at the origin, its torques about the body axes; horizontal
drag is the joint's own damping, so that MuJoCo integrates it implicitly.
"""

from __future__ import annotations

from math import exp
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.geometry import Quaternion, Vec2, Vec3, quaternion_from_euler, rotate
from housefly.messages import Pose
from housefly.numeric import running_sum
from housefly.room.model import Room
from housefly.twin.ardrone.body import BODY, DRONE_MASS, INERTIA, STANDING_HEIGHT
from housefly.twin.contracts import AWAY_Z
from housefly.twin.disturbance import Payload
from housefly.twin.external_forces import ExternalForce
from housefly.twin.movable import AWAY_POSE, MOVABLE_PREFIX, Movable
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.people.bodies import PERSON_PREFIX
from housefly.twin.people.script import PersonScript
from housefly.twin.scene_mjcf import scene_mjcf
from housefly.twin.simulated_body import CONTROL_PERIOD, BodyState, Wrench

_SUBSTEPS = 2
"""Physics steps per control period: 2.5 ms, enough for a soft hull to hit a wall at full speed."""
_GROUND_EFFECT = 0.02
_GROUND_EFFECT_HEIGHT = 0.15
"""Relative extra thrust on the floor, and the height [m] over which it fades."""

_VISITOR_BODY = "visitor"


class Physics:
    """One drone among the furniture; moves by whole control periods."""

    def __init__(
        self,
        site: Site,
        room: Room,
        people: tuple[PersonScript, ...] = (),
        movables: tuple[Movable, ...] = (),
    ) -> None:
        self.model: Any = mujoco.MjModel.from_xml_string(scene_mjcf(site, room, people, movables))
        self.model.opt.timestep = CONTROL_PERIOD / _SUBSTEPS
        self.data: Any = mujoco.MjData(self.model)
        self.drone_id: int = self.model.body(BODY).id
        joint = self.model.body(BODY).dofadr[0]
        self.model.dof_damping[joint : joint + 2] = site.drone.drag * DRONE_MASS
        place = self.model.joint(self.model.body(BODY).jntadr[0]).qposadr[0]
        self._qpos = self.data.qpos[place : place + 7]
        self._qvel = self.data.qvel[joint : joint + 6]
        self._qacc = self.data.qacc[joint : joint + 6]
        self._force = self.data.qfrc_applied[joint : joint + 6]
        self.floors = frozenset({int(self.model.geom("floor").id)})
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

    def state(self) -> BodyState:
        """Return the true state of the drone."""
        x, y, z, qw, qx, qy, qz = self._qpos.tolist()
        vx, vy, vz, p, q, r = self._qvel.tolist()
        ax, ay, az = self._qacc[:3].tolist()
        return BodyState((x, y, z), (qw, qx, qy, qz), (vx, vy, vz), (ax, ay, az), (p, q, r))

    def advance(
        self, wrench: Wrench, body: BodyState, external: ExternalForce | None = None
    ) -> None:
        """Hold thrust and torques, and what else pushes, for one control period."""
        lift = wrench.thrust * _near_floor(body.position[2])
        self._force[:] = (*rotate(body.orientation, (0.0, 0.0, lift)), *wrench[1:])
        if external is not None:
            self._force[:3] += external.force
            self._force[3:] += external.torque
        mujoco.mj_step(self.model, self.data, _SUBSTEPS)

    def load(self, payload: Payload | None) -> None:
        """Carry a load from now on, or none.

        Its mass weighs and resists at the drone's centre of mass, its distance adds to the moments
        of inertia; products of inertia are left out. The torque of its weight is an external one.
        """
        mass, offset = (payload.mass, payload.offset) if payload else (0.0, (0.0, 0.0, 0.0))
        square = running_sum(part * part for part in offset)
        self.model.body_mass[self.drone_id] = DRONE_MASS + mass
        self.model.body_inertia[self.drone_id] = [
            own + mass * (square - part * part) for own, part in zip(INERTIA, offset, strict=True)
        ]

    def contacts(self) -> int:
        """Return at how many points the drone touches something other than the floor."""
        data = self.data
        if data.ncon == 0:
            return 0
        pairs = data.contact.geom[: data.ncon]
        bodies = self.model.geom_bodyid[pairs]
        touching = (bodies == self.drone_id).any(axis=1)
        return sum(
            1 for a, b in pairs[touching].tolist() if a not in self.floors and b not in self.floors
        )

    def place(
        self,
        position: Vec3,
        orientation: Quaternion,
        velocity: Vec3 = (0.0, 0.0, 0.0),
        rate: Vec3 = (0.0, 0.0, 0.0),
    ) -> None:
        """Put the drone somewhere, by default at rest; world [m], [m/s], body [rad/s]."""
        self._qpos[:] = (*position, *orientation)
        self._qvel[:] = (*velocity, *rate)
        mujoco.mj_forward(self.model, self.data)

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


def _near_floor(height: float) -> float:
    """Return the gain of thrust at a height [m]: the ground effect that the loops leave."""
    return 1.0 + _GROUND_EFFECT * exp(-(height - STANDING_HEIGHT) / _GROUND_EFFECT_HEIGHT)
