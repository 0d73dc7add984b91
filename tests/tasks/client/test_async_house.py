"""The asyncio client over a real console: questions, wishes, STOP, news through a restart."""

from __future__ import annotations

import asyncio
import inspect
import os
import threading
import time
from collections.abc import Iterator
from contextlib import aclosing, suppress
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from ros_stage import AnsweringPilot
from served_room import KEY, ServedRoom

import housefly
from housefly.bus.endpoint import endpoint_in
from housefly.errors import LinkError, TaskError, ThingError, WireError
from housefly.hub.api.answers import EventAnswer, News
from housefly.hub.client.async_news import SeenEvents
from housefly.hub.client.async_room_queries import AsyncRoomQueries
from housefly.hub.client.console_address import console_address_of
from housefly.hub.client.discovery import RoomAddress, announced
from housefly.hub.client.room_queries import RoomQueries
from housefly.messages import RoomEvent
from housefly.tasks.api.values import TaskStage
from housefly.tasks.client.async_task_queries import AsyncTaskQueries
from housefly.tasks.client.task_queries import TaskQueries

pytestmark = pytest.mark.wire


@pytest.fixture
def room(loopback: str, tmp_path: Path) -> Iterator[ServedRoom]:
    made = ServedRoom(loopback, tmp_path)
    yield made
    made.close()


@pytest.fixture
def house(room: ServedRoom) -> housefly.AsyncHouse:
    return housefly.AsyncHouse(address=room.address, key=KEY, by="a test")


def signatures(kind: type) -> dict[str, inspect.Signature]:
    return {
        name: inspect.signature(one)
        for name, one in vars(kind).items()
        if callable(one) and not name.startswith("_")
    }


@pytest.mark.parametrize(
    ("sync", "asynchronous"), [(RoomQueries, AsyncRoomQueries), (TaskQueries, AsyncTaskQueries)]
)
def test_both_clients_have_the_same_methods(sync: type, asynchronous: type) -> None:
    assert signatures(sync) == signatures(asynchronous)
    assert all(inspect.iscoroutinefunction(getattr(asynchronous, one)) for one in signatures(sync))


async def test_the_room_is_asked(room: ServedRoom, house: housefly.AsyncHouse) -> None:
    room.memory.add(RoomEvent("object taken", "cup", time.time(), "situations", "person-1"))
    where, things, events = await asyncio.gather(
        house.where("cup"), house.things("furniture"), house.events(thing="cup")
    )
    assert where.inside == ("cabinet",)
    assert [one.thing for one in things] == ["cabinet"]
    assert [one.kind for one in events] == ["object taken"]
    assert (await house.trajectory("cup", 0.0)).shape == (0, 4)
    with pytest.raises(ThingError, match="cup"):
        await house.where("cupp")
    with pytest.raises(WireError, match="radius"):
        await house.near("cup", -1.0)


async def test_tasks_are_asked_for_awaited_and_ended(
    room: ServedRoom, house: housefly.AsyncHouse
) -> None:
    task = await house.request("look", what="sofa")
    assert (task.service, task.asked_by) == ("look", "a test")
    ending = asyncio.create_task(house.ended(task.id))
    await asyncio.sleep(0.1)
    assert not ending.done()
    room.tasks.finish(task.id, "It is there.")
    assert (await ending).words == "It is there."
    other = await house.request("visitor")
    assert (await house.cancel(other.id))[0].state is TaskStage.CANCELLED
    assert "cabinet" in str((await house.say("where is the cup")).words)
    assert (await house.rehearse("visitor")).may_fly
    with pytest.raises(TaskError, match="no service"):
        await house.request("dance")
    with pytest.raises(TaskError, match="no task"):
        await house.ended(77)


async def test_stop_and_land_pass_with_the_key(
    room: ServedRoom, house: housefly.AsyncHouse
) -> None:
    await house.stop()
    assert len(room.stops) == 1
    await house.stop("drone")
    await house.land("drone")
    stranger = housefly.AsyncHouse(address=room.address, key="wrong")
    for wish in (stranger.stop, stranger.land):
        with pytest.raises(LinkError, match="does not take it"):
            await wish()
    with pytest.raises(LinkError, match="no drone"):
        await house.land("other")


async def test_nobody_there_and_no_key_are_said(room: ServedRoom) -> None:
    stranger = housefly.AsyncHouse(address=room.address, key="wrong")
    for question in (stranger.where("cup"), stranger.tasks()):
        with pytest.raises(LinkError):
            await question
    with pytest.raises(LinkError, match="let us listen"):
        await anext(stranger.news())
    gone = housefly.AsyncHouse(address=f"http://{room.host}:1", key=KEY)
    with pytest.raises(LinkError, match="does not answer"):
        await gone.where("cup")
    with pytest.raises(LinkError, match="went away"):
        await anext(gone.news())
    with pytest.raises(LinkError, match="no address"):
        housefly.AsyncHouse(address="there", key=KEY)


async def test_a_cancelled_question_leaves_no_connection(
    room: ServedRoom, house: housefly.AsyncHouse
) -> None:
    room.tasks.rehearses.clear()
    waiting = asyncio.create_task(house.rehearse("visitor"))
    await asyncio.sleep(0.2)
    waiting.cancel()
    with suppress(asyncio.CancelledError):
        await waiting
    assert waiting.cancelled()
    room.tasks.rehearses.set()
    assert (await house.where("cup")).thing == "cup"


