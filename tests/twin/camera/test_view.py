"""The room from the drone's camera; in a process of its own, since a GL library may end it."""

from __future__ import annotations

import subprocess
import sys

import pytest

_DRAWS = """
import mujoco

mujoco.Renderer(mujoco.MjModel.from_xml_string("<mujoco/>"), 8, 8).render()
"""
_LOOKS = """
from dataclasses import replace
from math import pi

import numpy as np

from housefly.config.site import Site
from housefly.geometry import quaternion_from_euler
from housefly.messages import Pose
from housefly.room.files import load_room
from housefly.twin.camera.messages import PictureRequest
from housefly.twin.camera.view import CameraView
from housefly.twin.contracts import DroneCamera
from housefly.twin.people import scene_from_tree
from housefly.twin.scene_mjcf import scene_mjcf

person = scene_from_tree(
    {"name": "t", "people": [{"name": "ann", "start": [3.0, 4.2], "steps": []}]}
).script.people[0]
SCENE = scene_mjcf(Site(), load_room("bsen"), (person,))
PLACE = load_room("bsen").place("entrance").viewpoint


def request(away: float, yaw: float) -> PictureRequest:
    pose = Pose((*PLACE, 1.1), quaternion_from_euler(0.0, 0.0, yaw))
    person = Pose((PLACE[0] + away, PLACE[1], 0.0), (1.0, 0.0, 0.0, 0.0))
    return PictureRequest(pose, False, DroneCamera.FRONT, 0.0, (person,))


def anew(asked: PictureRequest) -> np.ndarray:
    return CameraView(SCENE, 320, 180).picture(asked).copy()


view = CameraView(SCENE, 320, 180)
before = view.picture(request(1.0, 0.0))
assert view.picture(request(1.0, 0.0)) is before
moved = view.picture(request(1.2, 0.0))
assert not np.array_equal(moved, before)
assert np.array_equal(moved, anew(request(1.2, 0.0)))
behind = view.picture(request(1.2, pi))
assert view.picture(request(1.5, pi)) is behind
assert np.array_equal(behind, anew(request(1.5, pi)))
assert view.picture(request(-1.5, pi)) is not behind
assert np.array_equal(view.picture(request(-1.5, pi)), anew(request(-1.5, pi)))
"""


@pytest.mark.parametrize("library", ["egl", "osmesa"])
def test_whoever_moves_out_of_sight_changes_no_picture_and_in_sight_each(
    library: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MUJOCO_GL", library)
    if library == "egl" and _run(_DRAWS).returncode:  # the other is installed by the set-up
        pytest.skip(f"{library} does not draw here")
    looked = _run(_LOOKS)
    assert looked.returncode == 0, looked.stderr


def _run(program: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
