"""The hub's own line to programs of the same machine: real sockets, and whoever has no key."""

from __future__ import annotations

import json
import socket
import tempfile
from collections.abc import Iterator
from contextlib import closing
from math import inf, nan
from pathlib import Path

import pytest

from housefly.errors import LinkError, ThingError, WireError
from housefly.hub.api.json import question_to_json
from housefly.hub.api.questions import WhereQuestion
from housefly.hub.client.hub_connection import HubConnection
from housefly.hub.client.room_client import RoomClient
from housefly.hub.query_server import MAX_CONNECTIONS, MAX_QUESTION_SIZE, QueryServer

pytestmark = pytest.mark.wire

KEY = "the-key-of-this-run"


@pytest.fixture
def place() -> Iterator[Path]:
    with tempfile.TemporaryDirectory() as folder:
        yield Path(folder) / "room"


@pytest.fixture
def served(place: Path) -> Iterator[Path]:
    with closing(QueryServer(lambda text: json.dumps({"asked": json.loads(text)}), KEY, place)):
        yield place


def said(served: Path, *lines: bytes) -> bytes:
    """Say lines and return all that is answered until the other side hangs up."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as line:
        line.settimeout(10.0)
        line.connect(str(served))
        for text in lines:
            line.sendall(text)
        line.shutdown(socket.SHUT_WR)
        return b"".join(iter(lambda: line.recv(65536), b""))


def test_every_question_has_its_answer_in_order(served: Path) -> None:
    line = HubConnection(str(served), KEY, 5.0)
    for number in range(50):
        assert json.loads(line.ask(json.dumps(number))) == {"asked": number}
    line.close()


@pytest.mark.parametrize(
    "first", [b"another key\n", b"\n", b"", KEY.encode()[:-1] + b"\n", b"x" * 200_000]
)
def test_without_the_key_nothing_is_answered(served: Path, first: bytes) -> None:
    try:
        answer = said(served, first, b'"a question"\n')
    except OSError:
        return  # it hung up while we were still talking
    assert b"asked" not in answer
    assert not answer or b"show the key" in answer


def test_a_question_that_never_ends_is_refused(served: Path) -> None:
    try:
        answer = said(served, KEY.encode() + b"\n", b"x" * (MAX_QUESTION_SIZE + 10))
    except OSError:
        return
    assert b"at most" in answer and b"asked" not in answer


def test_more_programs_than_there_are_seats_are_turned_away_and_the_others_go_on(
    served: Path,
) -> None:
    seated = [HubConnection(str(served), KEY, 5.0) for _ in range(MAX_CONNECTIONS)]
    for line in seated:
        line.ask("1")
    with pytest.raises(OSError):
        HubConnection(str(served), KEY, 5.0).ask("2")
    assert json.loads(seated[0].ask("3")) == {"asked": 3}
    for line in seated:
        line.close()


def test_a_line_that_was_cut_is_tried_anew(place: Path) -> None:
    first = QueryServer(lambda text: '"first"', KEY, place)
    line = HubConnection(str(place), KEY, 5.0)
    assert line.ask("1") == '"first"\n'
    first.close()
    with pytest.raises(OSError):
        line.ask("2")
    with closing(QueryServer(lambda text: '"second"', KEY, place)):
        assert line.ask("3") == '"second"\n'
    line.close()


def test_a_socket_that_a_killed_hub_left_behind_is_replaced(place: Path) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as left:
        left.bind(str(place))
    with closing(QueryServer(lambda text: '"anew"', KEY, place)):
        assert HubConnection(str(place), KEY, 5.0).ask("1") == '"anew"\n'


def test_a_folder_that_others_may_enter_is_refused(place: Path) -> None:
    place.parent.chmod(0o755)
    with pytest.raises(LinkError, match="mode 0700"):
        QueryServer(lambda text: text, KEY, place)


def test_the_hub_and_the_client_speak_the_same(house, place: Path) -> None:
    house.see("cup", 60.0, (1.0, 2.0, 3.0))

    def answer(text: str) -> str:
        from housefly.hub.api.json import answer_to_json, question_from_json, refusal_to_json

        try:
            return answer_to_json(house.answers.answer(question_from_json(text)))
        except (ThingError, WireError) as error:
            return refusal_to_json(error)

    with (
        closing(QueryServer(answer, KEY, place)),
        RoomClient("http://127.0.0.1:9", KEY, socket=str(place)) as room,
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
        RoomClient("http://127.0.0.1:9", KEY, socket=str(place)) as room,
        pytest.raises(LinkError, match="does not answer"),
    ):
        room.where("cup")
    assert question_to_json(WhereQuestion("cup")).count("\n") == 0
