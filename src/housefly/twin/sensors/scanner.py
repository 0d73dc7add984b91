"""The simulated scanning range finder: its beams are rays in the drone's own MuJoCo model.

It sees whatever its plane cuts: furniture, people, chairs, the drone. All beams of a scan are cast
at one moment; a real mirror takes three quarters of a turn.
"""

from __future__ import annotations

from typing import Any

import numpy as np

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
        self._rays = np.stack([np.cos(angles), np.sin(angles), np.zeros(beams)], axis=1).ravel()
        self._geoms = np.zeros(beams, np.int32)
        self._reached = np.zeros(beams)
        self._still = self._cast(_data_without_movables(physics), with_still=True)

    def scan(self) -> tuple[int, ...]:
        """Return one noisy distance per beam [mm]; the model's own code where nothing is hit."""
        parameters, beams = self._parameters, self._parameters.beams
        # The building hides four fifths of the work: its distances never change.
        reached = np.minimum(self._still, self._cast(self._physics.data, with_still=False))
        measured = 1000.0 * (reached + self._noise * self._random.standard_normal(beams))
        lost = self._random.random(beams) < self._dropout
        nothing = lost | (measured < parameters.shortest) | (measured > parameters.longest)
        return tuple(np.where(nothing, self._no_echo, np.rint(measured)).astype(int).tolist())

    def _cast(self, data: Any, *, with_still: bool) -> FloatArray:
        """Return the distance that each beam reaches [m], infinite where nothing is hit."""
        beams = self._parameters.beams
        mujoco.mj_multiRay(
            self._physics.model, data, self._origin, self._rays, VISIBLE_GROUPS, int(with_still),
            -1, self._geoms, self._reached, None, beams, self._parameters.longest / 1000.0,
        )  # fmt: skip
        return np.where(self._reached < 0.0, np.inf, self._reached)


def _data_without_movables(physics: Physics) -> Any:
    """Return the state of a room in which all that can move is far away."""
    data = mujoco.MjData(physics.model)
    data.mocap_pos[:] = AWAY_POSE.position
    data.qpos[:3] = AWAY_POSE.position
    mujoco.mj_kinematics(physics.model, data)
    return data


VISIBLE_GROUPS = np.array([1, 0, 1, 1, 0, 0], np.uint8)
"""Geom groups that stop a beam: all but lamps, painted shadows and markers."""
