"""What the console does with messages, over real sockets and with a fake pilot."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import replace
from typing import Any

import pytest
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed

from housefly.bus.topics import DroneTopics
from housefly.messages import DroneStatus, OrderKind, Phase, PilotStep, Severity

TOPICS = DroneTopics()

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]


def kinds(console: Any) -> list[OrderKind]:
    return [order.kind for order in console.pilot.orders]


async def test_the_first_viewer_has_control_and_sees_room_state_and_link(console: Any) -> None:
    async with console.talk(await console.session(), name="Anna") as one:
        assert (await one.hear("welcome"))["you"] == 1
        assert (await one.hear("viewers", pilot=1))["viewers"] == [{"id": 1, "name": "Anna"}]
        assert (await one.hear("room"))["room"]["site"] == "Rehearsal"
        state = await one.hear("state")
        assert state["position"] == [1.0, 1.0, 0.0] and state["status"] == "landed"
        assert (await one.hear("link"))["link"]["tracking_rate_hz"] == 100.0


async def test_an_order_of_the_pilot_reaches_the_bus_and_the_log(console: Any) -> None:
    async with console.talk(await console.session(), name="Anna") as one:
        await one.hear("room")
        await one.hear("state")  # an order needs a pilot that is heard
        await one.say(type="order", id=7, order="service", place="entrance")
        await one.hear("accepted", id=7)
        order = console.pilot.orders[-1]
        assert (order.kind, order.place, order.sender) == (OrderKind.SERVICE, "entrance", "Anna")
        news = await one.hear("events")
        assert news["events"][0]["text"] == "service entrance by Anna"


async def test_a_path_is_previewed(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        await one.say(type="plan", id=1, place="entrance")
        answer = (await one.hear("plan", id=1))["answer"]
        assert answer["path"]["length"] > 5 and answer["path"]["waypoints"][-1] == [6.4, 1.0]
        await one.say(type="plan", id=2, goal=[3.4, 2.0])
        answer = (await one.hear("plan", id=2))["answer"]
        assert answer["path"] is None and answer["reason"] and answer["suggestion"]


async def test_a_watcher_may_stop_and_land_and_nothing_else(console: Any, until: Any) -> None:
    cookie = await console.session()
    async with (
        console.talk(cookie, "the-pilots-tab", "Anna") as pilot,
        console.talk(cookie, "a-watchers-tab", "Ben") as watcher,
    ):
        await pilot.hear("viewers", pilot=1)
        await watcher.hear("room")
        for number, order in enumerate(["take_off", "hover", "home", "resume", "cut", "reset"], 1):
            await watcher.say(type="order", id=number, order=order)
            assert "Anna has control" in (await watcher.hear("refused", id=number))["reason"]
        await watcher.say(type="order", id=10, order="go", goal=[2, 2])
        await watcher.hear("refused", id=10)
        assert kinds(console) == []
        await watcher.say(type="order", id=11, order="land")
        await watcher.hear("accepted", id=11)
        await watcher.say(type="stop", id=12)
        await watcher.hear("accepted", id=12)
        assert len(console.stops) == 1
        await until(lambda: kinds(console) == [OrderKind.LAND, OrderKind.STOP])


async def test_stop_works_before_a_viewer_has_said_who_it_is(console: Any) -> None:
    cookie = console.proved({"Cookie": await console.session()})
    async with connect(
        f"ws://{console.host}:{console.port}/socket",
        origin=console.origin,
        additional_headers=cookie,
    ) as socket:
        await socket.send('{"type":"stop","id":1}')
        assert json.loads(await asyncio.wait_for(socket.recv(), 5)) == {"id": 1, "type": "accepted"}
        assert len(console.stops) == 1


UNNAMED: list[dict[str, object]] = [
    {"type": "ping", "sent": 1.0},
    {"type": "lease", "id": 1, "action": "take", "held": True},
    {"type": "order", "id": 1, "order": "take_off"},
    {"type": "nudge", "id": 1, "velocity": [0.1, 0.0, 0.0], "sent": 1.0},
    {"type": "plan", "id": 1, "place": "entrance"},
    {"type": "invite", "id": 1},
]


@asynccontextmanager
async def without_hello(console: Any, cookie: str) -> AsyncIterator[Any]:
    """Open a socket and say nothing."""
    async with connect(
        f"ws://{console.host}:{console.port}/socket",
        origin=console.origin,
        additional_headers=console.proved({"Cookie": cookie}),
    ) as socket:
        yield socket


async def test_who_has_not_said_who_it_is_may_stop_and_land_and_nothing_else(console: Any) -> None:
    async with without_hello(console, await console.session()) as socket:
        for message in UNNAMED:
            await socket.send(json.dumps(message))
            told = json.loads(await asyncio.wait_for(socket.recv(), 5))
            assert (told["type"], told["reason"]) == ("refused", ["say hello first"]), message
        await socket.send('{"type":"order","id":2,"order":"land"}')
        assert json.loads(await asyncio.wait_for(socket.recv(), 5))["type"] == "accepted"
    assert kinds(console) == [OrderKind.LAND]


async def test_two_that_have_not_said_who_they_are_do_not_have_control_at_once(
    console: Any,
) -> None:
    cookie = await console.session()
    async with without_hello(console, cookie) as one, without_hello(console, cookie) as other:
        await one.send('{"type":"lease","id":1,"action":"take","held":true}')
        await asyncio.wait_for(one.recv(), 5)
        await asyncio.sleep(0.1)
        await other.send('{"type":"order","id":2,"order":"hover"}')
        assert json.loads(await asyncio.wait_for(other.recv(), 5))["type"] == "refused"
    assert kinds(console) == []


async def test_control_changes_hands_by_name(console: Any) -> None:
    cookie = await console.session()
    async with (
        console.talk(cookie, "tab-of-anna", "Anna") as anna,
        console.talk(cookie, "tab-of-ben", "Ben") as ben,
    ):
        await anna.hear("viewers", viewers=[{"id": 1, "name": "Anna"}, {"id": 2, "name": "Ben"}])
        await anna.say(type="lease", id=1, action="give", to=2)
        await ben.hear("viewers", pilot=2)
        await ben.say(type="lease", id=1, action="release")
        await anna.hear("viewers", pilot=None)
        await anna.say(type="order", id=2, order="take_off")
        assert "take it first" in (await anna.hear("refused", id=2))["reason"]
        await anna.say(type="lease", id=3, action="take")
        await ben.hear("viewers", pilot=1)


@asynccontextmanager
async def here(talk: Any) -> AsyncIterator[None]:
    """Give signs of life as a page does: who is silent for three seconds loses control."""

    async def beat() -> None:
        while True:
            await talk.say(type="ping", sent=0.0)
            await asyncio.sleep(0.5)

    beating = asyncio.create_task(beat())
    try:
        yield
    finally:
        beating.cancel()
        await asyncio.gather(beating, return_exceptions=True)


async def test_taking_over_in_flight_needs_the_hold(console: Any) -> None:
    cookie = await console.session()
    async with (
        console.talk(cookie, "tab-of-anna", "Anna") as anna,
        console.talk(cookie, "tab-of-ben", "Ben") as ben,
    ):
        await anna.hear("room")
        await anna.hear("state")
        await anna.say(type="order", id=1, order="take_off")
        async with here(anna):
            await ben.hear("state", status="flying")
            await ben.say(type="lease", id=1, action="take")
            assert "hold" in (await ben.hear("refused", id=1))["reason"]
        await ben.say(type="lease", id=2, action="take", held=True)
        await anna.hear("viewers", pilot=2)


async def test_control_survives_a_reconnect_of_the_same_tab(console: Any) -> None:
    cookie = await console.session()
    async with console.talk(cookie, "tab-of-anna", "Anna") as anna:
        await anna.hear("viewers", pilot=1)
    async with console.talk(cookie, "tab-of-anna", "Anna") as anna:
        assert (await anna.hear("welcome"))["you"] == 1
        await anna.hear("viewers", pilot=1)


@pytest.mark.slow
async def test_control_is_lost_three_seconds_after_its_holder_left(console: Any) -> None:
    cookie = await console.session()
    async with console.talk(cookie, "tab-of-ben", "Ben") as ben:
        await ben.say(type="lease", id=1, action="release")
        async with console.talk(cookie, "tab-of-anna", "Anna") as anna:
            await anna.say(type="lease", id=1, action="take")
            await ben.hear("viewers", pilot=2)
        await ben.hear("viewers", pilot=2, viewers=[{"id": 1, "name": "Ben"}])
        await ben.hear("viewers", pilot=None)


async def test_the_same_tab_opened_twice_keeps_the_newer_socket(console: Any) -> None:
    cookie = await console.session()
    async with (
        console.talk(cookie, "tab-of-anna") as older,
        console.talk(cookie, "tab-of-anna") as newer,
    ):
        await newer.hear("welcome", you=1)
        await asyncio.wait_for(older.socket.wait_closed(), 5)
        assert older.socket.close_code == 4001


async def test_a_message_that_makes_no_sense_gets_a_reason_and_harms_nobody(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        await one.hear("welcome")
        for text in (
            "",
            "no json",
            '{"type":"order","id":1,"order":"explode"}',
            '{"type":"hello","tab":"12345678","name":"\\ud800"}',
        ):
            await one.socket.send(text)
            assert (await one.hear("refused", id=0))["reason"]
        await one.socket.send(b"\xff\xfe")
        assert (await one.hear("refused", id=0))["reason"]
        await one.say(type="ping", sent=1.5)
        assert (await one.hear("pong"))["sent"] == 1.5


async def test_a_flood_is_cut_down_but_stop_still_passes(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        await one.hear("room")
        for number in range(1, 101):
            await one.say(type="order", id=number, order="hover")
        await one.say(type="stop", id=500)
        await one.hear("accepted", id=500)
        assert len(console.stops) == 1
        passed = [message["id"] for message in one.heard if message["type"] == "accepted"]
        assert len(passed) <= 45
        assert any("too many" in message.get("reason", "") for message in one.heard)


async def test_a_socket_that_will_not_stop_flooding_is_closed(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        for number in range(1, 400):
            await one.say(type="plan", id=number, place="entrance")
        async with asyncio.timeout(5):
            with pytest.raises(ConnectionClosed):
                while True:
                    await one.socket.recv()
        assert one.socket.close_code == 1008


async def test_events_before_and_after_a_viewer_came_all_arrive(console: Any) -> None:
    console.pilot.add_event(Severity.INFO, "going_on", "before")
    await asyncio.sleep(0.1)
    async with console.talk(await console.session()) as one:
        welcome = await one.hear("welcome")
        assert [event["text"] for event in welcome["events"]] == ["before"]
        for number in range(200):
            console.pilot.add_event(Severity.INFO, "going_on", f"after {number}")
        texts: list[str] = []
        while len(texts) < 200:
            texts += [event["text"] for event in (await one.hear("events"))["events"]]
        assert texts == [f"after {number}" for number in range(200)]


async def test_a_viewer_that_does_not_read_slows_nobody(console: Any) -> None:
    cookie = await console.session()
    async with (
        console.talk(cookie, "a-viewer-asleep") as asleep,
        console.talk(cookie, "a-viewer-awake") as awake,
    ):
        asleep.socket.transport.pause_reading()
        before = (await awake.hear("state"))["sequence"]
        for _ in range(20):
            after = (await awake.hear("state"))["sequence"]
        assert after > before
        await awake.say(type="stop", id=1)
        await awake.hear("accepted", id=1)


async def test_orders_are_refused_when_the_pilot_is_silent_but_stop_and_land_are_not(
    console: Any, until: Any
) -> None:
    async with console.talk(await console.session()) as one:
        await one.hear("room")
        console.pilot.publishing = False
        await asyncio.sleep(2.1)
        await one.say(type="ping", sent=0.0)
        await one.say(type="order", id=1, order="take_off")
        assert "no contact" in (await one.hear("refused", id=1))["reason"]
        await one.say(type="order", id=2, order="land")
        await one.hear("accepted", id=2)
        await one.say(type="stop", id=3)
        await one.hear("accepted", id=3)
        await until(lambda: kinds(console) == [OrderKind.LAND, OrderKind.STOP])


async def test_states_come_at_most_twenty_times_a_second(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        first = await one.hear("state")
        for _ in range(20):
            last = await one.hear("state")
        assert last["heard_at"] - first["heard_at"] > 0.9


async def test_the_room_is_asked_again_when_a_new_pilot_came(console: Any) -> None:
    async with console.talk(await console.session()) as one:
        await one.hear("room")
        await one.hear("state")
        console.pilot.room = replace(console.pilot.room, site="Another room")
        console.pilot.sequence = 0
        message = await one.hear("room")
        assert json.dumps(message).count("Another room") == 1


async def test_who_is_here_may_change_its_name_but_not_become_another_tab(console: Any) -> None:
    async with console.talk(await console.session(), "tab-of-anna", "Anna") as one:
        await one.hear("viewers", viewers=[{"id": 1, "name": "Anna"}])
        await one.say(type="hello", tab="tab-of-anna", name="Anna Two")
        await one.hear("viewers", viewers=[{"id": 1, "name": "Anna Two"}])
        await one.say(type="hello", tab="another-tab", name="Ben")
        assert "another tab" in (await one.hear("refused", id=0))["reason"]
        await one.say(type="hello", tab="tab-of-anna", name="Anna")
        await one.hear("viewers", viewers=[{"id": 1, "name": "Anna"}])


async def test_a_new_pilot_that_does_not_hear_the_drone_yet_does_not_put_it_on_the_ground(
    console: Any,
) -> None:
    steps: list[PilotStep] = []
    console.bus.subscribe(TOPICS.step, steps.append)
    cookie = await console.session()
    async with (
        console.talk(cookie, "tab-of-anna", "Anna") as anna,
        console.talk(cookie, "tab-of-ben", "Ben") as ben,
    ):
        await anna.hear("verdict", pilot=1)
        console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.OUTBOUND
        await anna.hear("verdict", airborne=True)
        console.pilot.publishing = False
        unheard = replace(steps[-1].inputs, telemetry=None)
        idle = replace(steps[-1].outputs, phase=Phase.IDLE, goal_name="")
        console.bus.publish(TOPICS.step, PilotStep(1, steps[-1].now, unheard, idle))
        told = await ben.hear("verdict", airborne=None, may_be_airborne=True)
        assert told["headline"] == "No contact with the drone"
        assert told["detail"].endswith("it was flying to its goal")
        assert "in the air when it was last heard" in told["banner"]
        assert "in the air when it was last heard" in told["if_contact_lost"]
        await ben.say(type="lease", id=1, action="take")
        assert "hold" in (await ben.hear("refused", id=1))["reason"]
        console.pilot.status, console.pilot.phase = DroneStatus.LANDED, Phase.IDLE
        console.pilot.publishing = True
        while (await ben.hear("verdict", airborne=False))["at"] < told["at"]:
            pass
        await ben.say(type="lease", id=2, action="take")
        await ben.hear("accepted", id=2)


async def test_control_of_a_take_off_whose_drone_is_silent_is_not_taken_without_the_hold(
    console: Any,
) -> None:
    cookie = await console.session()
    async with (
        console.talk(cookie, "tab-of-anna", "Anna") as anna,
        console.talk(cookie, "tab-of-ben", "Ben") as ben,
    ):
        await anna.hear("verdict", pilot=1)
        console.pilot.phase, console.pilot.telemetry_age = Phase.TAKING_OFF, 5.0
        await ben.hear("verdict", airborne=None, may_be_airborne=True)
        await ben.say(type="lease", id=1, action="take")
        assert "hold" in (await ben.hear("refused", id=1))["reason"]
