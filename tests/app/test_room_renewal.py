"""Saved no-fly zones come into use at once, in one real house: web, launcher, pilot, driver."""

from __future__ import annotations

import asyncio
import json
import os
import re
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import asynccontextmanager
from itertools import pairwise
from pathlib import Path
from typing import Any

import psutil
import pytest
from outside_room import OutsideRoom, Run, outside_site, running_outside, wait_for
from websockets.asyncio.client import ClientConnection, connect

from housefly.bus.topics import DroneTopics
from housefly.geometry import Vec2, distance
from housefly.hub.api.pilot_queries import PlanRequest
from housefly.hub.api.pilot_queries_json import from_json, to_json
from housefly.messages import OrderKind, PlanAnswer

TOPICS = DroneTopics()

pytestmark = [
    pytest.mark.wire,
    pytest.mark.realtime,
    pytest.mark.slow,
    pytest.mark.timeout(400),
]

TAB = "tab-number-one"
PILOT, DRIVER, WEB = "housefly.app.pilot_main", "housefly.app.driver_main", "housefly.web.process"


class House:
    """A run in a room outside of it, and one browser that has control."""

    def __init__(self, room: OutsideRoom, run: Run, folder: Path, link: str) -> None:
        self.room, self.run, self.folder = room, run, folder
        self.pad: Vec2 = room.world.truth().pose.position[:2]
        self.origin = link.partition("/?")[0]
        opener = urllib.request.build_opener(_NoRedirect)
        try:
            opener.open(link)
        except urllib.error.HTTPError as found:
            self.cookie = str(found.headers["set-cookie"]).partition(";")[0]
            self.proof = str(found.headers["location"]).partition("?proof=")[2]

    @property
    def headers(self) -> dict[str, str]:
        return {"Cookie": self.cookie, "Origin": self.origin, "X-Housefly-Proof": self.proof}

    @asynccontextmanager
    async def control(self) -> Any:
        """Hold control as a page does."""
        async with connect(
            self.origin.replace("http", "ws") + "/socket",
            origin=self.origin,
            additional_headers={key: self.headers[key] for key in ("Cookie", "X-Housefly-Proof")},
        ) as socket:
            await socket.send(json.dumps({"type": "hello", "tab": TAB, "name": "Ada"}))
            pinging = asyncio.create_task(_ping(socket))
            await asyncio.sleep(0.5)
            await socket.send(json.dumps({"type": "lease", "id": 1, "action": "take"}))
            await asyncio.sleep(0.5)
            yield
            pinging.cancel()

    async def ask(self, path: str, body: Any = None, **headers: str) -> tuple[int, Any]:
        return await asyncio.to_thread(self._ask, path, body, headers)

    def _ask(self, path: str, body: Any, headers: dict[str, str]) -> tuple[int, Any]:
        data = None if body is None else json.dumps(body).encode()
        asked = urllib.request.Request(
            self.origin + path, data, {**self.headers, **headers}, method="POST" if data else "GET"
        )
        try:
            with urllib.request.urlopen(asked, timeout=30) as answer:
                return answer.status, json.loads(answer.read())
        except urllib.error.HTTPError as error:
            return error.code, json.loads(error.read())

    async def save(self, *zones: tuple[float, ...]) -> int:
        """Save zones and return the version."""
        _, view = await self.ask("/edits")
        edits = {"zones": [{"rectangle": zone, "reason": "wet floor"} for zone in zones]}
        body = {"based_on": view["version"], "tab": TAB, "edits": edits}
        status, saved = await self.ask("/edits", body)
        assert status == 200, saved
        return int(saved["version"])

    async def use(self, version: int, **headers: str) -> tuple[int, Any]:
        return await self.ask("/edits/use", {"based_on": version, "tab": TAB}, **headers)

    def way(self) -> tuple[Vec2, ...]:
        """Ask the pilot for the way to the entrance."""
        asked = to_json(PlanRequest("entrance", start=self.pad))
        answer = from_json(PlanAnswer, self.run.bus.ask(TOPICS.plan, asked, 5.0))
        assert answer.path is not None, answer.reason
        return answer.path.waypoints

    def pids(self) -> dict[str, int]:
        return {module: self.run.part(module).pid for module in (PILOT, DRIVER, WEB)}

    def is_another(self, old: int) -> bool:
        return not psutil.pid_exists(old) and any(
            PILOT in " ".join(part.cmdline()) for part in self.run.current_parts()
        )

    def answers(self) -> bool:
        try:
            return bool(self.way())
        except Exception:
            return False

    async def renewed(self, old: int) -> None:
        """Wait until another pilot answers."""
        await asyncio.to_thread(
            wait_for,
            lambda: self.is_another(old) and self.answers(),
            90.0,
            "a new pilot",
        )


class _NoRedirect(urllib.request.HTTPRedirectHandler):
    def redirect_request(self, *_: Any) -> None:
        return None