async def test_a_console_that_never_answers_is_given_up(loopback: str) -> None:
    async def silent(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.read()
        writer.close()

    server = await asyncio.start_server(silent, loopback)
    port = server.sockets[0].getsockname()[1]
    house = housefly.AsyncHouse(address=f"http://{loopback}:{port}", key=KEY, timeout=0.2)
    with pytest.raises(LinkError, match="does not answer"):
        await house.where("cup")
    server.close()


@pytest.mark.parametrize(
    "answer", [b"", b"HTTP/1.1 200 OK\r\n\r\n\xff", b"nonsense\r\n\r\n", b"HTTP/1.1 200 OK\r\n"]
)
async def test_what_is_no_answer_is_said(loopback: str, answer: bytes) -> None:
    async def noise(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.read(10)
        writer.write(answer)
        writer.close()

    server = await asyncio.start_server(noise, loopback)
    port = server.sockets[0].getsockname()[1]
    house = housefly.AsyncHouse(address=f"http://{loopback}:{port}", key=KEY)
    with pytest.raises(LinkError):
        await house.where("cup")
    server.close()


async def test_news_begin_with_the_room_and_go_on_over_a_restart(
    room: ServedRoom, house: housefly.AsyncHouse
) -> None:
    async with aclosing(house.news()) as news:
        first = await anext(news)
        assert {one.thing for one in first.things} == {"cabinet", "cup"} and first.events == ()
        told = asyncio.create_task(anext(news))
        while not told.done():
            await asyncio.to_thread(room.move_cup, 1.0)
            await asyncio.sleep(0.02)
        assert [one.thing for one in told.result().things] == ["cup"]
        coming = asyncio.create_task(anext(news))
        await asyncio.sleep(0.1)
        await asyncio.to_thread(room.go)
        at = time.time()
        room.memory.add(RoomEvent("object taken", "cup", at, "situations", "person-1"))
        await asyncio.to_thread(room.come)
        missed = await asyncio.wait_for(coming, 30.0)
        while not missed.events:
            missed = await asyncio.wait_for(anext(news), 30.0)
        assert [one.kind for one in missed.events] == ["object taken"]


async def test_without_reconnecting_the_end_of_a_room_is_an_error(
    room: ServedRoom, house: housefly.AsyncHouse
) -> None:
    async with aclosing(house.news(reconnect=False)) as news:
        await anext(news)
        coming = asyncio.create_task(anext(news))
        await asyncio.sleep(0.1)
        await asyncio.to_thread(room.go)
        with pytest.raises(LinkError, match="went away"):
            await asyncio.wait_for(coming, 30.0)
        await asyncio.to_thread(room.come)


async def test_who_stops_listening_is_gone_from_the_console(
    room: ServedRoom, house: housefly.AsyncHouse
) -> None:
    async def listen() -> None:
        async for _ in house.news():
            pass

    for _ in range(12):  # more than the seats of one
        listening = asyncio.create_task(listen())
        await asyncio.sleep(0.15)
        listening.cancel()
        with suppress(asyncio.CancelledError):
            await listening
    assert (await anext(house.news())).things


@given(st.lists(st.lists(st.integers(0, 5), max_size=4), max_size=6))
def test_no_event_is_told_twice(rounds: list[list[int]]) -> None:
    seen, told = SeenEvents(), list[float]()
    for number, found in enumerate(rounds):
        events = tuple(EventAnswer("a", "b", one, "c", "", 1.0, {}) for one in dict.fromkeys(found))
        told += [one.at for one in seen.fresh(News(number, (), events, (), ())).events]
        assert seen.at == number
    assert sorted(told) == sorted({one for found in rounds for one in found})


async def test_steps_come_from_the_bus_and_end_with_their_reader(
    room: ServedRoom, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    folder = tmp_path / "run"
    folder.mkdir(mode=0o700)
    endpoint = endpoint_in(folder)
    place = RoomAddress("B-sen", room.address, KEY, os.getpid(), bus=endpoint)
    with (
        housefly.ZenohBus(listen=endpoint) as bus,
        AnsweringPilot(bus),
        announced(place),
    ):
        here = housefly.AsyncHouse("b-sen")
        assert (await here.where("cup")).thing == "cup"
        before = threading.active_count()
        async with aclosing(here.steps()) as steps:
            found: list[Any] = [await asyncio.wait_for(anext(steps), 30.0) for _ in range(5)]
        numbers = [one.sequence for one in found]
        assert numbers == sorted(set(numbers))
        assert threading.active_count() <= before + 1
    far = housefly.AsyncHouse(address=room.address, key=KEY)
    with pytest.raises(LinkError, match="machine where it runs"):
        far.steps()


@pytest.mark.parametrize(
    ("text", "netloc"),
    [("http://10.0.0.7:8080", "10.0.0.7:8080"), ("https://[::1]:8443/", "[::1]:8443")],
)
def test_an_address_is_taken_apart(text: str, netloc: str) -> None:
    found = console_address_of(text)
    assert found.netloc == netloc and found.is_secure is text.startswith("https")
