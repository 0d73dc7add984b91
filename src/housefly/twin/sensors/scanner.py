"""The simulated scanning range finder: its beams are rays in the drone's own MuJoCo model.

It sees whatever its plane cuts: furniture, people, chairs, the drone. All beams of a scan are cast
at one moment; a real mirror takes three quarters of a turn.
"""

from __future__ import annotations

from math import asin, atan2, ceil, cos, floor, hypot, pi, sin, tau
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.config.laser import LaserConfig
from housefly.config.twin import TwinConfig
from housefly.numeric import FloatArray, compiled, elementwise
from housefly.twin.movable import AWAY_POSE
from housefly.twin.mujoco_engine import mujoco
from housefly.twin.physics import Physics
from housefly.wires.scip.parameters import MODELS, NO_ECHO

_SEED_KEY = 7919
"""Keeps the scanners' noise apart from all other noise of the same seed."""
_ROUNDING = 1e-6
"""Boxes around things are larger by this [m]: no beam is lost to rounding."""


class _Beams(NamedTuple):
    """The plane in which a scanner's beams lie.

    Attributes:
        x, y, z: where they begin [m].
        first: direction of the first [rad].
        step: from beam to beam [rad].
        longest: they reach no farther [m].
    """

    x: float
    y: float
    z: float
    first: float
    step: float
    longest: float


@compiled
def _half_length(turn: Any, axis: int, half: Any) -> float:
    """Return half the extent of a turned box along a world axis [m]."""
    own = abs(turn[3 * axis]) * half[3] + abs(turn[3 * axis + 1]) * half[4]
    return float(own + abs(turn[3 * axis + 2]) * half[5])


@compiled
def _mark(still: Any, beams: _Beams, dx: float, dy: float, reach: float, near: Any) -> None:
    """Mark the beams that may meet an upright cylinder before they meet the building.

    Args:
        still: how far each beam reaches in the building [m].
        beams: their plane.
        dx: from the scanner to the cylinder's middle along x [m].
        dy: the same along y [m].
        reach: its radius [m].
        near: written.
    """
    away = hypot(dx, dy)
    if away - reach > beams.longest:
        return
    half = asin(reach / away) if reach < away else pi
    middle = (atan2(dy, dx) - beams.first) % tau
    for turn in range(-1, 2):
        low = (middle + turn * tau - half) / beams.step
        high = (middle + turn * tau + half) / beams.step
        for beam in range(max(0, floor(low)), min(near.size, max(0, ceil(high) + 1))):
            if still[beam] > away - reach:
                near[beam] = True


@compiled
def _mark_beams(
    geoms: Any, boxes: Any, places: Any, turns: Any, still: Any, beams: _Beams, near: Any
) -> None:
    """Mark the beams that may meet something that can move: an upright cylinder around each geom.

    Args:
        geoms: ids of what can move.
        boxes: middle and half size of every geom in its own frame [m], shape (n, 6).
        places: of every geom [m], shape (n, 3).
        turns: rotation of every geom, row by row, shape (n, 9).
        still: how far each beam reaches in the building [m].
        beams: their plane.
        near: written.
    """
    for n in range(geoms.size):
        geom = geoms[n]
        box, turn, place = boxes[geom], turns[geom], places[geom]
        up = turn[6] * box[0] + turn[7] * box[1] + turn[8] * box[2]
        if abs(place[2] + up - beams.z) > _half_length(turn, 2, box) + _ROUNDING:
            continue
        dx = place[0] - beams.x + turn[0] * box[0] + turn[1] * box[1] + turn[2] * box[2]
        dy = place[1] - beams.y + turn[3] * box[0] + turn[4] * box[1] + turn[5] * box[2]
        reach = hypot(_half_length(turn, 0, box), _half_length(turn, 1, box)) + _ROUNDING
        _mark(still, beams, dx, dy, reach, near)


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
        self._longest = self._parameters.longest / 1000.0
        beams = self._parameters.beams
        numbers = np.arange(beams, dtype=np.float64)
        angles = config.yaw + self._parameters.first_angle + numbers * self._parameters.step
        self._rays = np.stack(
            [elementwise(cos, angles), elementwise(sin, angles), np.zeros(beams)], axis=1
        )
        self._beams = _Beams(
            config.x, config.y, config.z, float(angles[0]), self._parameters.step, self._longest
        )
        self._moving = _moving_geoms(physics.model)
        self._boxes = physics.model.geom_aabb.copy()
        every = np.arange(beams)
        self._still = self._cast(_data_without_movables(physics), every, with_still=True)

    def scan(self) -> tuple[int, ...]:
        """Return one noisy distance per beam [mm]; the model's own code where nothing is hit."""
        parameters, beams = self._parameters, self._parameters.beams
        # The building never changes, and what moves is met by few beams.
        near, reached = self._beams_to_what_moves(), self._still
        if len(near):
            reached = reached.copy()
            moving = self._cast(self._physics.data, near, with_still=False)
            reached[near] = np.minimum(reached[near], moving)
        measured = 1000.0 * (reached + self._noise * self._random.standard_normal(beams))
        lost = self._random.random(beams) < self._dropout
        nothing = lost | (measured < parameters.shortest) | (measured > parameters.longest)
        return tuple(np.where(nothing, self._no_echo, np.rint(measured)).astype(int).tolist())

    def _beams_to_what_moves(self) -> NDArray[np.intp]:
        """Return which beams may meet something that can move before they meet the building."""
        data, near = self._physics.data, np.zeros(self._parameters.beams, np.bool_)
        _mark_beams(
            self._moving, self._boxes, data.geom_xpos, data.geom_xmat, self._still, self._beams,
            near,
        )  # fmt: skip
        return np.flatnonzero(near)

    def _cast(self, data: Any, beams: NDArray[np.intp], *, with_still: bool) -> FloatArray:
        """Return the distance that some beams reach [m], infinite where nothing is hit."""
        rays = self._rays[beams]
        geoms, reached = np.zeros(len(rays), np.int32), np.zeros(len(rays))
        mujoco.mj_multiRay(
            self._physics.model, data, self._origin, rays.ravel(), VISIBLE_GROUPS, int(with_still),
            -1, geoms, reached, None, len(rays), self._longest,
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
    for place in physics.model.jnt_qposadr.tolist():
        data.qpos[place : place + 3] = AWAY_POSE.position
    mujoco.mj_kinematics(physics.model, data)
    return data


VISIBLE_GROUPS = np.array([1, 0, 1, 1, 0, 0], np.uint8)
"""Geom groups that stop a beam: all but lamps, painted shadows and markers."""
