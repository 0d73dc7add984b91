"""Frames that stand still: where they are, and which way their axes point."""

from __future__ import annotations

from math import cos, sin

import numpy as np
import pytest

from housefly.bus.interfaces import type_store
from housefly.geometry import rotate
from housefly.ros2.static_frames import StaticFrame, static_frames, static_transforms
from housefly.sites.loaded_site import load_site

AHEAD, RIGHT, DOWN = (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)
"""Axes of an optical frame."""
LASER = {"name": "hall-1", "x": 1.0, "y": 2.0, "z": 0.4, "yaw": 0.5}
DEPTH = {"name": "eye", "x": 3.0, "y": 4.0, "z": 2.0, "yaw": 0.7, "pitch": 0.4}


def frames(**changes: object) -> dict[str, StaticFrame]:
    loaded = load_site("bsen", lasers=[LASER], depth_cameras=[DEPTH], **changes)
    return {frame.child: frame for frame in static_frames(loaded)}


def test_a_scanner_looks_along_its_x() -> None:
    laser = frames()["lasers/hall_1"]
    assert (laser.parent, laser.position) == ("map", (1.0, 2.0, 0.4))
    assert rotate(laser.orientation, (1.0, 0.0, 0.0)) == pytest.approx((cos(0.5), sin(0.5), 0.0))


def test_a_depth_camera_looks_down_along_its_z_with_x_to_the_right() -> None:
    camera = frames()["depth_cameras/eye_optical_frame"]
    looks = (cos(0.7) * cos(0.4), sin(0.7) * cos(0.4), -sin(0.4))
    assert rotate(camera.orientation, AHEAD) == pytest.approx(looks)
    assert rotate(camera.orientation, RIGHT) == pytest.approx((sin(0.7), -cos(0.7), 0.0))
    assert rotate(camera.orientation, DOWN)[2] < -0.9


def test_a_real_depth_camera_tells_its_place_itself() -> None:
    assert "depth_cameras/eye_optical_frame" not in frames(twin__enabled=False)


def test_the_drones_camera_is_before_its_body_and_looks_forward() -> None:
    camera = frames()["drone/camera_optical_frame"]
    assert camera.parent == "drone/base_link" and camera.position[0] > 0.0
    assert rotate(camera.orientation, AHEAD) == pytest.approx((1.0, 0.0, 0.0))
    assert rotate(camera.orientation, RIGHT) == pytest.approx((0.0, -1.0, 0.0))


def test_each_drone_that_flies_has_a_pad_and_its_own_frames() -> None:
    drones = [
        {"name": "a", "model": "ardrone", "pad": [2.0, 2.0, 0.5]},
        {"name": "b", "model": "crazyflie", "address": "127.0.0.2", "pad": [5.0, 3.0, 0.0]},
    ]
    models = {"ardrone": {"kind": "ardrone"}, "crazyflie": {"kind": "crazyflie"}}
    found = frames(drones=drones, models=models)
    assert found["a/pad"].position == (2.0, 2.0, 0.0) and found["b/pad"].position[0] == 5.0
    assert "a/camera_optical_frame" in found and "b/camera_optical_frame" not in found


def test_tracking_cameras_look_down_into_the_room() -> None:
    found = [frame for name, frame in frames().items() if name.startswith("tracking_cameras/")]
    assert len(found) == len(load_site("bsen").room.cameras) > 0
    for camera in found:
        assert rotate(camera.orientation, AHEAD)[2] < 0.0


def test_all_are_in_one_message_and_each_has_one_parent() -> None:
    found = tuple(frames().values())
    told = static_transforms(5.0, found)
    store = type_store()
    data = store.serialize_cdr(told, "tf2_msgs/msg/TFMessage")
    read = store.deserialize_cdr(data, "tf2_msgs/msg/TFMessage").transforms  # type: ignore[attr-defined]
    assert [one.child_frame_id for one in read] == [frame.child for frame in found]
    assert len({one.child_frame_id for one in read}) == len(read)
    for one in read:
        turn = one.transform.rotation
        assert np.hypot(np.hypot(turn.w, turn.x), np.hypot(turn.y, turn.z)) == pytest.approx(1.0)
