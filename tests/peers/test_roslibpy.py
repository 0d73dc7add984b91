"""PyPI roslibpy, the Python client of rosbridge, uses the room on the console's port."""

from __future__ import annotations

import json
import subprocess
import time
from pathlib import Path

import pytest
from rosbridge_stage import DRONE, KEY, ROOM, RosbridgeStage

from housefly.messages import OrderKind

HERE = Path(__file__).parent
PYTHON = HERE.parents[1] / ".venv" / "roslibpy" / "bin" / "python"
pytestmark = [pytest.mark.wire, pytest.mark.interop]


def test_roslibpy_sees_the_room_flies_and_stops(loopback: str, tmp_path: Path) -> None:
    if not PYTHON.is_file():
        pytest.skip("roslibpy is not installed: make interop")
    with RosbridgeStage(loopback, tmp_path, "auto") as stage:
        command = [PYTHON, HERE / "rosbridge_room.py", loopback, str(stage.port), KEY]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120)
        assert done.returncode == 0, done.stderr
        told = json.loads(done.stdout)
        assert told["connected"]
        assert {f"{DRONE}/pose", f"{ROOM}/map", f"{DRONE}/goal_pose"} <= set(told["topics"])
        assert told["type"] == "nav_msgs/msg/Odometry"
        assert abs(told["second"] - time.time()) < 120.0
        assert f"{DRONE}/takeoff" in told["services"]
        assert [one["pose"]["position"]["x"] for one in told["poses"]] == [3.0] * 5
        first, second = (one["header"]["stamp"] for one in told["throttled"])
        assert (
            second["sec"] + 1e-9 * second["nanosec"] - first["sec"] - 1e-9 * first["nanosec"] > 0.3
        )
        assert told["map"]["width"] > 0
        assert told["takeoff"]["success"] and told["stop"]["success"]
        kinds = [one.kind for one in stage.pilot.orders]
        assert kinds[:2] == [OrderKind.TAKE_OFF, OrderKind.GO] and OrderKind.STOP in kinds
        assert stage.stops
