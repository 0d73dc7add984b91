"""The rigid body of one simulated drone: its state, and what pushes it.

The free joint's forces act in the world at the origin, its torques about the body axes; horizontal
drag is the joint's own damping, so that MuJoCo integrates it implicitly.
"""

from __future__ import annotations

from math import exp
from typing import Any

from housefly.config.drone import DroneConfig
from housefly.geometry import Quaternion, Vec3, rotate
from housefly.numeric import running_sum
from housefly.twin.disturbance import Payload
from housefly.twin.drone_mechanics import mechanics_of
from housefly.twin.external_forces import ExternalForce
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.quadrotor.body import drone_markers
from housefly.twin.simulated_body import BodyState, Wrench

_GROUND_EFFECT = 0.02
_GROUND_EFFECT_HEIGHT = 0.15
"""Relative extra thrust on the floor, and the height [m] over which it fades."""


class DroneBody:
    """One drone among the furniture.

    Args:
        model, data: MuJoCo's, of the whole room.
        name: of its body in the model.
        config: gives its drag, and its airframe.
        floors: geom ids of the floor.

    Attributes:
        model, data, name, floors: as given.
        number: id of its body.
        mechanics: mass, moments, motors.
        markers: where its reflective markers sit [m].
        airframe: of its model.
        before: its state at the beginning of the last control period.
    """

    def __init__(
        self, model: Any, data: Any, name: str, config: DroneConfig, floors: frozenset[int]
    ) -> None:
        self.model, self.data, self.name, self.floors = model, data, name, floors
        self.number: int = model.body(name).id
        self.mechanics = mechanics_of(config.airframe)
        self.markers = drone_markers(config.airframe)
        self.airframe = config.airframe
        joint = model.body(name).dofadr[0]
        model.dof_damping[joint : joint + 2] = config.drag * self.mechanics.mass
        place = model.joint(model.body(name).jntadr[0]).qposadr[0]
        self._qpos = data.qpos[place : place + 7]
        self._qvel = data.qvel[joint : joint + 6]
        self._qacc = data.qacc[joint : joint + 6]
        self._force = data.qfrc_applied[joint : joint + 6]
        self.before = self.state()

    def state(self) -> BodyState:
        """Return the true state."""
        x, y, z, qw, qx, qy, qz = self._qpos.tolist()
        vx, vy, vz, p, q, r = self._qvel.tolist()
        ax, ay, az = self._qacc[:3].tolist()
        return BodyState((x, y, z), (qw, qx, qy, qz), (vx, vy, vz), (ax, ay, az), (p, q, r))

    def push(self, wrench: Wrench, state: BodyState, external: ExternalForce | None = None) -> None:
        """Set thrust and torques, and what else pushes, for the next control period."""
        self.before = state
        self.lift(wrench, state, external)

    def lift(self, wrench: Wrench, state: BodyState, external: ExternalForce | None = None) -> None:
        """Set the same within a control period."""
        lift = wrench.thrust * _near_floor(state.position[2] - self.mechanics.standing_height)
        self._force[:] = (*rotate(state.orientation, (0.0, 0.0, lift)), *wrench[1:])
        if external is not None:
            self._force[:3] += external.force
            self._force[3:] += external.torque

    def load(self, payload: Payload | None) -> None:
        """Carry a load from now on, or none.

        Its mass weighs and resists at the drone's centre of mass, its distance adds to the moments
        of inertia; products of inertia are left out. The torque of its weight is an external one.
        """
        mass, offset = (payload.mass, payload.offset) if payload else (0.0, (0.0, 0.0, 0.0))
        square = running_sum(part * part for part in offset)
        self.model.body_mass[self.number] = self.mechanics.mass + mass
        self.model.body_inertia[self.number] = [
            own + mass * (square - part * part)
            for own, part in zip(self.mechanics.inertia, offset, strict=True)
        ]

    def contacts(self) -> int:
        """Return at how many points it touches something other than the floor."""
        data = self.data
        if data.ncon == 0:
            return 0
        pairs = data.contact.geom[: data.ncon]
        bodies = self.model.geom_bodyid[pairs]
        touching = (bodies == self.number).any(axis=1)
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
        """Put it somewhere, by default at rest; world [m], [m/s], body [rad/s]."""
        self._qpos[:] = (*position, *orientation)
        self._qvel[:] = (*velocity, *rate)
        mujoco.mj_forward(self.model, self.data)


def _near_floor(height: float) -> float:
    """Return the gain of thrust above standing [m]: the ground effect that the loops leave."""
    return 1.0 + _GROUND_EFFECT * exp(-height / _GROUND_EFFECT_HEIGHT)
