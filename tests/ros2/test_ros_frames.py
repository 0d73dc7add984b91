"""Frames on /tf and /tf_static, with the real type of tf2_msgs.

It is in no package of PyPI: it comes with ROS, or by ``scripts/ros_types.sh``.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from ros_stage import ros_stage

pytest.importorskip("rclpy")
pytest.importorskip("tf2_msgs.msg")

pytestmark = [pytest.mark.wire, pytest.mark.slow]
LASER = {"name": "hall", "x": 1.0, "y": 2.0, "yaw": 0.5}


def test_who_comes_late_gets_every_frame_and_the_drone_moves_in_the_map(tmp_path: Path) -> None:
    with ros_stage(tmp_path, 100 + os.getpid() % 90, lasers=[LASER]) as stage:
        moving, still = stage.client.heard("/tf"), stage.client.heard("/tf_static", latched=True)
        assert stage.client.spin(lambda: len(moving) > 5 and still)
    (drone,) = moving[-1].transforms
    assert (drone.header.frame_id, drone.child_frame_id) == ("map", "drone/base_link")
    assert drone.transform.translation.x == 3.0
    found = {one.child_frame_id: one.header.frame_id for one in still[0].transforms}
    assert (
        found.items()
        >= {
            "lasers/hall": "map",
            "drone/pad": "map",
            "drone/camera_optical_frame": "drone/base_link",
        }.items()
    )
