"""What the drone's cameras see: MuJoCo's classic renderer at 30 pictures a second on a CPU.

Importing this module needs a working GL library; only the camera's child process does. Measured by
``benchmarks/camera.py``.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import atan, cos, radians, sin, tan
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from housefly.messages import Pose
from housefly.twin.camera.messages import PictureRequest
from housefly.twin.contracts import AWAY_Z, DroneCamera
from housefly.twin.people.bodies import PERSON_PREFIX
from housefly.twin.quadrotor.body import BODY, HULL_GROUP, VISUAL_GROUP

SUPERSAMPLING = 1.25
"""Pictures are rendered larger by this and averaged down; costs less than half of MSAA."""
_ROUNDNESS = {"numslices": 16, "numstacks": 10, "numquads": 2}
"""Tessellation of round shapes; MuJoCo's defaults take a third longer and look the same here."""
_OUT_OF_SIGHT = 5
"""A geom group that is never drawn."""


class CameraView:
    """The room seen from the drone, without the drone itself.

    Args:
        scene: MuJoCo model text.
        width, height: shown size [px]; pictures are ``SUPERSAMPLING`` larger.
    """

    def __init__(
        self,
        scene: str,
        width: int,
        height: int,
        supersampling: float = SUPERSAMPLING,
        samples: int = 0,
    ) -> None:
        model: Any = mujoco.MjModel.from_xml_string(scene)
        model.vis.quality.offsamples = samples
        for name, number in _ROUNDNESS.items():
            setattr(model.vis.quality, name, number)
        model.vis.global_.offwidth, model.vis.global_.offheight = (
            round(width * supersampling),
            round(height * supersampling),
        )
        self._model, self._data = model, mujoco.MjData(model)
        self._place = int(model.body(BODY).jntadr[0])
        self._visitor = _mocap_of(model, "visitor")
        self._visitor_at = (
            self._data.mocap_pos[self._visitor].copy() if self._visitor >= 0 else None
        )
        people = [n for n in range(model.nbody) if model.body(n).name.startswith(PERSON_PREFIX)]
        self._people = tuple(int(model.body_mocapid[n]) for n in people)
        self._geoms_of_people = tuple(np.flatnonzero(model.geom_bodyid == n) for n in people)
        self._frusta = {
            camera: _Frustum(model, camera.value, width / height) for camera in DroneCamera
        }
        self._renderer = mujoco.Renderer(
            model, round(height * supersampling), round(width * supersampling)
        )
        self._renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = 0
        self._options = mujoco.MjvOption()
        self._options.geomgroup[[VISUAL_GROUP, HULL_GROUP, _OUT_OF_SIGHT]] = 0
        self._options.sitegroup[:] = 0
        self._asked: _Key = ()
        self._shown: _Key = ()
        self._last = np.empty((0, 0, 3), dtype=np.uint8)

    def picture(self, request: PictureRequest) -> NDArray[np.uint8]:
        """Return the RGB picture, shape (rows, columns, 3); the last one again if nothing in sight
        moved.
        """
        asked = _key(request, request.people)
        if asked != self._asked:
            self._arrange(request)
            groups = self._frusta[request.camera].groups(self._data)
            shown = _key(request, self._people_in_sight(request, groups))
            if shown != self._shown:
                self._last = self._rendered(request.camera, groups)
            self._asked, self._shown = asked, shown
        return self._last

    def _arrange(self, request: PictureRequest) -> None:
        """Put drone, visitor and people where they are to be seen."""
        model, data = self._model, self._data
        start = model.jnt_qposadr[self._place]
        data.qpos[start : start + 7] = (*request.pose.position, *request.pose.orientation)
        if self._visitor_at is not None:
            data.mocap_pos[self._visitor] = self._visitor_at
            data.mocap_pos[self._visitor, 2] += 0.0 if request.visitor_present else AWAY_Z
        for number, person in zip(self._people, request.people, strict=False):
            data.mocap_pos[number], data.mocap_quat[number] = person.position, person.orientation
        mujoco.mj_kinematics(model, data)
        mujoco.mj_camlight(model, data)

    def _people_in_sight(
        self, request: PictureRequest, groups: NDArray[np.int32]
    ) -> tuple[Pose | None, ...]:
        """Return where the people are, None for those who are out of sight."""
        return tuple(
            person if (groups[geoms] != _OUT_OF_SIGHT).any() else None
            for geoms, person in zip(self._geoms_of_people, request.people, strict=False)
        )

    def _rendered(self, camera: DroneCamera, groups: NDArray[np.int32]) -> NDArray[np.uint8]:
        self._model.geom_group[:] = groups
        self._renderer.update_scene(self._data, camera.value, self._options)
        picture: NDArray[np.uint8] = self._renderer.render()
        return picture


class _Frustum:
    """Finds the geoms that a camera cannot see; MuJoCo would draw even those behind the camera."""

    def __init__(self, model: Any, camera: str, aspect: float) -> None:
        self._camera = int(model.camera(camera).id)
        self._groups = model.geom_group.copy()
        self._radii = np.where(
            model.geom_rbound > 0, model.geom_rbound, np.inf
        )  # planes have no bounding sphere
        self._up = radians(float(model.cam_fovy[self._camera])) / 2
        self._side = atan(tan(self._up) * aspect)

    def groups(self, data: Any) -> NDArray[np.int32]:
        """Return the geom groups with everything out of sight in a hidden one."""
        right, up, back = np.einsum(
            "nk,km->mn",
            data.geom_xpos - data.cam_xpos[self._camera],
            data.cam_xmat[self._camera].reshape(3, 3),
        )
        beside = np.abs(right) * cos(self._side) + back * sin(self._side) > self._radii
        above = np.abs(up) * cos(self._up) + back * sin(self._up) > self._radii
        groups: NDArray[np.int32] = np.where(beside | above, _OUT_OF_SIGHT, self._groups)
        return groups


_Key = tuple[object, ...]
"""What changes a picture, to a tenth of a millimetre and of a milliradian."""


def _key(request: PictureRequest, people: Iterable[Pose | None]) -> _Key:
    """Return what changes the picture that is asked for, with these people in it."""
    shown = (_rounded(pose) for pose in (request.pose, *people))
    return (request.camera, request.visitor_present, *shown)


def _rounded(pose: Pose | None) -> _Key:
    return () if pose is None else tuple(round(v, 4) for v in (*pose.position, *pose.orientation))


def _mocap_of(model: Any, body: str) -> int:
    found = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, body)
    return int(model.body_mocapid[found]) if found >= 0 else -1
