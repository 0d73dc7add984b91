"""The simulated scanning range finder: its beams are rays in the drone's own MuJoCo model.

It sees whatever its plane cuts: furniture, people, chairs, the drone. All beams of a scan are cast
at one moment; a real mirror takes three quarters of a turn.
"""

from __future__ import annotations

import numpy as np

from housefly.config.laser import LaserConfig
from housefly.config.twin import TwinConfig
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

    def scan(self) -> tuple[int, ...]:
        """Return one noisy distance per beam [mm]; the model's own code where nothing is hit."""
        parameters, beams = self._parameters, self._parameters.beams
        model, data = self._physics.model, self._physics.data
        far = parameters.longest / 1000.0
        mujoco.mj_multiRay(
            model, data, self._origin, self._rays, VISIBLE_GROUPS, 1, -1,
            self._geoms, self._reached, None, beams, far,
        )  # fmt: skip
        measured = 1000.0 * (self._reached + self._noise * self._random.standard_normal(beams))
        lost = self._random.random(beams) < self._dropout
        nothing = (
            lost
            | (self._reached < 0.0)
            | (measured < parameters.shortest)
            | (measured > parameters.longest)
        )
        return tuple(np.where(nothing, self._no_echo, np.rint(measured)).astype(int).tolist())


VISIBLE_GROUPS = np.array([1, 0, 1, 1, 0, 0], np.uint8)
"""Geom groups that stop a beam: all but lamps, painted shadows and markers."""
