"""The MuJoCo model of a room loads, agrees with the grid, and its picture shows the visitor."""

from __future__ import annotations

import subprocess
import sys
from math import cos, sin

import mujoco
import numpy as np
import pytest

from housefly.config.site import Site
from housefly.room.bsen import bsen
from housefly.room.grid import Cell, build_grid
from housefly.room.mjcf import room_to_mjcf
from housefly.room.model import Shape

PROBE = (
    '<body name="probe" mocap="true"><geom name="probe" type="cylinder" size="0.001 0.25"'
    ' contype="0" conaffinity="0"/></body>'
)


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(room_to_mjcf(bsen(), bodies=PROBE))


def test_every_solid_is_a_geom_of_its_place_size_and_turn(model: mujoco.MjModel) -> None:
    for solid in bsen().solids:
        geom = model.geom(solid.name)
        half = [extent / 2 for extent in solid.size]
        size = half if solid.shape is Shape.BOX else [half[0], half[2]]
        assert geom.pos == pytest.approx(solid.position, abs=1e-5)
        assert geom.size[: len(size)] == pytest.approx(size, abs=1e-5)
        assert abs(
            geom.quat @ np.array([cos(solid.yaw / 2), 0, 0, sin(solid.yaw / 2)])
        ) == pytest.approx(1.0, abs=1e-6)
        assert bool(geom.contype[0]) == solid.collides


def test_the_visitor_is_a_mocap_body_with_six_markers(model: mujoco.MjModel) -> None:
    body = model.body("visitor")
    assert model.body_mocapid[body.id] >= 0
    assert [model.site(f"visitor_marker_{n}").bodyid[0] for n in range(6)] == [body.id] * 6
    x, y = bsen().visitor or (0.0, 0.0)
    assert body.pos == pytest.approx((x, y, 0.0))


def test_clearance_agrees_with_the_distances_that_mujoco_measures(model: mujoco.MjModel) -> None:
    site = Site()
    grid = build_grid(bsen(), site)
    data = mujoco.MjData(model)
    band = [
        s for s in bsen().solids if s.collides and abs(s.position[2] - 1.1) < s.size[2] / 2 + 0.25
    ]
    geoms = [model.geom(solid.name).id for solid in band]
    probe = model.geom("probe").id
    random = np.random.default_rng(5)
    inside = np.argwhere((grid.cells != Cell.OUTSIDE) & (grid.clearance > 0.02))
    for i, j in random.choice(inside, 60, replace=False):
        x, y = grid.centre_of((int(i), int(j)))
        data.mocap_pos[model.body("probe").mocapid[0]] = (x, y, site.map.flight_height)
        mujoco.mj_kinematics(model, data)
        measured = min(
            mujoco.mj_geomDistance(model, data, probe, geom, 20.0, None) for geom in geoms
        )
        assert grid.clearance[i, j] == pytest.approx(measured + 0.001, abs=0.01)


def test_names_with_markup_characters_are_escaped() -> None:
    from dataclasses import replace

    room = bsen()
    odd = replace(room, name='<"&', solids=(replace(room.solids[0], name='a<b"c&d'),))
    loaded = mujoco.MjModel.from_xml_string(room_to_mjcf(odd))
    assert loaded.geom('a<b"c&d').size[0] > 0


RENDER = """
import mujoco, numpy, sys
from housefly.room.bsen import bsen
from housefly.room.mjcf import room_to_mjcf
eye = '<camera name="eye" pos="2.55 4.25 1.1" xyaxes="0 1 0 0 0 1" fovy="54"/>'
model = mujoco.MjModel.from_xml_string(room_to_mjcf(bsen(), bodies=eye))
data = mujoco.MjData(model)
renderer = mujoco.Renderer(model, 180, 320)
pictures = []
for height in (0.0, -30.0):
    data.mocap_pos[model.body("visitor").mocapid[0], 2] = height
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, "eye")
    pictures.append(renderer.render().astype(float))
numpy.save(sys.argv[1], numpy.array(pictures))
"""


def test_the_picture_from_the_entrance_shows_the_visitor(
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    target = tmp_path_factory.mktemp("picture") / "door.npy"
    for renderer in ("egl", "osmesa"):
        done = subprocess.run(
            [sys.executable, "-c", RENDER, str(target)],
            env={"MUJOCO_GL": renderer, "PATH": "/usr/bin:/bin"},
            capture_output=True,
            timeout=90,
        )
        if done.returncode == 0:
            break
    else:
        pytest.skip("no OpenGL renderer (EGL or OSMesa) works on this machine")
    with_visitor, without = np.load(target)
    changed = np.abs(with_visitor - without).max(axis=2) > 30
    columns = np.flatnonzero(changed.any(axis=0))
    assert 0.05 < changed.mean() < 0.5, "the visitor fills a good part of the picture"
    assert 100 < columns.mean() < 220, "and stands near its middle"
    assert without.std() > 25, "the door behind is no blank wall"
