"""Wishes from ROS at the desk: any text is answered, and nothing flies that may not."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from math import inf, nan
from threading import Event, Semaphore

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from housefly.bus.local import LocalBus
from housefly.bus.topics import HUB_QUERY, TASKS_QUERY, DroneTopics
from housefly.clock import RealClock
from housefly.config.ros2 import RosRequests
from housefly.messages import Order, OrderKind
from housefly.ros2.flight_desk import FlightDesk
from housefly.ros2.order_line import OrderLine
from housefly.ros2.ros_caller import node_caller

OFF, ASK, AUTO = "off", "ask", "auto"


def desk(
    requests: RosRequests, has_tasks: bool = True
) -> tuple[FlightDesk, list[str], list[Order]]:
    """Return a desk, what it asks the tasks, and the orders that it gives."""
    bus, asked, orders = LocalBus(), list[str](), list[Order]()

    def answer(text: str) -> str:
        asked.append(text)
        return '{"error": "busy", "code": "not_ready"}'

    bus.answer(TASKS_QUERY, answer)
    bus.answer(HUB_QUERY, lambda _: '{"things": []}')
    bus.subscribe(DroneTopics().order, orders.append)
    return _desk(bus, requests, has_tasks), asked, orders


def _desk(bus: LocalBus, requests: RosRequests, has_tasks: bool = True) -> FlightDesk:
    clock = RealClock()
    return FlightDesk(
        bus, OrderLine(bus, ("drone",), clock), node_caller(requests), has_tasks, clock
    )


@given(
    st.one_of(st.text(max_size=200), st.binary(max_size=80).map(lambda raw: raw.decode("latin")))
)
@example("{" * 5000)
@example('{"ask": "reply", "task": 1, "question": "confirm", "choice": "yes"}')
def test_any_text_is_answered_by_json_and_never_by_a_yes(text: str) -> None:
    answering, asked, orders = desk("ask")
    assert isinstance(json.loads(answering.ask(text)), dict)
    assert not orders and all(json.loads(one)["ask"] != "reply" for one in asked)
    assert all(json.loads(one).get("confirm", "ask") == "ask" for one in asked)


@given(st.tuples(st.sampled_from([nan, inf, -inf, 1.0]), st.sampled_from([nan, inf])))
def test_a_goal_that_is_no_point_flies_nowhere(goal: tuple[float, float]) -> None:
    for requests in ("ask", "auto"):
        answering, asked, orders = desk(requests)  # type: ignore[arg-type]
        assert not answering.fly_to("drone", goal).success
        assert not asked and not orders


@pytest.mark.parametrize("requests", [OFF, ASK])
def test_without_trust_no_order_moves_the_drone_but_stop_land_and_home(
    requests: RosRequests,
) -> None:
    answering, _, orders = desk(requests)
    answering.take_off("drone")
    answering.fly_to("drone", (1.0, 1.0), 0.0)
    assert "auto" in answering.nudge("drone", (0.1, 0.0, 0.0))
    assert not orders
    answering.stop("drone")
    answering.land("drone")
    assert [one.kind for one in orders] == [OrderKind.STOP, OrderKind.LAND]


def test_where_flights_are_off_a_sentence_starts_none_and_a_request_is_refused() -> None:
    answering, asked, _ = desk("off")
    assert "off" in json.loads(answering.ask('{"service": "visitor"}'))["error"]
    answering.ask("fly to the sofa")
    assert [json.loads(one)["fly"] for one in asked] == [False]


def test_without_services_nobody_can_be_asked_and_that_is_said() -> None:
    answering, asked, _ = desk("ask", has_tasks=False)
    assert "no services run here" in answering.request("visitor", {}).message
    assert not asked


def test_only_two_questions_wait_at_once_so_that_a_stop_finds_a_thread() -> None:
    bus, begun, go_on, orders = LocalBus(), Semaphore(0), Event(), list[Order]()

    def slow(_: str) -> str:
        begun.release()
        go_on.wait(30.0)
        return "{}"

    bus.answer(HUB_QUERY, slow)
    bus.subscribe(DroneTopics().order, orders.append)
    answering = _desk(bus, "ask")
    question = '{"ask": "where", "thing": "cup"}'
    with ThreadPoolExecutor(2) as waiting:
        answers = [waiting.submit(answering.ask, question) for _ in range(2)]
        assert all(begun.acquire(timeout=30.0) for _ in range(2))
        assert "already" in json.loads(answering.ask(question))["error"]
        answering.stop("drone")
        go_on.set()
    assert [one.result() for one in answers] == ["{}", "{}"]
    assert [one.kind for one in orders] == [OrderKind.STOP]
