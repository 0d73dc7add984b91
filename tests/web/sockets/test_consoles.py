"""A room with two drones: a browser looks at one of them, STOP and landing are for all."""

from __future__ import annotations

import asyncio
import contextlib
import json
from collections.abc import AsyncIterator
from dataclasses import dataclass
from typing import Any

import pytest
import pytest_asyncio
from fake_pilot import FakePilot
from fake_room import example_room
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus

from housefly.bus.topics import DroneTopics
from housefly.config.drone import DroneConfig
from housefly.messages import OrderKind
from housefly.web.server import ConsoleDrone

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]


@dataclass
class TwoDrones:
    """A console of red and blue, and their pilots."""

    console: Any
    red: FakePilot
    blue: FakePilot
    blue_stops: list[str]

    def __post_init__(self) -> None:
        self.pilots = {"red": self.red, "blue": self.blue}

    @contextlib.asynccontextmanager
    async def page(self, cookie: str, query: str) -> AsyncIterator[Any]:
        """Open the socket of a page."""
        async with connect(
            f"{self.console.origin.replace('http', 'ws')}/socket{query}",
            origin=self.console.origin,
            additional_headers=self.console.proved({"Cookie": cookie}),
            close_timeout=0.2,
        ) as socket:
            await socket.send(json.dumps({"type": "hello", "tab": f"tab-of-page{query}"}))
            yield socket

    async def post(self, path: str, cookie: str) -> int:
        headers = {"Cookie": cookie, "Origin": self.console.origin}
        return int((await self.console.request("POST", path, **headers))[0])

    def orders(self, name: str) -> list[OrderKind]:
        return [order.kind for order in self.pilots[name].orders]


@pytest_asyncio.fixture(loop_scope="session")
async def two(loopback: str, serving: Any) -> AsyncIterator[TwoDrones]:
    stops: list[str] = []
    beside = ConsoleDrone(DroneConfig(name="blue"), "blue", lambda: stops.append("blue"))
    red = DroneConfig(name="red")
    async with serving(loopback, drone=red, drone_body="red", beside=(beside,)) as console:
        pilots = [
            FakePilot(console.bus.join(), example_room(), topics=DroneTopics(name))
            for name in ("red", "blue")
        ]
        flying = [asyncio.create_task(pilot.run()) for pilot in pilots]
        yield TwoDrones(console, *pilots, stops)
        for task in flying:
            task.cancel()


async def test_stop_on_one_page_stops_all_and_one_is_stopped_by_its_name(
    two: TwoDrones, until: Any
) -> None:
    cookie = await two.console.session()
    async with two.page(cookie, "?drone=red") as page:
        await page.send(json.dumps({"type": "stop", "id": 1}))
        await until(lambda: OrderKind.STOP in two.orders("red"))
        await until(lambda: OrderKind.STOP in two.orders("blue"))
        assert len(two.console.stops) == len(two.blue_stops) == 1
    assert await two.post("/stop?drone=blue", cookie) == 200
    await until(lambda: two.orders("blue").count(OrderKind.STOP) == 2)
    assert two.orders("red").count(OrderKind.STOP) == 1
    assert await two.post("/stop?drone=bleu", cookie) == 200, "rather all than none"
    await until(lambda: two.orders("red").count(OrderKind.STOP) == 2)


async def test_each_page_flies_the_drone_that_it_shows_and_no_other(
    two: TwoDrones, until: Any
) -> None:
    cookie = await two.console.session()
    async with two.page(cookie, "") as first, two.page(cookie, "?drone=blue") as second:
        for page, name in ((first, "red"), (second, "blue")):
            await until(lambda: two.red.sequence > 20 and two.blue.sequence > 20)
            await page.send(json.dumps({"type": "order", "id": 2, "order": "take_off"}))
            await until(lambda name=name: two.orders(name) == [OrderKind.TAKE_OFF])
        await until(lambda: two.red.position and two.blue.height > 0.3)
        assert await two.post("/land?drone=blue", cookie) == 200
        await until(lambda: OrderKind.LAND in two.orders("blue"))
        assert OrderKind.LAND not in two.orders("red")
        assert await two.post("/land", cookie) == 200
        await until(lambda: OrderKind.LAND in two.orders("red"))


async def test_the_drones_are_listed_and_the_page_shows_the_list_only_where_there_are_several(
    two: TwoDrones, console: Any
) -> None:
    cookie = await two.console.session()
    _, _, text = await two.console.request("GET", "/drones", Cookie=cookie)
    assert [drone["name"] for drone in json.loads(text)["drones"]] == ["red", "blue"]
    _, _, page = await two.console.request("GET", "/", Cookie=cookie)
    assert "/static/drones.js" in page
    _, _, alone = await console.request("GET", "/", Cookie=await console.session())
    assert "drones" not in alone
    assert (await two.console.request("GET", "/drones"))[0] == 401


async def test_a_page_of_a_drone_that_there_is_not_shows_no_other(two: TwoDrones) -> None:
    cookie = await two.console.session()
    with pytest.raises(InvalidStatus):
        async with two.page(cookie, "?drone=green"):
            pass
    assert await two.post("/land?drone=green", cookie) == 404
