"""The node beside real rclpy nodes: what others see of it, and what they may do with it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from io import BytesIO
from math import nan
from pathlib import Path
from threading import Event
from typing import Any

import numpy as np
import pytest
from filming import number_of, video
from PIL import Image
from ros_stage import DRONE, ROOM, RosStage, ros_stage

from housefly.bus.topics import DroneTopics
from housefly.config.house_mode import HouseMode
from housefly.messages import OrderKind, OrderOutcome, OrderSource
from housefly.ros2.topic_table import DRONE_TOPICS, ROOM_TOPICS, Quality, full_name
from housefly.tasks.api.questions import CancelTask, RequestTask, Sentence
from housefly.tasks.api.values import Confirm, RequestSurface

pytest.importorskip("rclpy")

pytestmark = [pytest.mark.wire, pytest.mark.slow]


def goal(x: float, y: float, frame: str = "map") -> Any:
    from geometry_msgs.msg import PoseStamped

    message = PoseStamped()
    message.header.frame_id = frame
    message.pose.position.x, message.pose.position.y = x, y
    message.pose.orientation.w = 1.0
    return message


def text(words: str) -> Any:
    from std_msgs.msg import String

    return String(data=words)


@pytest.fixture(scope="module")
def trusted(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RosStage]:
    """A site that lets ROS fly."""
    domain = 100 + os.getpid() % 50
    with ros_stage(
        tmp_path_factory.mktemp("ros"),
        domain,
        ros2__requests="auto",
        ros2__paper_names=True,
        limits__nudge_speed=0.4,
    ) as stage:
        yield stage


@pytest.fixture(scope="module")
def asking(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RosStage]:
    """A site where a person says yes."""
    with ros_stage(tmp_path_factory.mktemp("ros"), 160 + os.getpid() % 50) as stage:
        yield stage


@pytest.fixture
def stage(trusted: RosStage) -> RosStage:
    trusted.pilot.land()
    trusted.pilot.refused.clear()
    return trusted


def test_every_topic_has_the_type_and_quality_that_the_table_says(stage: RosStage) -> None:
    client = stage.client
    expected = {full_name(one, "b_sen", "drone"): one for one in DRONE_TOPICS}
    expected |= {full_name(one, "b_sen"): one for one in ROOM_TOPICS}
    assert client.spin(lambda: set(expected) <= set(client.types())), client.types()
    assert {name: client.types()[name] for name in expected} == {
        name: one.type for name, one in expected.items()
    }
    for name, one in expected.items():
        profile = client.node.get_publishers_info_by_topic(name)[0].qos_profile
        assert (profile.reliability.name == "BEST_EFFORT") is (one.quality is Quality.SENSOR), name
        assert (profile.durability.name == "TRANSIENT_LOCAL") is (one.quality is Quality.LATCHED), (
            name
        )


def test_who_comes_late_gets_map_room_and_tasks(stage: RosStage) -> None:
    client = stage.client
    maps, rooms = client.heard(f"{ROOM}/map", True), client.heard(f"{ROOM}/room", True)
    boards = client.heard(f"{ROOM}/tasks", True)
    assert client.spin(lambda: maps and rooms and boards)
    grid = maps[0]
    assert (grid.header.frame_id, grid.info.resolution) == ("map", pytest.approx(0.1))
    assert {0, 100} <= set(grid.data) and len(grid.data) == grid.info.width * grid.info.height
    assert len(rooms[0].markers) > 20 and '"mode":"home"' in boards[0].data.replace(" ", "")


def test_poses_are_stamped_by_the_time_of_capture(stage: RosStage) -> None:
    poses = stage.client.heard(f"{DRONE}/pose")
    assert stage.client.spin(lambda: len(poses) > 20)
    stamps = [one.header.stamp.sec + 1e-9 * one.header.stamp.nanosec for one in poses]
    assert stamps == sorted(stamps) and abs(time.time() - stamps[-1]) < 30.0
    assert (poses[0].pose.position.x, poses[0].header.frame_id) == (3.0, "map")


def test_the_example_node_follows_the_drone(stage: RosStage) -> None:
    environment = os.environ | {"ROS_DOMAIN_ID": str(stage.domain)}
    script = Path(__file__).parents[2] / "examples" / "ros2" / "see_the_room.py"
    command = [sys.executable, str(script), "b_sen"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120)
    assert done.stdout.splitlines() == ["x 3.00 m, y 2.00 m, height 1.10 m"] * 10, done.stderr


def test_a_goal_flies_there_and_faces_its_heading(stage: RosStage) -> None:
    stage.client.says(f"{DRONE}/goal_pose", goal(6.0, 4.0))
    assert stage.client.spin(lambda: stage.pilot.orders)
    order = stage.pilot.orders[0]
    assert (order.kind, order.goal, order.source) == (OrderKind.GO, (6.0, 4.0), OrderSource.PROGRAM)
    assert order.look_at is not None and order.look_at[:2] == pytest.approx((8.0, 4.0))


@pytest.mark.parametrize("wrong", [goal(6.0, 4.0, "odom"), goal(nan, 4.0)], ids=["frame", "nan"])
def test_a_goal_that_makes_no_sense_flies_nowhere_and_is_answered(
    stage: RosStage, wrong: Any
) -> None:
    told = stage.client.heard("/rosout")
    stage.client.says(f"{DRONE}/goal_pose", wrong)
    assert stage.client.spin(lambda: any("allowed" in one.msg for one in told))
    assert not stage.pilot.orders


def test_the_services_give_orders_and_say_what_the_pilot_says(stage: RosStage) -> None:
    for name, kind in (
        ("takeoff", OrderKind.TAKE_OFF),
        ("home", OrderKind.HOME),
        ("land", OrderKind.LAND),
        ("stop", OrderKind.STOP),
    ):
        time.sleep(0.3)
        assert stage.client.calls(f"{DRONE}/{name}").success, name
        assert stage.pilot.orders[-1].kind is kind
    assert stage.client.calls(f"{ROOM}/stop").success
    time.sleep(0.3)
    stage.pilot.refused[OrderKind.TAKE_OFF] = OrderOutcome.BATTERY
    assert not stage.client.calls(f"{DRONE}/takeoff").success


def test_who_flies_the_drone_keeps_it_but_stop_and_land_always_pass(stage: RosStage) -> None:
    stage.pilot.flown_by("Anna")
    time.sleep(0.5)
    refused = stage.client.calls(f"{DRONE}/home")
    assert (refused.success, refused.message) == (False, "Anna flies it")
    assert stage.client.calls(f"{DRONE}/land").success
    assert stage.client.calls(f"{DRONE}/stop").success
    assert [one.kind for one in stage.pilot.orders] == [
        *(OrderKind.GO, OrderKind.LAND, OrderKind.STOP)
    ]


def test_the_papers_node_is_served_too(stage: RosStage) -> None:
    from geometry_msgs.msg import Twist
    from std_msgs.msg import Empty

    stage.client.says("/ardrone/takeoff", Empty())
    assert stage.client.spin(lambda: stage.pilot.orders)
    assert stage.pilot.orders[0].kind is OrderKind.TAKE_OFF
    twist = Twist()
    twist.linear.x = 1.0
    stage.client.says("/cmd_vel", twist)
    assert stage.client.spin(lambda: len(stage.pilot.orders) > 1)
    nudge = stage.pilot.orders[1]
    assert nudge.kind is OrderKind.NUDGE and nudge.velocity is not None
    assert nudge.velocity[0] > 0.0 == nudge.velocity[1]


@contextmanager
def filmed(stage: RosStage) -> Iterator[set[bytes]]:
    """Send pictures as a drone does; yield the key frames among them."""
    frames, ended = list(video(2.0, 0.0)), Event()

    def film() -> None:
        number = 0
        while not ended.wait(1 / 15):
            frame = frames[number % len(frames)]
            now = time.monotonic()
            sent = replace(frame, sequence=number, received_at=now)
            stage.pilot.bus.publish(DroneTopics().video, sent)
            number += 1

    with ThreadPoolExecutor(1) as filming:
        filming.submit(film)
        try:
            yield {frame.data for frame in frames if frame.keyframe}
        finally:
            ended.set()


def test_pictures_go_out_as_they_came_and_as_jpeg_and_none_in_mode_privacy(stage: RosStage) -> None:
    client, tasks = stage.client, stage.tasks
    jpegs = client.heard(f"{DRONE}/camera/image_raw/compressed")
    raw, info = client.heard(f"{DRONE}/camera/h264"), client.heard(f"{DRONE}/camera/camera_info")
    with filmed(stage) as keys:
        assert client.spin(lambda: jpegs and len(raw) > 20 and info)
        with Image.open(BytesIO(bytes(jpegs[0].data))) as picture:
            assert number_of(np.asarray(picture)) in range(30)
        assert bytes(raw[0].data) in keys and raw[0].format == "h264"
        tasks.mode = HouseMode.PRIVACY
        tasks.tell()
        client.spin(lambda: False, 1.0)
        raw.clear()
        jpegs.clear()
        client.spin(lambda: False, 1.0)
        assert not raw and not jpegs
        tasks.mode = HouseMode.HOME
        tasks.tell()
        assert client.spin(lambda: raw)
        assert bytes(raw[0].data) in keys, "it goes on with a key frame"


FLOOD = """
import sys, time, rclpy
from geometry_msgs.msg import PoseStamped
rclpy.init(domain_id=int(sys.argv[1]))
node = rclpy.create_node("flood")
publisher = node.create_publisher(PoseStamped, "/b_sen/drone/goal_pose", 1000)
while not publisher.get_subscription_count():
    time.sleep(0.05)
