"""Moving the drone by hand: from a browser's message to an order on the bus, or why not."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from dataclasses import replace
from typing import Any

import pytest
import pytest_asyncio
from fake_room import example_room

from housefly.messages import DroneStatus, OrderKind, Phase
from housefly.web.control.orders import LATE_MAX

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]

NUDGED = replace(example_room(), limits={**example_room().limits, "nudge_speed": 0.4})
EAST = [0.4, 0.0, 0.0]


@pytest_asyncio.fixture(loop_scope="session")
async def console(loopback: str, serving: Callable[..., Any]) -> AsyncIterator[Any]:
    """Yield a console whose site lets a person move the drone by hand; it hovers."""
    async with serving(loopback, view=NUDGED) as served:
        served.pilot.status, served.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
        yield served


async def in_control(one: Any, console: Any) -> None:
    await one.hear("room")
    await one.hear("state")
    await one.say(type="lease", id=1, action="take", held=True)
    await one.hear("accepted", id=1)


def nudges(console: Any) -> list[Any]:
    return [order for order in console.pilot.orders if order.kind is OrderKind.NUDGE]


async def test_a_nudge_becomes_an_order_of_now_and_moves_the_drone(
    console: Any, until: Any
) -> None:
    async with console.talk(await console.session(), name="Anna") as one:
        await in_control(one, console)
        x = console.pilot.position[0]
        for n in range(5):
            await one.say(type="nudge", id=10 + n, velocity=EAST, sent=float(n))
            await one.hear("accepted", id=10 + n)
        order = nudges(console)[-1]
        assert order.velocity == (0.4, 0.0, 0.0) and order.sender == "Anna"
        assert abs(console.pilot.clock.now() - order.issued_at) < LATE_MAX
        await until(lambda: console.pilot.position[0] > x + 0.02)


async def test_a_nudge_that_the_line_held_up_is_nothing(console: Any) -> None:
    async with console.talk(await console.session(), name="Anna") as one:
        await in_control(one, console)
        await one.say(type="ping", sent=50.0)
        await one.hear("pong")
        await one.say(type="nudge", id=3, velocity=EAST, sent=49.0)
        assert "late" in (await one.hear("refused", id=3))["reason"]
        assert nudges(console) == []


async def test_who_watches_moves_nothing(console: Any) -> None:
    cookie = await console.session()
    async with (
        console.talk(cookie, "the-pilots-tab", "Anna") as pilot,
        console.talk(cookie, "a-watchers-tab", "Ben") as watcher,
    ):
        await in_control(pilot, console)
        await watcher.hear("state")
        await watcher.say(type="nudge", id=4, velocity=EAST, sent=0.0)
        assert "Anna has control" in (await watcher.hear("refused", id=4))["reason"]
        assert nudges(console) == []


@pytest.mark.parametrize(
    ("status", "phase", "words"),
    [
        (DroneStatus.LANDED, Phase.IDLE, "on the ground"),
        (DroneStatus.FLYING, Phase.OUTBOUND, "press Hover first"),
    ],
)
async def test_only_a_drone_that_holds_its_place_is_moved(
    console: Any, status: DroneStatus, phase: Phase, words: str
) -> None:
    async with console.talk(await console.session(), name="Anna") as one:
        await in_control(one, console)
        console.pilot.status, console.pilot.phase = status, phase
        while not any(words in told for told in await objections(one)):
            pass
        await one.say(type="nudge", id=5, velocity=EAST, sent=0.0)
        assert words in (await one.hear("refused", id=5))["reason"]
        assert nudges(console) == []


async def test_a_generic_order_is_no_way_around(console: Any) -> None:
    async with console.talk(await console.session(), name="Anna") as one:
        await in_control(one, console)
        await one.say(type="order", id=6, order="nudge")
        assert "nudges" in (await one.hear("refused", id=6))["reason"]


async def test_it_is_off_where_the_site_does_not_allow_it(
    loopback: str, serving: Callable[..., Any]
) -> None:
    async with serving(loopback) as console:
        console.pilot.status, console.pilot.phase = DroneStatus.FLYING, Phase.HOLDING
        async with console.talk(await console.session(), name="Anna") as one:
            await in_control(one, console)
            await one.say(type="nudge", id=7, velocity=EAST, sent=0.0)
            assert "switched off" in (await one.hear("refused", id=7))["reason"]
            assert nudges(console) == []


async def objections(one: Any) -> list[str]:
    """Return what the next verdict has against moving by hand."""
    verdict = await one.hear("verdict")
    return [told["words"] for told in verdict["orders"] if told["order"] == "nudge"]
