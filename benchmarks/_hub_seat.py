"""Seats of their own processes for benchmarks/hub.py: three that ask, one that listens, an echo;
they print JSON.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable
from functools import partial

import housefly
from housefly.bus.topics import FRAME_TOPIC, HUB_QUERY, DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.errors import ThingError
from housefly.hub.api.answers import News, WhereAnswer
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import WhereQuestion
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.hub.client.discovery import find
from housefly.hub.client.room_client import RoomClient
from housefly.messages import PilotStep, TrackedFrame

TOPICS = DroneTopics()

ECHO = "benchmark/echo"
PAUSE = 0.003
"""Between two questions [s]: somebody who asks, not somebody who floods."""
WARM_UP = 1.0
"""The first messages wait until this process has built its decoder [s]."""
AGES = ("frame", "waited", "stepped", "step", "captured", "news", "news_way")
THINGS = ("ardrone", "cup", "the visitor", "entrance-door")


def known_to(where: Callable[[str], WhereAnswer]) -> list[str]:
    """Return the things that may be asked for."""
    return [thing for thing in THINGS if _is_known(where, thing)]


def taken(ask: Callable[[], object]) -> float:
    """Return how long an answer took [s]."""
    begin = time.perf_counter()
    ask()
    return time.perf_counter() - begin


def by_bus(bus: ZenohBus, count: int) -> dict[str, list[float]]:
    """Ask on the bus, in turn with an echo that does nothing, and return how long each answer took
    [s].
    """

    def where(thing: str) -> WhereAnswer:
        answer = answer_from_json(
            WhereQuestion(thing), bus.ask(HUB_QUERY, question_to_json(WhereQuestion(thing)))
        )
        assert isinstance(answer, WhereAnswer)
        return answer

    known, text = known_to(where), bus.ask(HUB_QUERY, question_to_json(WhereQuestion(THINGS[0])))
    times: dict[str, list[float]] = {"hub": [], "echo": []}
    for number in range(count):
        thing = known[number % len(known)]
        for name, ask in (("hub", partial(where, thing)), ("echo", partial(bus.ask, ECHO, text))):
            time.sleep(PAUSE)
            times[name].append(taken(ask))
    return times


def by_client(room: RoomClient, count: int) -> list[float]:
    """Ask as a program does."""
    times = []
    with room:
        known = known_to(room.where)
        for number in range(count):
            time.sleep(PAUSE)
            times.append(taken(partial(room.where, known[number % len(known)])))
    return times


def over_http(site: str) -> RoomClient:
    """Return a client that asks the console, as one on another machine does."""
    place = find(site)
    return RoomClient(place.address, place.key)


def echo(endpoint: str) -> None:
    """Answer with what was asked, at the priority of the hub, until told to leave."""
    os.nice(5)
    with ZenohBus(connect=endpoint) as bus:
        bus.answer(ECHO, str)
        sys.stdin.read()


def listened(bus: ZenohBus, drone: str, seconds: float) -> dict[str, list[float]]:
    """Listen to frames, steps and news and return how old what they tell was on arrival [s]."""
    ages: dict[str, list[float]] = {name: [] for name in AGES}

    def frame(frame: TrackedFrame) -> None:
        now = time.monotonic()
        ages["frame"] += [
            now - sighting.received_at for sighting in frame.sightings if sighting.body == drone
        ]

    def step(step: PilotStep) -> None:
        now = time.monotonic()
        ages["stepped"].append(now - step.now)
        for sighting in step.inputs.sightings:
            if sighting.body == drone:
                ages["waited"].append(step.now - sighting.received_at)
                ages["step"].append(now - sighting.received_at)
                ages["captured"].append(now - sighting.captured_at)

    def news(news: News) -> None:
        now = time.time()
        ages["news_way"].append(now - news.at)
        ages["news"] += [
            now - news.at + thing.age
            for thing in news.things
            if thing.thing == drone and thing.age is not None
        ]

    open_ = [
        bus.subscribe(FRAME_TOPIC, frame),
        bus.subscribe(TOPICS.step, step),
        bus.subscribe(ROOM_NEWS_TOPIC, news),
    ]
    time.sleep(WARM_UP)
    for values in ages.values():
        values.clear()
    time.sleep(seconds)
    for subscription in open_:
        subscription.close()
    return ages


def _is_known(where: Callable[[str], WhereAnswer], thing: str) -> bool:
    try:
        return bool(where(thing))
    except ThingError:
        return False


def main() -> None:
    """Do as told: bus ENDPOINT COUNT, echo ENDPOINT, connected SITE COUNT, http SITE COUNT, listen
    ENDPOINT BODY SECONDS.
    """
    match sys.argv[1:]:
        case ["bus", endpoint, count]:
            with ZenohBus(connect=endpoint) as bus:
                print(json.dumps(by_bus(bus, int(count))))
        case ["echo", endpoint]:
            echo(endpoint)
        case ["connected", site, count]:
            print(json.dumps(by_client(housefly.connect(site), int(count))))
        case ["http", site, count]:
            print(json.dumps(by_client(over_http(site), int(count))))
        case ["listen", endpoint, drone, seconds]:
            with ZenohBus(connect=endpoint) as bus:
                print(json.dumps(listened(bus, drone, float(seconds))))
        case _:
            sys.exit(main.__doc__)


if __name__ == "__main__":
    main()
