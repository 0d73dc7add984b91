"""Lines of sight against walked rays, and against MuJoCo in the whole of B-sen."""

from __future__ import annotations

from math import cos, pi, sin

import mujoco
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import Vec3
from housefly.room.bsen import bsen
from housefly.room.mjcf import room_to_mjcf
from housefly.room.model import Shape, Solid
from housefly.room.sight import hiding_rows, in_sight, upright_row

_length = st.floats(-2.0, 2.0)
_points = st.tuples(_length, _length, _length)
_sizes = st.floats(0.1, 2.0)
_solids = st.builds(
    lambda shape, at, a, b, c, yaw: Solid(
        "s", "s", shape, at, (a, a if shape is Shape.CYLINDER else b, c), yaw
    ),
    st.sampled_from(Shape),
    _points,
    _sizes,
    _sizes,
    _sizes,
    st.floats(-pi, pi),
)


def depth_in(solid: Solid, point: Vec3) -> float:
    """Return how deep a point lies in a solid, negative outside [m]."""
    x, y, z = (a - b for a, b in zip(point, solid.position, strict=True))
    u, v = x * cos(solid.yaw) + y * sin(solid.yaw), y * cos(solid.yaw) - x * sin(solid.yaw)
    half = [extent / 2 for extent in solid.size]
    aside = (
        half[0] - float(np.hypot(u, v))
        if solid.shape is Shape.CYLINDER
        else min(half[0] - abs(u), half[1] - abs(v))
    )
    return min(aside, half[2] - abs(z))


@given(_solids, _points, _points)
def test_a_line_is_hidden_exactly_where_walking_along_it_meets_the_solid(
    solid: Solid, eye: Vec3, target: Vec3
) -> None:
    a, b = np.array(eye), np.array(target)
    length = float(np.linalg.norm(b - a))
    if length < 0.1:
        return
    seen = bool(in_sight(hiding_rows([solid]), np.array([eye]), np.array([target]), 1e-9)[0, 0])
    walk = [tuple((a + (b - a) * n / 400).tolist()) for n in range(401)]
    deepest = max(depth_in(solid, point) for point in walk)
    if deepest > 0.005:
        assert not seen
    if deepest < -0.02:
        assert seen


def test_glass_and_carpets_hide_nothing_but_glass_blinds_what_flashes() -> None:
    pane = Solid("pane", "w", Shape.BOX, (1.0, 0.0, 0.0), (0.1, 2.0, 2.0), colour=(1, 1, 1, 0.3))
    rug = Solid("rug", "w", Shape.BOX, (1.0, 0.0, 0.0), (0.1, 2.0, 2.0), collides=False)
    eye, target = np.array([[0.0, 0.0, 0.0]]), np.array([[2.0, 0.0, 0.0]])
    assert in_sight(hiding_rows([pane, rug]), eye, target)[0, 0]
    assert not in_sight(hiding_rows([pane, rug], glass=True), eye, target)[0, 0]


def test_what_a_line_meets_at_its_very_end_does_not_hide_the_end() -> None:
    row = upright_row(1.0, 0.0, 0.25, 0.0, 1.7)
    eye, target = np.array([[-1.0, 0.0, 1.1]]), np.array([[0.76, 0.0, 1.1]])
    assert in_sight(row, eye, target)[0, 0]
    assert not in_sight(row, eye, np.array([[1.0, 0.0, 1.1]]))[0, 0]


@pytest.mark.parametrize("seed", [1, 2])
def test_in_b_sen_every_line_agrees_with_mujoco(seed: int) -> None:
    room = bsen()
    model = mujoco.MjModel.from_xml_string(room_to_mjcf(room))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    names = {solid.name for solid in room.solids if solid.collides}
    hiding = {n for n in range(model.ngeom) if model.geom(n).name in names}
    for n in range(model.ngeom):  # only solids of the room that collide block here
        model.geom_group[n] = 0 if n in hiding else 5
    rng = np.random.default_rng(seed)
    eyes = np.column_stack([rng.uniform(0.3, 14.6, 150), rng.uniform(0.7, 6.0, 150)])
    eyes = np.column_stack([eyes, rng.uniform(0.9, 1.6, 150)])
    ends = np.column_stack([rng.uniform(0.3, 14.6, (8, 1)), rng.uniform(0.7, 6.0, (8, 1))])
    ends = np.column_stack([ends, rng.uniform(0.1, 1.9, 8)])
    seen = in_sight(hiding_rows(room.solids, glass=True), eyes, ends, 0.0)
    geom, groups = np.zeros(1, np.int32), np.array([1, 0, 0, 0, 0, 0], np.uint8)
    differing = 0
    for i, eye in enumerate(eyes):
        for j, end in enumerate(ends):
            share = mujoco.mj_ray(model, data, eye, end - eye, groups, 1, -1, geom)
            differing += bool(seen[i, j]) is not bool(share < 0.0 or share >= 1.0)
    assert differing == 0