async def _ping(socket: ClientConnection) -> None:
    async def drain() -> None:
        async for _ in socket:
            pass

    draining = asyncio.create_task(drain())
    try:
        while True:
            await socket.send(json.dumps({"type": "ping", "sent": 0.0}))
            await asyncio.sleep(0.5)
    finally:
        draining.cancel()


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Iterator[House]:
    folder = tmp_path_factory.mktemp("house")
    address = f"127.{1 + os.getpid() % 250}.78.11"
    site = outside_site(folder, address)
    log = folder / "run.log"
    with running_outside(site, log) as (room, run):
        found = re.search(r"http://\S+", log.read_text())
        assert found
        yield House(room, run, folder, found[0])
        run.process.terminate()
        run.process.wait(60)


def middle_of(way: tuple[Vec2, ...]) -> Vec2:
    """Return the point half way along a way."""
    lengths = [distance(a, b) for a, b in pairwise(way)]
    left = sum(lengths) / 2
    for a, b, length in zip(way[:-1], way[1:], lengths, strict=True):
        if left <= length:
            share = left / length
            return a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])
        left -= length
    return way[-1]


def crosses(way: tuple[Vec2, ...], zone: tuple[float, ...]) -> bool:
    """Return whether a way enters a zone."""
    for a, b in pairwise(way):
        for k in range(101):
            x, y = (a[i] + k / 100 * (b[i] - a[i]) for i in (0, 1))
            if zone[0] < x < zone[2] and zone[1] < y < zone[3]:
                return True
    return False


def over(point: Vec2, half: float = 0.25) -> tuple[float, ...]:
    return (point[0] - half, point[1] - half, point[0] + half, point[1] + half)


async def test_a_zone_over_the_usual_way_is_used_now_and_the_next_way_goes_around(
    house: House,
) -> None:
    before, pids = house.way(), house.pids()
    zone = over(middle_of(before))
    assert crosses(before, zone)
    async with house.control():
        version = await house.save(zone)
        assert crosses(house.way(), zone), "saved alone it does not count yet"
        status, view = await house.use(version)
        assert status == 200, view
        twice = await house.use(version)
        assert twice[0] == 409, "pressed twice"
        await house.renewed(pids[PILOT])
        assert not crosses(house.way(), zone)
        _, view = await house.ask("/edits")
        assert view["in_use"] and view["words"] == ""
        while "nobody knows" in (await house.use(version))[1]["error"]:
            await asyncio.sleep(0.2)  # the console has not heard the new pilot yet
        again, words = await house.use(version)
        assert (again, words["error"]) == (409, "the drone has this version already")
    now = house.pids()
    assert (now[DRIVER], now[WEB]) == (pids[DRIVER], pids[WEB]), "they live on"
    assert "died" not in house.run.log.read_text()


async def test_who_has_no_control_or_comes_from_another_page_uses_nothing(house: House) -> None:
    pilot = house.pids()[PILOT]
    async with house.control():
        version = await house.save()
        status, _ = await house.use(version, Origin="http://elsewhere.example")
        assert status == 403
        status, _ = await house.ask("/edits/use", {"based_on": version, "tab": "another"})
        assert status == 403
        status, words = await house.use(version - 1)
        assert status == 409 and "saved in between" in words["error"]
    assert house.pids()[PILOT] == pilot


async def test_in_flight_a_crafted_request_is_refused_and_the_flight_goes_on(
    house: House,
) -> None:
    pids = house.pids()
    async with house.control():
        version = await house.save()
        await asyncio.to_thread(house.run.fly_off, house.room)
        status, words = await house.use(version)
        assert status == 409 and "land first" in words["error"]
        straight = house.run.bus.ask("run/use_edits", str(version), 10.0)
        assert "the drone does not stand" in straight, "past the console the pilot's word holds"
        assert house.pids() == pids and house.room.height > 0.3
        house.run.order(OrderKind.LAND)
        await asyncio.to_thread(wait_for, house.room.is_standing, 40.0, "a landing")


async def test_who_takes_off_at_that_moment_wins_or_is_refused_and_nothing_falls(
    house: House,
) -> None:
    pids = house.pids()
    async with house.control():
        _, view = await house.ask("/edits")
        if view["in_use"]:
            await house.save(over(middle_of(house.way())))
            _, view = await house.ask("/edits")
        using = asyncio.create_task(house.use(view["version"]))
        for _ in range(20):
            house.run.order(OrderKind.TAKE_OFF)
            await asyncio.sleep(0.05)
        status, words = await using
        flew = house.room.height > 0.3
        assert not (status == 200 and flew), "a pilot that gave its word stays on the ground"
        if status == 200:
            await house.renewed(pids[PILOT])
        else:
            assert house.pids() == pids, words
            house.run.order(OrderKind.LAND)
            await asyncio.to_thread(wait_for, house.room.is_standing, 40.0, "a landing")
    assert house.pids()[DRIVER] == pids[DRIVER] and not house.room.was_left_alone
    assert house.room.is_standing()


async def test_a_version_that_breaks_on_the_disk_leaves_the_old_pilot(house: House) -> None:
    async with house.control():
        version = await house.save(over((4.0, 3.0)), over((5.0, 3.0), 0.1))
        (broken,) = list(house.folder.rglob(f"{version:04d}.json"))
        pids, way = house.pids(), house.way()
        broken.write_text("{")
        said = house.run.bus.ask("run/use_edits", str(version), 10.0)
        assert str(broken.name) in said
        assert house.pids() == pids and house.way() == way
