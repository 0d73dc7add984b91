"""Sentences and questions from ROS: any text is answered, and nothing flies without a yes."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from threading import Event, Semaphore

from hypothesis import example, given
from hypothesis import strategies as st

from housefly.bus.local import LocalBus
from housefly.bus.topics import HUB_QUERY, TASKS_QUERY, DroneTopics
from housefly.clock import RealClock
from housefly.config.ros2 import RosRequests
from housefly.messages import Order, OrderKind
from housefly.ros2.flight_desk import FlightDesk
from housefly.ros2.order_line import OrderLine
from housefly.ros2.question_desk import QuestionDesk
from housefly.ros2.ros_caller import node_caller


def question_desk(requests: RosRequests) -> tuple[QuestionDesk, list[str], list[Order]]:
    """Return a desk, what it asks the tasks, and the orders that it gives."""
    bus, asked, orders = LocalBus(), list[str](), list[Order]()

    def answer(text: str) -> str:
        asked.append(text)
        return '{"error": "busy", "code": "not_ready"}'

    bus.answer(TASKS_QUERY, answer)
    bus.answer(HUB_QUERY, lambda _: '{"things": []}')
    bus.subscribe(DroneTopics().order, orders.append)
    return QuestionDesk(bus, node_caller(requests)), asked, orders


@given(
    st.one_of(st.text(max_size=200), st.binary(max_size=80).map(lambda raw: raw.decode("latin")))
)
@example("{" * 5000)
@example('{"ask": "reply", "task": 1, "question": "confirm", "choice": "yes"}')
def test_any_text_is_answered_by_json_and_never_by_a_yes(text: str) -> None:
    answering, asked, orders = question_desk("ask")
    assert isinstance(json.loads(answering.ask(text)), dict)
    assert not orders and all(json.loads(one)["ask"] != "reply" for one in asked)
    assert all(json.loads(one).get("confirm", "ask") == "ask" for one in asked)


def test_where_flights_are_off_a_sentence_starts_none_and_a_request_is_refused() -> None:
    answering, asked, _ = question_desk("off")
    assert "off" in json.loads(answering.ask('{"service": "visitor"}'))["error"]
    answering.ask("fly to the sofa")
    assert [json.loads(one)["fly"] for one in asked] == [False]


def test_only_two_questions_wait_at_once_so_that_a_stop_finds_a_thread() -> None:
    bus, begun, go_on, orders = LocalBus(), Semaphore(0), Event(), list[Order]()

    def slow(_: str) -> str:
        begun.release()
        go_on.wait(30.0)
        return "{}"

    bus.answer(HUB_QUERY, slow)
    bus.subscribe(DroneTopics().order, orders.append)
    answering = QuestionDesk(bus, node_caller("ask"))
    line = OrderLine(bus, ("drone",), RealClock())
    flying = FlightDesk(bus, line, node_caller("ask"), True, RealClock())
    question = '{"ask": "where", "thing": "cup"}'
    with ThreadPoolExecutor(2) as waiting:
        answers = [waiting.submit(answering.ask, question) for _ in range(2)]
        assert all(begun.acquire(timeout=30.0) for _ in range(2))
        assert "already" in json.loads(answering.ask(question))["error"]
        flying.stop("drone")
        go_on.set()
    assert [one.result() for one in answers] == ["{}", "{}"]
    assert [one.kind for one in orders] == [OrderKind.STOP]
