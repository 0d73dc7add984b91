"""Whoever listens hears what changed, and nothing twice."""

from __future__ import annotations

import json

from housefly.bus.codec import encoded
from housefly.hub.api.answers import SituationAnswer
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.hub.change_feed import MAX_EVENTS, ChangeFeed
from housefly.messages import RoomEvent


def news_of(change_feed: ChangeFeed) -> dict[str, object] | None:
    news = change_feed.changes()
    return None if news is None else json.loads(encoded(ROOM_NEWS_TOPIC, news))


def test_nothing_new_is_no_news(house) -> None:
    change_feed = ChangeFeed(house.memory, house.status, lambda: house.now)
    assert change_feed.changes() is None
    house.see("drone", 1.0, (1.0, 2.0, 3.0))
    first = news_of(change_feed)
    assert first is not None
    assert [thing["thing"] for thing in first["things"]] == ["drone"]
    assert change_feed.changes() is None


def test_what_is_in_a_thing_that_moved_moved_too(house) -> None:
    change_feed = ChangeFeed(house.memory, house.status, lambda: house.now)
    house.see("cabinet", 1.0, (3.0, 3.0, 0.6))
    told = news_of(change_feed)
    assert told is not None
    assert {thing["thing"]: thing["position"] for thing in told["things"]} == {
        "cabinet": [3.0, 3.0, 0.6],
        "cup": [3.0, 3.0, 0.6],
    }


def test_a_situation_that_begins_and_ends_is_news(house) -> None:
    change_feed = ChangeFeed(house.memory, house.status, lambda: house.now)
    house.status.set_situations([SituationAnswer("bed occupied", "bed", house.now, 0.9, "58 kg")])
    first, second = news_of(change_feed), news_of(change_feed)
    house.status.set_situations([])
    third = news_of(change_feed)
    assert first is not None and third is not None and second is None
    assert [held["kind"] for held in first["situations"]] == ["bed occupied"]
    assert third["situations"] == []


def test_a_storm_of_events_is_cut(house, noon: float) -> None:
    change_feed = ChangeFeed(house.memory, house.status, lambda: house.now)
    for number in range(3 * MAX_EVENTS):
        house.memory.add(RoomEvent("door opened", "cabinet", noon + number, "test"))
    told = news_of(change_feed)
    assert told is not None
    assert len(told["events"]) == MAX_EVENTS
