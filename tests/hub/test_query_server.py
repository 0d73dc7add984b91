"""The hub's own line to programs of the same machine: real sockets, and whoever has no key."""

from __future__ import annotations

import json
import socket
from collections.abc import Iterator
from contextlib import closing
from math import inf, nan

import pytest

from housefly.errors import LinkError, ThingError, WireError
from housefly.hub.api.json import question_to_json
from housefly.hub.api.questions import WhereQuestion
from housefly.hub.client.loopback import LoopbackConnection
from housefly.hub.client.room_client import RoomClient
from housefly.hub.query_server import MAX_CONNECTIONS, MAX_QUESTION_SIZE, QueryServer

pytestmark = pytest.mark.wire

KEY = "the-key-of-this-run"


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@pytest.fixture
def port() -> Iterator[int]:
    number = free_port()
    with closing(QueryServer(lambda text: json.dumps({"asked": json.loads(text)}), KEY, number)):
        yield number


def said(port: int, *lines: bytes) -> bytes:
    """Say lines and return all that is answered until the other side hangs up."""
    with socket.create_connection(("127.0.0.1", port), 10.0) as line:
        for text in lines:
            line.sendall(text)
        line.shutdown(socket.SHUT_WR)
        return b"".join(iter(lambda: line.recv(65536), b""))


def test_every_question_has_its_answer_in_order(port: int) -> None:
    line = LoopbackConnection(port, KEY, 5.0)
    for number in range(50):
        assert json.loads(line.ask(json.dumps(number))) == {"asked": number}
    line.close()


@pytest.mark.parametrize(
    "first", [b"another key\n", b"\n", b"", KEY.encode()[:-1] + b"\n", b"x" * 200_000]
)
def test_without_the_key_nothing_is_answered(port: int, first: bytes) -> None:
    try:
        answer = said(port, first, b'"a question"\n')
    except OSError:
        return  # it hung up while we were still talking
    assert b"asked" not in answer
    assert not answer or b"show the key" in answer


def test_a_question_that_never_ends_is_refused(port: int) -> None:
    try:
        answer = said(port, KEY.encode() + b"\n", b"x" * (MAX_QUESTION_SIZE + 10))
    except OSError:
        return
    assert b"at most" in answer and b"asked" not in answer


def test_more_programs_than_there_are_seats_are_turned_away_and_the_others_go_on(port: int) -> None:
    seated = [LoopbackConnection(port, KEY, 5.0) for _ in range(MAX_CONNECTIONS)]
    for line in seated:
        line.ask("1")
    with pytest.raises(OSError):
        LoopbackConnection(port, KEY, 5.0).ask("2")
    assert json.loads(seated[0].ask("3")) == {"asked": 3}
    for line in seated:
        line.close()


def test_a_line_that_was_cut_is_tried_anew() -> None:
    number = free_port()
    first = QueryServer(lambda text: '"first"', KEY, number)
    line = LoopbackConnection(number, KEY, 5.0)
    assert line.ask("1") == '"first"\n'
    first.close()
    with pytest.raises(OSError):
        line.ask("2")
    with closing(QueryServer(lambda text: '"second"', KEY, number)):
        assert line.ask("3") == '"second"\n'
    line.close()


def test_a_port_that_is_taken_is_said_in_words(port: int) -> None:
    with pytest.raises(LinkError, match=f"127.0.0.1:{port}: Address already in use"):
        QueryServer(lambda text: text, KEY, port)


def test_the_hub_and_the_client_speak_the_same(house) -> None:
    number = free_port()
    house.see("cup", 60.0, (1.0, 2.0, 3.0))

    def answer(text: str) -> str:
        from housefly.hub.api.json import answer_to_json, question_from_json, refusal_to_json

        try:
            return answer_to_json(house.answers.answer(question_from_json(text)))
        except (ThingError, WireError) as error:
            return refusal_to_json(error)

    with (
        closing(QueryServer(answer, KEY, number)),
        RoomClient("http://127.0.0.1:9", KEY, port=number) as room,
    ):
        assert room.where("cup").position == (1.0, 2.0, 3.0)
        with pytest.raises(ThingError, match="nothing is called 'cap'"):
            room.where("cap")
        with pytest.raises(WireError, match="radius"):
            room.near("cup", -1.0)
        for number in (nan, inf):
            with pytest.raises(WireError, match="finite"):
                room.near("cup", number)
        assert room.where("cup").position == (1.0, 2.0, 3.0)
    with (
        RoomClient("http://127.0.0.1:9", KEY, port=number) as room,
        pytest.raises(LinkError, match="does not answer"),
    ):
        room.where("cup")
    assert question_to_json(WhereQuestion("cup")).count("\n") == 0
