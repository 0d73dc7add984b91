"""What a viewer of the live view gets, and what nobody gets."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from typing import Any

import pytest
from websockets.exceptions import InvalidStatus

from housefly.config.foxglove import APP_ORIGIN
from housefly.config.house_mode import HouseMode

pytestmark = pytest.mark.wire

Open = Callable[..., Any]


async def test_who_comes_late_gets_the_map_the_walls_and_the_path_that_came_before(
    live: Open,
) -> None:
    room = live()
    latched = ["/drone/map", "/room/furniture", "/drone/path"]
    async with room.watch() as early, room.watch() as late:
        await early.subscribe(*latched)
        async with room.talking():
            await early.first_of(latched)
        await late.subscribe(*latched)
        assert set(await late.first_of(latched)) == set(latched)


async def test_nothing_of_the_bus_is_heard_while_nobody_watches(live: Open) -> None:
    room = live()
    async with room.watch() as viewer:
        assert heard_by(room) == 0
        await viewer.subscribe("/drone/odom")
        async with room.talking():
            await viewer.first_of(["/drone/odom"])
        assert heard_by(room) == 1
        await viewer.unsubscribe("/drone/odom")
        async with asyncio.timeout(10.0):
            while heard_by(room):
                await asyncio.sleep(0.02)


def heard_by(room: Any) -> int:
    """Return how many bus topics the view listens to."""
    return sum(len(room.talker.bus._topics.handlers(key)) for key in room.talker.keys)


async def test_the_server_offers_no_way_in_and_takes_nothing_that_is_sent(live: Open) -> None:
    room, orders = live(), []
    room.talker.bus.subscribe(room.talker.orders, orders.append)
    async with room.watch() as viewer:
        assert viewer.server["capabilities"] == []
        channel = {"id": 1, "topic": "/order", "encoding": "json", "schemaName": "Order"}
        await viewer.socket.send(json.dumps({"op": "advertise", "channels": [channel]}))
        await viewer.socket.send(b"\x01\x01\x00\x00\x00{}")
        await viewer.socket.send(json.dumps({"op": "setParameters", "parameters": []}))
        await viewer.subscribe("/room/furniture")
        assert await viewer.first_of(["/room/furniture"])
    assert orders == []


@pytest.mark.parametrize("origin", ["https://example.org", "null", f"{APP_ORIGIN}.example.org"])
async def test_a_page_that_the_site_does_not_name_gets_nothing(live: Open, origin: str) -> None:
    with pytest.raises(InvalidStatus) as refused:
        async with live().watch(origin=origin):
            pass
    assert refused.value.response.status_code == 403


@pytest.mark.parametrize("origin", [None, APP_ORIGIN])
async def test_a_program_of_this_machine_and_the_app_may_look(
    live: Open, origin: str | None
) -> None:
    async with live().watch(origin=origin) as viewer:
        assert viewer.server["name"] == "Housefly B-sen"


async def test_the_camera_shows_the_pictures_of_the_drone(live: Open) -> None:
    room = live()
    async with room.watch() as viewer, room.talking():
        await viewer.subscribe("/drone/camera")
        assert (await viewer.first_of(["/drone/camera"]))["/drone/camera"].value.format == "h264"


async def test_the_camera_shows_nothing_in_mode_privacy(live: Open) -> None:
    room = live()
    room.talker.mode = HouseMode.PRIVACY
    async with room.watch() as viewer, room.talking():
        await viewer.subscribe("/drone/camera", "/tasks")
        assert {(await viewer.next()).topic for _ in range(30)} == {"/tasks"}


async def test_who_is_slow_loses_messages_and_holds_nobody_up(live: Open) -> None:
    room, channel, count = live(tasks__enabled=False), "/drone/camera", 400
    async with room.watch() as slow, room.watch() as quick:
        for viewer in (slow, quick):
            await viewer.subscribe(channel)
        async with room.talking():
            await quick.first_of([channel])
            await slow.first_of([channel])
        for number in range(count):
            room.talker.tell_picture(bytes(200_000) + number.to_bytes(4, "big"))
        for viewer in (quick, slow):
            numbers: list[int] = []
            while count - 1 not in numbers:
                picture = (await viewer.next()).value.data
                numbers.append(int.from_bytes(bytes(picture[-4:]), "big"))
            assert len(numbers) < count
            assert numbers[-1] == count - 1


async def test_each_sender_of_a_message_keeps_the_time_of_its_capture(live: Open) -> None:
    room = live()
    async with room.watch() as viewer, room.talking():
        await viewer.subscribe("/drone/odom", "/sighting/visitor", "/drone/state")
        first = await viewer.first_of(["/drone/odom", "/sighting/visitor", "/drone/state"])
    for topic in ("/drone/odom", "/sighting/visitor"):
        stamp = first[topic].value.header.stamp
        assert stamp.sec + stamp.nanosec / 1e9 == pytest.approx(first[topic].at, abs=0.1)
    assert first["/drone/state"].value["at"] == pytest.approx(first["/drone/state"].at, abs=1e-3)
