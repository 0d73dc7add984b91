"""A whole room in ROS: a node tells poses, another gives a goal, the drone flies; on the truth."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest
from navigate_client import CANCELED, SUCCEEDED, SentGoal
from ros_flight import RosFlight, ros_flight

from housefly.record.truth import read_truth

pytest.importorskip("rclpy")

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.timeout(400)]
DOMAIN = 1 + os.getpid() % 90
FLIGHT = 120.0
"""Longest wait for a flight, on a machine three times slower than this one [s]."""


def flies_home(flight: RosFlight) -> None:
    """Send the drone home, and wait until it stands there and has touched nothing on its way."""
    client = flight.client
    assert client.calls("/lab/drone/home").success
    assert client.spin(lambda: flight.phases[-1].data == "idle", FLIGHT), flight.log()
    time.sleep(1.0)  # the truth is written in batches
    flown = read_truth(flight.truth)
    assert flown is not None and flown.airborne.any() and not flown.airborne[-1]
    assert [one for one in flown.contacts if one.motors_turned] == []


def test_a_goal_of_a_ros_node_is_flown_by_poses_of_another(tmp_path: Path) -> None:
    from geometry_msgs.msg import PoseStamped

    with ros_flight(tmp_path, DOMAIN) as flight:
        goal = PoseStamped()
        goal.header.frame_id = "map"
        goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = 3.9, 4.2, 1.0
        flight.client.says("/lab/drone/goal_pose", goal)
        is_there = flight.client.spin(lambda: flight.phases[-1].data == "holding", FLIGHT)
        assert is_there, flight.log()
        there = flight.odometry[-1].pose.pose.position
        assert (there.x, there.y) == pytest.approx((3.9, 4.2), abs=0.3)
        flies_home(flight)


def test_an_action_tells_the_way_that_is_left_arrives_and_can_be_called_off(
    tmp_path: Path,
) -> None:
    pytest.importorskip("nav2_msgs.action")
    action = "/lab/drone/navigate_to_pose"
    with ros_flight(tmp_path, DOMAIN + 100) as flight:
        client = flight.client
        first = SentGoal(client, action, 3.9, 4.2)
        assert first.ended(FLIGHT) == (SUCCEEDED, ""), flight.log()
        there = flight.odometry[-1].pose.pose.position
        assert (there.x, there.y) == pytest.approx((3.9, 4.2), abs=0.6)
        left = [one.distance_remaining for one in first.feedback]
        assert left[0] > 1.0 and min(left) < 0.6 < left[0]
        second = SentGoal(client, action, 6.5, 4.2)
        assert client.spin(lambda: flight.phases[-1].data == "flying to goal", FLIGHT)
        assert client.spin(lambda: second.feedback)
        second.cancel()
        assert second.ended()[0] == CANCELED
        assert client.spin(lambda: flight.phases[-1].data == "holding", FLIGHT), flight.log()
        time.sleep(0.3)  # one wish to fly is taken in 0.2 s, and a quick machine is here by then
        flies_home(flight)
