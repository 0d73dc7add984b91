"""The link at a real broker: announced, shown, heard; nothing that is kept or sent flies."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from concurrent.futures import Future
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import aiomqtt
import pytest
from home_screen import Screen, site_at, watching
from mqtt_broker import Broker, running_broker, until
from stand_in_tasks import StandInTasks

from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.clock import RealClock
from housefly.config.site import Site
from housefly.homeassistant.home_link import HomeLink
from housefly.homeassistant.home_requests import HomeRequests
from housefly.homeassistant.home_view import HomeView
from housefly.homeassistant.topics import HomeTopics
from housefly.hub.api.answers import EventAnswer, News, SensorAnswer
from housefly.messages import Order
from housefly.room.files import load_room
from housefly.tasks.api.questions import RequestTask
from housefly.tasks.api.topics import TASK_NEWS_TOPIC

pytestmark = pytest.mark.wire
TOPICS = HomeTopics("home")
DRONE = TOPICS.drone_command("drone")
BELL = SensorAnswer("doorbell", "doorbell", "Doorbell", True, 0.1, 1.0, "", {})


@pytest.fixture
async def broker(tmp_path: Path) -> AsyncIterator[Broker]:
    async with running_broker(tmp_path) as started:
        yield started


class House:
    """View, tasks and link of one room."""

    def __init__(self, site: Site) -> None:
        bus, clock = LocalBus(), RealClock()
        self.tasks, self.orders, self.stops = StandInTasks(bus), list[Order](), 0
        self.view = HomeView(site, load_room(site.room.model), clock)
        self.view.hear_sensors([BELL])
        bus.subscribe(DroneTopics("drone").order, self.orders.append)
        bus.subscribe(TASK_NEWS_TOPIC, self.view.hear_board)
        places = [place.name for place in self.view.places]
        stops = {"drone": self._stop}
        self.requests = HomeRequests(
            site.homeassistant, TOPICS, places, stops, bus, self.view.board, clock
        )
        self.link = HomeLink(site, self.view, self.requests, clock)

    def _stop(self) -> Future[bool]:
        self.stops += 1
        return Future()

    @property
    def asked(self) -> list[Any]:
        return [one for one in self.tasks.asked if isinstance(one, RequestTask)]


@asynccontextmanager
async def shown(site: Site) -> AsyncIterator[House]:
    house = House(site)
    running = asyncio.create_task(house.link.run_for_ever())
    try:
        yield house
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
        house.requests.close()


async def announced(screen: Screen) -> None:
    await screen.holds(TOPICS.availability, b"online")


async def test_everything_is_announced_before_housefly_is_there(broker: Broker) -> None:
    async with watching(broker) as screen, shown(site_at(broker.port)) as house:
        await announced(screen)
        told = [topic for topic, _ in screen.once]
        configs = [topic for topic in told if topic.endswith("/config")]
        assert len(configs) == len(house.view.entities())
        assert told.index(TOPICS.availability) > told.index(configs[-1])
        states = list(house.view.states())
        assert set(states) <= set(screen.held)
        first_state = min(map(told.index, states[sum(map(TOPICS.is_attributes, states)) :]))
        assert all(told.index(one) < first_state for one in filter(TOPICS.is_attributes, states))
        stop = json.loads(screen.held[TOPICS.entity_config("button", "drone-drone-stop")])
        assert (stop["command_topic"], stop["payload_press"]) == (DRONE, "stop")


async def test_a_bell_is_told_at_once_and_not_kept(broker: Broker) -> None:
    async with watching(broker) as screen, shown(site_at(broker.port)) as house:
        await announced(screen)
        rung = EventAnswer("bell pressed", "doorbell", 50.0, "doorbell", "", 1.0, {})
        for topic, payload in house.view.hear_news(News(50.1, (), (rung,), (), ())):
            house.link.send(topic, payload)
        assert house.view.hear_news(News(500.0, (), (rung,), (), ())) == [], "it is long over"
        await until(lambda: TOPICS.event("device-doorbell") in screen.held)
        async with watching(broker) as later:
            await announced(later)
            assert TOPICS.event("device-doorbell") not in later.held


async def test_what_a_task_asks_is_shown_and_a_no_from_there_counts(broker: Broker) -> None:
    async with watching(broker) as screen, shown(site_at(broker.port)) as house:
        await announced(screen)
        task = house.tasks.ring()
        await screen.holds(TOPICS.state("room-question"), b"Someone is at the entrance. Look?")
        told = json.loads(screen.held[TOPICS.attributes("room-question")])
        assert told["asks"] == f"{task.id}|confirm" and told["words"].endswith("Look?")
        await screen.client.publish(TOPICS.answer_command, b"no", qos=1)
        await screen.holds(TOPICS.state("room-question"), b"none")
        assert house.tasks.tasks[task.id].words == "Home Assistant said ignore"


async def test_it_is_announced_again_when_home_assistant_is_born(broker: Broker) -> None:
    async with watching(broker) as screen, shown(site_at(broker.port)):
        await announced(screen)
        stop = TOPICS.entity_config("button", "drone-drone-stop")
        await screen.client.publish(TOPICS.birth, b"online", qos=1)
        await until(lambda: [topic for topic, _ in screen.once].count(stop) >= 2)


async def test_it_ends_though_its_library_loses_a_cancellation(
    broker: Broker, monkeypatch: pytest.MonkeyPatch
) -> None:
    lost = list[str]()

    async def keep_waiting(client: aiomqtt.Client, answer: Any, timeout: float | None) -> Any:
        # Python 3.11's wait_for does this when answer and cancellation come in one turn.
        waiting = asyncio.ensure_future(answer)
        try:
            return await asyncio.shield(waiting)
        except asyncio.CancelledError:
            lost.append("one")
            return await waiting

    monkeypatch.setattr(aiomqtt.Client, "_wait_for", keep_waiting)
    async with watching(broker) as screen:
        async with asyncio.timeout(60.0), shown(site_at(broker.port)):
            await until(lambda: len(screen.held) > 5)
        assert lost


async def test_a_command_that_the_broker_kept_flies_nothing(broker: Broker) -> None:
    async with broker.client() as before:
        for payload in (b"start", b"go entrance", b"stop", b"home"):
            await before.publish(DRONE, payload, qos=1, retain=True)
    async with watching(broker) as screen, shown(site_at(broker.port)) as house:
        await announced(screen)
        await screen.client.publish(DRONE, b"go entrance", qos=1)
        await until(lambda: house.asked)
        assert [one.parameters for one in house.asked] == [{"subject": "entrance"}]
        assert house.orders == [] and house.stops == 0


async def test_no_garbage_and_no_flood_ends_the_link_and_stop_passes(broker: Broker) -> None:
    async with watching(broker) as screen, shown(site_at(broker.port)) as house:
        await announced(screen)
        deep = b"[" * 4000 + b"]" * 4000
        for topic in (DRONE, TOPICS.answer_command, f"{DRONE}/deeper", TOPICS.birth):
            for payload in (b"\xff\xfe\x00", deep, b"x" * 2**17, b"null", b"go " + b"y" * 900):
                await screen.client.publish(topic, payload, qos=1)
        for _ in range(500):
            await screen.client.publish(DRONE, b"go entrance", qos=0)
        await screen.client.publish(DRONE, b"stop", qos=1)
        await until(lambda: house.stops)
        assert len(house.asked) <= 20
        assert not any(one.parameters != {"subject": "entrance"} for one in house.asked)


@pytest.mark.parametrize("discovery", ["entity", "device"])
async def test_what_an_earlier_site_announced_is_withdrawn(broker: Broker, discovery: Any) -> None:
    old = [
        TOPICS.entity_config("button", "drone-gone-stop"),
        TOPICS.entity_config("button", "drone-drone-go-attic"),
        TOPICS.device_config("drone-gone"),
    ]
    other = "entity" if discovery == "device" else "device"
    of_others = ["homeassistant/button/housefly-cabin/drone-gone-stop/config"]
    silent = (
        TOPICS.entity_config("sensor", "device-cellar-power")
        if discovery == "entity"
        else TOPICS.device_config("device-cellar")
    )
    async with watching(broker) as screen:
        async with shown(site_at(broker.port, discovery=other)):
            await announced(screen)
        await screen.holds(TOPICS.availability, b"offline")
        before = [topic for topic, payload in screen.held.items() if topic.endswith("/config")]
        for topic in (*old, *of_others, silent):
            await screen.client.publish(topic, b"{}", qos=1, retain=True)
        async with shown(site_at(broker.port, discovery=discovery)):
            await announced(screen)
            await until(lambda: all(screen.held[topic] == b"" for topic in (*old, *before)))
            for topic in (*of_others, silent):
                assert screen.held[topic] == b"{}", "a device may only be silent still"


async def test_a_bell_that_rang_while_the_broker_was_away_does_not_ring_later(
    broker: Broker,
) -> None:
    async with shown(site_at(broker.port)) as house:
        async with watching(broker) as screen:
            await announced(screen)
        await broker.kill()
        await until(lambda: house.link.problem)
        house.link.send(TOPICS.event("device-doorbell"), b'{"event_type": "press"}')
        await asyncio.sleep(0.0)
        await broker.start()
        async with watching(broker) as screen:
            await announced(screen)
            house.link.send(TOPICS.event("device-doorbell"), b"later")
            await until(lambda: TOPICS.event("device-doorbell") in screen.held)
            bell = TOPICS.event("device-doorbell")
            assert [payload for topic, payload in screen.once if topic == bell] == [b"later"]
            assert not house.link.problem
