"""The simulated scanning range finder: its beams are rays in the drone's own MuJoCo model.

It sees whatever its plane cuts: furniture, people, chairs, the drone. All beams of a scan are cast
at one moment; a real mirror takes three quarters of a turn.
"""

from __future__ import annotations

from math import asin, atan2, ceil, floor, pi, tau
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.config.laser import LaserConfig
from housefly.config.twin import TwinConfig
from housefly.numeric import FloatArray
from housefly.twin.movable import AWAY_POSE
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.physics import Physics
from housefly.wires.scip.parameters import MODELS, NO_ECHO

_SEED_KEY = 7919
"""Keeps the scanners' noise apart from all other noise of the same seed."""


class Scanner:
    """One scanner of the site.

    Args:
        config: where it is, and which model.
        twin: noise, dropouts, seed.
        number: its place in the site's list.
        physics: what it looks at.
    """

    def __init__(
        self, config: LaserConfig, twin: TwinConfig, number: int, physics: Physics
    ) -> None:
        self._parameters, self._no_echo = MODELS[config.model], NO_ECHO[config.model]
        self._noise, self._dropout = twin.laser_noise, twin.laser_dropout
        self._random = np.random.default_rng(
            np.random.SeedSequence(twin.seed, spawn_key=(_SEED_KEY, number))
        )
        self._physics = physics
        self._origin = np.array([config.x, config.y, config.z])
        beams = self._parameters.beams
        angles = (
            config.yaw + self._parameters.first_angle + np.arange(beams) * self._parameters.step
        )
        self._rays = np.stack([np.cos(angles), np.sin(angles), np.zeros(beams)], axis=1)
        self._first = float(angles[0])
        self._moving = _moving_geoms(physics.model)
        self._radii = physics.model.geom_rbound[self._moving]
        every = np.ones(beams, np.bool_)
        self._still = self._cast(_data_without_movables(physics), every, with_still=True)

    def scan(self) -> tuple[int, ...]:
        """Return one noisy distance per beam [mm]; the model's own code where nothing is hit."""
        parameters, beams = self._parameters, self._parameters.beams
        # The building never changes, and what moves is met by few beams.
        near, reached = self._beams_to_what_moves(), self._still
        if near.any():
            reached = reached.copy()
            moving = self._cast(self._physics.data, near, with_still=False)
            reached[near] = np.minimum(reached[near], moving)
        measured = 1000.0 * (reached + self._noise * self._random.standard_normal(beams))
        lost = self._random.random(beams) < self._dropout
        nothing = lost | (measured < parameters.shortest) | (measured > parameters.longest)
        return tuple(np.where(nothing, self._no_echo, np.rint(measured)).astype(int).tolist())

    def _beams_to_what_moves(self) -> NDArray[np.bool_]:
        """Return which beams may meet something that can move: a ball around each geom of it."""
        offsets = self._physics.data.geom_xpos[self._moving] - self._origin
        away, step = np.hypot(offsets[:, 0], offsets[:, 1]), self._parameters.step
        is_near = np.abs(offsets[:, 2]) <= self._radii
        is_near &= away - self._radii <= self._parameters.longest / 1000.0
        near = np.zeros(self._parameters.beams, np.bool_)
        for (dx, dy, _), gap, radius in zip(
            offsets[is_near].tolist(), away[is_near].tolist(), self._radii[is_near].tolist(),
            strict=True,
        ):  # fmt: skip
            half = asin(radius / gap) if radius < gap else pi
            middle = (atan2(dy, dx) - self._first) % tau
            for bearing in (middle - tau, middle, middle + tau):
                low, high = (bearing - half) / step, (bearing + half) / step
                near[max(0, floor(low)) : max(0, ceil(high) + 1)] = True
        return near

    def _cast(self, data: Any, beams: NDArray[np.bool_], *, with_still: bool) -> FloatArray:
        """Return the distance that some beams reach [m], infinite where nothing is hit."""
        rays = self._rays[beams]
        geoms, reached = np.zeros(len(rays), np.int32), np.zeros(len(rays))
        mujoco.mj_multiRay(
            self._physics.model, data, self._origin, rays.ravel(), VISIBLE_GROUPS, int(with_still),
            -1, geoms, reached, None, len(rays), self._parameters.longest / 1000.0,
        )  # fmt: skip
        return np.where(reached < 0.0, np.inf, reached)


def _moving_geoms(model: Any) -> NDArray[np.intp]:
    """Return the ids of the geoms that can move and stop a beam."""
    groups = np.clip(model.geom_group, 0, len(VISIBLE_GROUPS) - 1)
    can_move = model.body_weldid[model.geom_bodyid] != 0
    return np.flatnonzero(can_move & (VISIBLE_GROUPS[groups] > 0))


def _data_without_movables(physics: Physics) -> Any:
    """Return the state of a room in which all that can move is far away."""
    data = mujoco.MjData(physics.model)
    data.mocap_pos[:] = AWAY_POSE.position
    data.qpos[:3] = AWAY_POSE.position
    mujoco.mj_kinematics(physics.model, data)
    return data


VISIBLE_GROUPS = np.array([1, 0, 1, 1, 0, 0], np.uint8)
"""Geom groups that stop a beam: all but lamps, painted shadows and markers."""
