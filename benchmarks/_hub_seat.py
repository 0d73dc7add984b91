"""Seats of their own processes for benchmarks/hub.py: two that ask, one that listens; each prints one JSON object."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable

import housefly
from housefly.bus.room_json import answer_from_json, question_to_json
from housefly.bus.room_questions import Where, WhereAnswer
from housefly.bus.topics import HUB_QUERY, ROOM_NEWS, STEP
from housefly.bus.zenoh_bus import ZenohBus
from housefly.errors import ThingError
from housefly.messages import PilotStep, RoomNews

PAUSE = 0.003
"""Between two questions [s]: somebody who asks, not somebody who floods."""
THINGS = ("ardrone", "cup", "the visitor", "entrance-door")


def asked(where: Callable[[str], WhereAnswer], count: int) -> list[float]:
    """Ask so many times and return how long each answer took [s]."""
    known = [thing for thing in THINGS if _is_known(where, thing)]
    times = []
    for number in range(count):
        time.sleep(PAUSE)
        begin = time.perf_counter()
        where(known[number % len(known)])
        times.append(time.perf_counter() - begin)
    return times


def by_bus(bus: ZenohBus, count: int) -> list[float]:
    """Ask on the bus."""

    def where(thing: str) -> WhereAnswer:
        answer = answer_from_json(Where(thing), bus.ask(HUB_QUERY, question_to_json(Where(thing))))
        assert isinstance(answer, WhereAnswer)
        return answer

    return asked(where, count)


def by_http(site: str, count: int) -> list[float]:
    """Ask as a program of the same user does."""
    with housefly.connect(site) as room:
        return asked(room.where, count)


def listened(bus: ZenohBus, drone: str, seconds: float) -> dict[str, list[float]]:
    """Listen to steps and news and return how old what they tell was on arrival [s]."""
    ages: dict[str, list[float]] = {"waited": [], "stepped": [], "frame": [], "captured": [], "news": [], "news_way": []}

    def step(step: PilotStep) -> None:
        now = time.monotonic()
        ages["stepped"].append(now - step.now)
        for sighting in step.inputs.sightings:
            if sighting.body == drone:
                ages["waited"].append(step.now - sighting.received_at)
                ages["frame"].append(now - sighting.received_at)
                ages["captured"].append(now - sighting.captured_at)

    def news(news: RoomNews) -> None:
        now, told = time.time(), json.loads(news.text)
        ages["news_way"].append(now - told["at"])
        ages["news"] += [now - told["at"] + thing["age"] for thing in told["things"] if thing["thing"] == drone]

    open_ = [bus.subscribe(STEP, step), bus.subscribe(ROOM_NEWS, news)]
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
    """Do what the first argument says: bus ENDPOINT COUNT, http SITE COUNT, listen ENDPOINT BODY SECONDS."""
    match sys.argv[1:]:
        case ["bus", endpoint, count]:
            with ZenohBus(connect=endpoint) as bus:
                print(json.dumps(by_bus(bus, int(count))))
        case ["http", site, count]:
            print(json.dumps(by_http(site, int(count))))
        case ["listen", endpoint, drone, seconds]:
            with ZenohBus(connect=endpoint) as bus:
                print(json.dumps(listened(bus, drone, float(seconds))))
        case _:
            sys.exit(main.__doc__)


if __name__ == "__main__":
    main()
