"""The room over HTTP: asked by our own client, by strangers' fuzzing, by nobody without a key."""

from __future__ import annotations

import contextlib
import json
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest
import schemathesis
from hypothesis import HealthCheck, given, settings
from schemathesis.specs.openapi.checks import positive_data_acceptance
from served_room import HOOK_KEY, KEY, ServedRoom
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect as connect_socket

import housefly
from housefly.errors import LinkError, ThingError, WireError
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.hub.client.room_client import RoomClient
from housefly.messages import Observation, RoomEvent

pytestmark = pytest.mark.wire


@pytest.fixture
def room(loopback: str, tmp_path: Path) -> Iterator[ServedRoom]:
    made = ServedRoom(loopback, tmp_path)
    yield made
    made.close()


@pytest.fixture
def client(room: ServedRoom) -> Iterator[RoomClient]:
    with housefly.connect(address=room.address, key=KEY) as one:
        yield one


def test_our_client_asks_everything(room: ServedRoom, client: RoomClient) -> None:
    now = time.time()
    room.memory.add(Observation("cup", "floor", now - 60.0, now, (3.0, 4.0, 0.0)))
    room.memory.add(RoomEvent("object taken", "cup", now - 50.0, "situations/objects", "person-1"))
    room.memory.add(Observation("cup", "cabinet", now - 10.0, now, inside="cabinet"))
    assert client.where("cup").inside == ("cabinet",)
    assert client.where("cup", at=now - 30.0).position == (3.0, 4.0, 0.0)
    assert [thing.thing for thing in client.things("furniture")] == ["cabinet"]
    assert [thing.thing for thing in client.contents("cabinet")] == ["cup"]
    assert [thing.thing for thing in client.near("cabinet", 0.5)] == ["cup"]
    assert [thing.thing for thing in client.near((1.0, 2.0, 0.5), 0.1)] == ["cabinet", "cup"]
    assert [(event.kind, event.cause) for event in client.events(thing="cup")] == [
        ("object taken", "person-1")
    ]
    assert client.trajectory("cup", now - 100.0).shape == (1, 4)
    assert {thing.thing for thing in client.picture().things} == {"cabinet", "cup"}
    assert client.sensors() == ()
    assert client.memory() == ""


def test_states_people_and_nights_are_answered_over_http_too(
    room: ServedRoom, client: RoomClient
) -> None:
    now = time.time()
    room.memory.add(Observation("stove", "stove", now - 3.0, now, facts=(("power", 1420.0),)))
    assert client.state("stove", "on").answer == "unknown", "nothing listens to it"
    room.status.add_health_source(lambda: ())
    answer = client.state("stove", "on")
    assert (answer.answer, answer.sources) == ("yes", ("stove",))
    assert answer.words.startswith("Yes: the stove draws 1 420 W, ")
    assert client.state("stove", "off").answer == "no"
    with pytest.raises(WireError, match=r"state is 'boiling'; allowed here: on, "):
        client.state("stove", "boiling")
    assert client.people() == ()
    assert client.nights(now - 86400.0) == ()


def test_refusals_are_the_errors_that_they_are(room: ServedRoom, client: RoomClient) -> None:
    with pytest.raises(ThingError, match="cup"):
        client.where("cupp")
    with pytest.raises(WireError, match="radius"):
        client.near("cup", -1.0)
    room.answering.close()
    with pytest.raises(LinkError, match="memory does not answer"):
        client.where("cup")


def test_nobody_is_answered_without_a_key(room: ServedRoom) -> None:
    for key in ("", "wrong", KEY[:-1], "ü"):
        with (
            RoomClient(room.address, "x") as stranger,
            pytest.raises((LinkError, UnicodeEncodeError)),
        ):
            stranger._headers = {"Authorization": f"Bearer {key}"}
            stranger.where("cup")
    with pytest.raises(InvalidStatus):
        connect_socket(room.address.replace("http", "ws") + "/api/v1/watch")


def test_a_listener_hears_what_changes(room: ServedRoom, client: RoomClient) -> None:
    heard: list[Any] = []

    def listen() -> None:
        with contextlib.suppress(LinkError):
            for news in client.watch():
                heard.append(news)
                return

    listener = threading.Thread(target=listen)
    listener.start()
    deadline = time.monotonic() + 5.0
    while not heard and time.monotonic() < deadline:
        room.memory.add(Observation("cup", "floor", time.time(), time.time(), (1.0, 1.0, 0.0)))
        if (news := room.change_feed.changes()) is not None:
            room.bus.publish(ROOM_NEWS_TOPIC, news)
        time.sleep(0.02)
    listener.join(5.0)
    assert [thing.thing for thing in heard[0].things] == ["cup"]


@pytest.mark.parametrize("query", ["at=yesterday", "at=1&at=2", "colour=red", "at=nan"])
def test_a_bad_parameter_is_named(room: ServedRoom, query: str) -> None:
    request = Request(f"{room.address}/api/v1/where/cup?{query}")
    request.add_header("Authorization", f"Bearer {KEY}")
    with pytest.raises(HTTPError) as refused:
        urlopen(request)
    assert refused.value.code == 422
    assert json.load(refused.value)["error"].startswith(query.partition("=")[0])


@pytest.mark.interop
@pytest.mark.slow
def test_a_strangers_fuzzer_finds_nothing_that_the_document_does_not_say(room: ServedRoom) -> None:
    schema = schemathesis.openapi.from_url(f"{room.address}/api/v1/openapi.json")
    operations = [result.ok() for result in schema.get_all_operations()]
    assert len(operations) == 31
    for operation in operations:
        fuzz(operation, room.address, HOOK_KEY if "webhook" in operation.path else KEY)


def fuzz(operation: Any, address: str, key: str) -> None:
    @settings(
        max_examples=12, deadline=None, suppress_health_check=list(HealthCheck), database=None
    )
    @given(case=operation.as_strategy())
    def asked(case: Any) -> None:
        case.call_and_validate(
            base_url=address,
            headers={"Authorization": f"Bearer {key}"},
            excluded_checks=[positive_data_acceptance],  # no schema says which states exist
            timeout=10,
        )

    asked()