print("floods", flush=True)
while True:
    publisher.publish(PoseStamped())
"""


def test_a_node_that_floods_and_dies_holds_up_no_stop(stage: RosStage) -> None:
    command = [sys.executable, "-c", FLOOD, str(stage.domain)]
    flood = subprocess.Popen(command, stdout=subprocess.PIPE)
    try:
        assert flood.stdout is not None and flood.stdout.readline() == b"floods\n"
        assert stage.client.calls(f"{DRONE}/stop").success
    finally:
        flood.send_signal(signal.SIGKILL)
        flood.wait()
    assert OrderKind.STOP in {one.kind for one in stage.pilot.orders}
    assert stage.process.poll() is None
    poses = stage.client.heard(f"{DRONE}/odom")
    assert stage.client.spin(lambda: poses)


def test_where_a_person_is_asked_a_goal_becomes_a_question(asking: RosStage) -> None:
    client, tasks = asking.client, asking.tasks
    client.says(f"{DRONE}/goal_pose", goal(6.0, 4.0))
    assert client.spin(lambda: any(isinstance(one, RequestTask) for one in tasks.asked))
    asked = next(one for one in tasks.asked if isinstance(one, RequestTask))
    assert (asked.service, asked.parameters) == ("fly_to", {"x": 6.0, "y": 4.0})
    assert (asked.confirm, asked.surface, asked.drone) == (
        *(Confirm.ASK, RequestSurface.ROS, "drone"),
    )
    assert not asking.pilot.orders


def test_a_task_is_a_service_and_needs_the_yes(asking: RosStage) -> None:
    reply = asking.client.calls(f"{ROOM}/tasks/visitor")
    assert reply.success and "a person must say yes" in reply.message
    newest = [one for one in asking.tasks.asked if isinstance(one, RequestTask)][-1]
    assert (newest.service, newest.confirm) == ("visitor", Confirm.ASK)


def test_a_second_wish_takes_the_first_back_while_that_waits(asking: RosStage) -> None:
    asking.client.calls(f"{ROOM}/tasks/visitor")
    before = len(asking.tasks.asked)
    asking.client.calls(f"{ROOM}/tasks/patrol")
    assert any(isinstance(one, CancelTask) for one in asking.tasks.asked[before:])


def test_a_sentence_is_asked_as_everybodys_and_never_flies_without_a_yes(asking: RosStage) -> None:
    answers = asking.client.heard(f"{ROOM}/answers")
    asking.client.says(f"{ROOM}/ask", text("look at the refrigerator"))
    assert asking.client.spin(lambda: answers)
    said = [one for one in asking.tasks.asked if isinstance(one, Sentence)][-1]
    assert (said.confirm, said.may_fly, said.owner) == (Confirm.ASK, False, "ros2")


@pytest.mark.parametrize("words", ['{"ask": "mode", "mode": "privacy"}', "{", '{"ask": [1]}', ""])
def test_what_may_not_be_asked_is_refused_in_words(asking: RosStage, words: str) -> None:
    answers = asking.client.heard(f"{ROOM}/answers")
    before = len(asking.tasks.asked)
    asking.client.says(f"{ROOM}/ask", text(words))
    assert asking.client.spin(lambda: answers)
    assert "error" in answers[0].data and len(asking.tasks.asked) == before
