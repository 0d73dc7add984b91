"""What is asked for in Home Assistant: as tasks and orders, within the site's rules."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from stand_in_tasks import StandInTasks

from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.clock import SteppedClock
from housefly.config.homeassistant import HomeAssistantConfig
from housefly.homeassistant.home_requests import HomeRequests
from housefly.homeassistant.topics import HomeTopics
from housefly.messages import Order, OrderKind
from housefly.messages.flight import OrderSource
from housefly.tasks.api.questions import ReplyToTask, RequestTask
from housefly.tasks.api.values import Confirm, Priority, RequestSurface, TaskStage

TOPICS = HomeTopics("home")
DRONE = TOPICS.drone_command("drone")


class Room:
    """A room with tasks and one drone, and what reached them."""

    def __init__(self, config: HomeAssistantConfig) -> None:
        self.bus, self.clock = LocalBus(), SteppedClock()
        self.tasks = StandInTasks(self.bus)
        self.orders: list[Order] = []
        self.stops = 0
        self.bus.subscribe(DroneTopics("drone").order, self.orders.append)
        self.requests = HomeRequests(
            config,
            TOPICS,
            ["entrance", "tv"],
            {"drone": self._stop},
            self.bus,
            self.tasks.board,
            self.clock,
        )

    def _stop(self) -> Future[bool]:
        self.stops += 1
        return Future()

    def take(self, payload: bytes, topic: str = DRONE) -> str:
        return self.requests.take(topic, payload)

    @property
    def asked(self) -> list[Any]:
        return [one for one in self.tasks.asked if isinstance(one, RequestTask | ReplyToTask)]


@pytest.fixture
def room() -> Iterator[Room]:
    made = Room(HomeAssistantConfig(enabled=True))
    yield made
    made.requests.close()


def answered(task: int, choice: str, question: str = "confirm") -> bytes:
    return f"{task}|{question}|{choice}".encode()


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=200)
@given(st.binary(max_size=60), st.sampled_from([DRONE, TOPICS.answer_command, "other"]))
def test_no_bytes_fly_anything_but_by_its_words(room: Room, payload: bytes, topic: str) -> None:
    if payload.strip() not in (b"stop", b"start", b"land", b"hover", b"home"):
        assert room.take(payload, topic).startswith("refused: ")
        assert room.asked == [] and room.orders == []


def test_a_place_is_looked_at_after_a_persons_yes(room: Room) -> None:
    assert room.take(b"go entrance").endswith("waiting for a yes")
    (asked,) = room.asked
    assert (asked.service, asked.parameters) == ("look", {"subject": "entrance"})
    assert asked.confirm is Confirm.ASK and asked.surface is RequestSurface.MQTT
    assert asked.priority is Priority.PERSON and asked.by == "Home Assistant"
    assert "no place 'moon'" in room.take(b"go moon")
    assert len(room.asked) == 1


def test_it_flies_by_itself_only_where_the_site_says_so() -> None:
    room = Room(HomeAssistantConfig(enabled=True, requests="auto"))
    assert room.take(b"start").endswith("queued")
    assert room.asked[0].service == "visitor" and room.asked[0].confirm is Confirm.AUTO


def test_what_ends_a_flight_is_an_order_and_nobody_is_asked(room: Room) -> None:
    for payload, kind in (
        (b"land", OrderKind.LAND),
        (b"hover", OrderKind.HOVER),
        (b"home", OrderKind.HOME),
    ):
        assert room.requests.is_order(DRONE, payload)
        room.take(payload)
        assert room.orders[-1].kind is kind
        assert room.orders[-1].source is OrderSource.PROGRAM, "it cannot insist as a person can"
    assert room.asked == []


@pytest.mark.parametrize("requests", ["off", "ask", "auto"])
def test_stop_passes_whatever_the_site_allows_and_however_often(requests: Any) -> None:
    room = Room(HomeAssistantConfig(enabled=True, requests=requests))
    assert room.requests.is_stop(DRONE, b"stop")
    for _ in range(500):
        room.requests.stop(DRONE)
    room.requests.close()
    assert room.stops == 500
    room.requests._thread.shutdown(wait=True)
    assert len(room.orders) >= 1 and {order.kind for order in room.orders} == {OrderKind.STOP}


def test_where_nothing_may_be_asked_for_nothing_but_stop_is_done() -> None:
    room = Room(HomeAssistantConfig(enabled=True, requests="off", answers=True))
    room.tasks.ring()
    for payload in (b"start", b"go entrance", b"land", b"home"):
        assert room.take(payload).startswith("refused: ")
    assert room.take(b"yes", TOPICS.answer_command).startswith("refused: ")
    assert room.asked == [] and room.orders == []


def test_a_yes_is_said_only_where_the_site_says_so_a_no_always(room: Room) -> None:
    task = room.tasks.ring()
    assert "answers = false" in room.take(b"yes", TOPICS.answer_command)
    assert "answers = false" in room.take(answered(task.id, "look"), TOPICS.answer_command)
    assert room.asked == []
    room.take(b"no", TOPICS.answer_command)
    assert room.asked == [ReplyToTask(task.id, "confirm", "ignore", "Home Assistant")]


def test_an_answer_is_for_the_question_that_was_shown_and_no_later_one() -> None:
    room = Room(HomeAssistantConfig(enabled=True, answers=True))
    first, second = room.tasks.ring(), room.tasks.ring()
    assert "2 questions wait" in room.take(b"yes", TOPICS.answer_command)
    for stale in (answered(99, "yes"), answered(first.id, "yes", "come home?")):
        assert "nobody asks that any more" in room.take(stale, TOPICS.answer_command)
    assert "is no answer" in room.take(answered(first.id, "perhaps"), TOPICS.answer_command)
    assert room.asked == []
    room.take(answered(second.id, "yes"), TOPICS.answer_command)
    assert room.tasks.tasks[second.id].state is TaskStage.QUEUED
    assert room.tasks.tasks[first.id].state is TaskStage.WAITING
    assert "nobody asks" in room.take(answered(second.id, "yes"), TOPICS.answer_command)


def test_a_flood_is_cut_and_a_minute_later_one_may_ask_again(room: Room) -> None:
    for _ in range(100):
        room.take(b"go entrance")
        room.take(b"hover")
    assert len(room.asked) == 20 and len(room.orders) == 5
    room.clock.advance(61.0)
    room.take(b"go tv")
    room.take(b"hover")
    assert len(room.asked) == 21 and len(room.orders) == 6


def test_silent_tasks_are_said_in_words(room: Room) -> None:
    room.tasks.close()
    assert room.take(b"start") == "refused: the services of the house do not answer"
