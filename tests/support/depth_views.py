"""What the drone's front camera sees, and how far away: rendered in a process of its own.

``python depth_views.py FILE`` reads poses as JSON from its input (x, y, z, w, x, y, z each) and
writes colours and depths [m].
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from housefly.messages import Pose

WIDTH, HEIGHT = 640, 360


def depth_views(poses: Sequence[Pose]) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
    """Return colours (n, height, width, 3) and depths along the optical axis (n, height, width).

    Skips the test where nothing can be rendered.
    """
    text = json.dumps([(*pose.position, *pose.orientation) for pose in poses])
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "views.npz"
        for backend in ("egl", "osmesa"):
            run = subprocess.run(
                [sys.executable, __file__, str(file)],
                input=text,
                text=True,
                capture_output=True,
                env={**os.environ, "MUJOCO_GL": backend, "LP_NUM_THREADS": "0"},
                check=False,
            )
            if run.returncode == 0:
                views = np.load(file)
                return views["colours"], views["depths"]
    pytest.skip(f"nothing renders here: {run.stderr[-300:]}")


def _render(file: Path, rows: list[list[float]]) -> None:
    import mujoco

    from housefly.config.site import Site
    from housefly.room.files import load_room
    from housefly.twin.quadrotor.body import BODY, HULL_GROUP, VISUAL_GROUP
    from housefly.twin.scene_mjcf import scene_mjcf

    model = mujoco.MjModel.from_xml_string(scene_mjcf(Site(), load_room("bsen")))
    model.vis.global_.offwidth, model.vis.global_.offheight = WIDTH, HEIGHT
    data = mujoco.MjData(model)
    options = mujoco.MjvOption()
    options.geomgroup[[VISUAL_GROUP, HULL_GROUP]] = 0
    options.sitegroup[:] = 0
    renderer = mujoco.Renderer(model, HEIGHT, WIDTH)
    start = model.jnt_qposadr[int(model.body(BODY).jntadr[0])]
    colours, depths = [], []
    for row in rows:
        data.qpos[start : start + 7] = row
        mujoco.mj_kinematics(model, data)
        mujoco.mj_camlight(model, data)
        renderer.update_scene(data, "front", options)
        colours.append(renderer.render())
        renderer.enable_depth_rendering()
        depths.append(renderer.render())
        renderer.disable_depth_rendering()
    np.savez(file, colours=np.array(colours), depths=np.array(depths))


if __name__ == "__main__":
    _render(Path(sys.argv[1]), json.load(sys.stdin))
