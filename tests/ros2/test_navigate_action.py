"""NavigateToPose of a real action client, with the real type of nav2_msgs.

It is in no package of PyPI: it comes with ROS, or by ``scripts/ros_types.sh``.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any

import pytest
from navigate_client import ABORTED, CANCELED, SUCCEEDED, SentGoal
from ros_stage import DRONE, RosStage, ros_stage

from housefly.messages import DroneStatus, Order, OrderKind, OrderOutcome, OrderSource, Phase
from housefly.tasks.api.questions import RequestTask
from housefly.tasks.api.values import Confirm, TaskStage

pytest.importorskip("rclpy")
pytest.importorskip("nav2_msgs.action")

pytestmark = [pytest.mark.wire, pytest.mark.slow]
WISH_PERIOD = 0.2
"""One wish in this time is taken [s]."""


@pytest.fixture(scope="module")
def trusted(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RosStage]:
    """A site that lets ROS fly."""
    domain = 60 + os.getpid() % 50
    with ros_stage(tmp_path_factory.mktemp("ros"), domain, ros2__requests="auto") as stage:
        yield stage


@pytest.fixture(scope="module")
def asking(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RosStage]:
    """A site where a person says yes."""
    with ros_stage(tmp_path_factory.mktemp("ros"), 110 + os.getpid() % 50) as stage:
        stage.tasks.flies_to_points()
        yield stage


@pytest.fixture
def stage(trusted: RosStage) -> RosStage:
    trusted.pilot.land()
    trusted.pilot.refused.clear()
    rest(trusted)
    return trusted


def rest(stage: RosStage) -> None:
    """Wait until the next wish is taken."""
    stage.client.spin(lambda: False, 2.0 * WISH_PERIOD)


def sent_to(stage: RosStage, x: float, y: float, **changes: Any) -> SentGoal:
    return SentGoal(stage.client, f"{DRONE}/navigate_to_pose", x, y, **changes)


def flown(stage: RosStage) -> Order:
    """Wait until the pilot flies to the newest goal; return its order."""

    def goes() -> list[Order]:
        return [one for one in stage.pilot.orders if one.kind is OrderKind.GO]

    assert stage.client.spin(goes)
    stage.pilot.status, stage.pilot.phase = DroneStatus.FLYING, Phase.OUTBOUND
    return goes()[-1]


def test_a_goal_is_flown_with_the_way_that_is_left_until_the_drone_holds_there(
    stage: RosStage,
) -> None:
    sent = sent_to(stage, 6.0, 6.0)
    order = flown(stage)
    assert (order.goal, order.source) == ((6.0, 6.0), OrderSource.PROGRAM)
    assert stage.client.spin(lambda: sent.feedback)
    first = sent.feedback[0]
    assert first.distance_remaining == pytest.approx(5.0)
    assert first.current_pose.pose.position.x == pytest.approx(3.0)
    stage.pilot.place, stage.pilot.phase = (6.0, 6.0, 1.1), Phase.HOLDING
    assert sent.ended() == (SUCCEEDED, "")


@pytest.mark.parametrize(
    "changes", [{"frame": "odom"}, {"behavior_tree": "spin.xml"}, {"x": float("nan")}]
)
def test_a_goal_that_makes_no_sense_is_not_accepted(
    stage: RosStage, changes: dict[str, Any]
) -> None:
    sent = sent_to(stage, **({"x": 1.0, "y": 1.0} | changes))
    assert not sent.handle.accepted and not stage.pilot.orders


def test_a_goal_that_is_called_off_leaves_the_drone_where_it_is_in_nobodys_hands(
    stage: RosStage,
) -> None:
    sent = sent_to(stage, 6.0, 6.0)
    flown(stage)
    assert stage.client.spin(lambda: sent.feedback)
    sent.cancel()
    assert sent.ended()[0] == CANCELED
    assert stage.pilot.orders[-1].kind is OrderKind.HOVER
    stage.pilot.phase = Phase.HOLDING
    rest(stage)
    assert stage.client.calls(f"{DRONE}/home").success


def test_a_pilot_that_does_not_hover_is_stopped(stage: RosStage) -> None:
    stage.pilot.refused[OrderKind.HOVER] = OrderOutcome.WRONG_PHASE
    sent = sent_to(stage, 6.0, 6.0)
    flown(stage)
    assert stage.client.spin(lambda: sent.feedback)
    sent.cancel()
    assert sent.ended()[0] == CANCELED
    assert stage.pilot.orders[-1].kind is OrderKind.STOP


def test_a_newer_goal_takes_the_place_of_the_first(stage: RosStage) -> None:
    first = sent_to(stage, 6.0, 6.0)
    flown(stage)
    assert stage.client.spin(lambda: first.feedback)
    rest(stage)
    second = sent_to(stage, 5.0, 2.0)
    status, words = first.ended()
    assert status == ABORTED and ("newer goal" in words or "go of ROS 2" in words)
    assert stage.client.spin(lambda: second.feedback) and second.is_open()
    stage.pilot.place, stage.pilot.phase = (5.0, 2.0, 1.1), Phase.HOLDING
    assert second.ended()[0] == SUCCEEDED
    assert OrderKind.HOVER not in {one.kind for one in stage.pilot.orders}


def test_a_person_who_takes_the_drone_or_stops_it_ends_the_goal(stage: RosStage) -> None:
    for kind in (OrderKind.HOME, OrderKind.STOP):
        stage.pilot.land()
        rest(stage)
        sent = sent_to(stage, 6.0, 6.0)
        flown(stage)
        assert stage.client.spin(lambda sent=sent: sent.feedback)
        stage.pilot.give(Order(kind, sender="Anna", source=OrderSource.PERSON, id="theirs"))
        status, words = sent.ended()
        assert status == ABORTED and "Anna" in words
    refused = sent_to(stage, 5.0, 2.0)
    assert "Resume is a person's" in refused.ended()[1]


def test_a_goal_that_the_pilot_refuses_is_aborted_in_its_words(stage: RosStage) -> None:
    stage.pilot.refused[OrderKind.GO] = OrderOutcome.NO_WAY
    assert sent_to(stage, 6.0, 6.0).ended()[0] == ABORTED


def test_a_stop_passes_while_goals_are_flown_and_flooded(stage: RosStage) -> None:
    goals = [sent_to(stage, 6.0, 6.0) for _ in range(12)]
    assert stage.client.calls(f"{DRONE}/stop").success
    assert {one.ended()[0] for one in goals} == {ABORTED}


def test_where_a_person_is_asked_a_goal_waits_for_the_yes(asking: RosStage) -> None:
    asking.pilot.land()
    sent = sent_to(asking, 6.0, 4.0)
    assert asking.client.spin(lambda: asking.tasks.tasks and sent.feedback)
    asked = [one for one in asking.tasks.asked if isinstance(one, RequestTask)][-1]
    assert (asked.service, asked.confirm) == ("fly_to", Confirm.ASK) and not asking.pilot.orders
    number = max(asking.tasks.tasks)
    asking.tasks.advance(number, 1)
    asking.pilot.status, asking.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
    asking.pilot.place = (6.0, 4.0, 1.1)
    assert sent.ended()[0] == SUCCEEDED


def test_a_question_that_is_called_off_is_taken_back(asking: RosStage) -> None:
    asking.pilot.land()
    sent = sent_to(asking, 6.0, 4.0)
    assert asking.client.spin(lambda: sent.feedback)
    sent.cancel()
    assert sent.ended()[0] == CANCELED
    number = max(asking.tasks.tasks)
    assert asking.tasks.tasks[number].state is TaskStage.CANCELLED


def test_a_no_aborts_the_goal(asking: RosStage) -> None:
    asking.pilot.land()
    sent = sent_to(asking, 6.0, 4.0)
    assert asking.client.spin(lambda: sent.feedback)
    asking.tasks.refuse(max(asking.tasks.tasks), "Anna said no")
    status, words = sent.ended()
    assert status == ABORTED and "Anna said no" in words
