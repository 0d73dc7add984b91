"""Whoever listens hears what changed, and nothing twice."""

from __future__ import annotations

import json

from housefly.hub.api.answers import Holding
from housefly.hub.newsroom import MOST_EVENTS, Newsroom
from housefly.messages import Happening


def news_of(newsroom: Newsroom) -> dict[str, object] | None:
    news = newsroom.news()
    return None if news is None else json.loads(news.text)


def test_nothing_new_is_no_news(house) -> None:
    newsroom = Newsroom(house.memory, house.present, lambda: house.now)
    assert newsroom.news() is None
    house.see("drone", 1.0, (1.0, 2.0, 3.0))
    first = news_of(newsroom)
    assert first is not None
    assert [thing["thing"] for thing in first["things"]] == ["drone"]
    assert newsroom.news() is None


def test_what_is_in_a_thing_that_moved_moved_too(house) -> None:
    newsroom = Newsroom(house.memory, house.present, lambda: house.now)
    house.see("cabinet", 1.0, (3.0, 3.0, 0.6))
    told = news_of(newsroom)
    assert told is not None
    assert {thing["thing"]: thing["position"] for thing in told["things"]} == {
        "cabinet": [3.0, 3.0, 0.6],
        "cup": [3.0, 3.0, 0.6],
    }


def test_a_situation_that_begins_and_ends_is_news(house) -> None:
    newsroom = Newsroom(house.memory, house.present, lambda: house.now)
    house.present.hold([Holding("bed occupied", "bed", house.now, 0.9, "58 kg")])
    first, second = news_of(newsroom), news_of(newsroom)
    house.present.hold([])
    third = news_of(newsroom)
    assert first is not None and third is not None and second is None
    assert [held["kind"] for held in first["situations"]] == ["bed occupied"]
    assert third["situations"] == []


def test_a_storm_of_events_is_cut(house, noon: float) -> None:
    newsroom = Newsroom(house.memory, house.present, lambda: house.now)
    for number in range(3 * MOST_EVENTS):
        house.memory.take(Happening("door opened", "cabinet", noon + number, "test"))
    told = news_of(newsroom)
    assert told is not None
    assert len(told["events"]) == MOST_EVENTS
