"""The feed of a memory: asked as everything is asked."""

from __future__ import annotations

from typing import Any

from housefly.hub.api.questions import FeedQuestion
from housefly.messages import RoomEvent


def note(house: Any, kind: str, thing: str, ago: float, **facts: Any) -> None:
    source = "situations/people"
    house.memory.add(RoomEvent(kind, thing, house.now - ago, source, facts=tuple(facts.items())))


def test_the_feed_names_the_furniture_that_somebody_stood_at(house: Any) -> None:
    note(house, "person standing", "person-1", 60.0, x=11.0, y=4.4)
    note(house, "person sitting", "person-1", 30.0, on="sofa seat 1", x=8.0, y=1.0)
    (entry,) = house.ask(FeedQuestion()).entries
    assert (entry.words, entry.at) == ("cabinet, then sofa", house.now - 30.0)


def test_it_goes_back_a_day_where_little_happened_and_no_farther_than_asked(house: Any) -> None:
    for hours in (0.5, 5.0, 20.0, 30.0):
        note(house, "door opened", "cabinet", hours * 3600.0)
    note(house, "person sitting", "person-1", 60.0, on="sofa")
    ages = [house.now - one.at for one in house.ask(FeedQuestion("things")).entries]
    assert ages == [1800.0, 18000.0, 72000.0]
    assert len(house.ask(FeedQuestion("things", limit=2)).entries) == 2
    then = house.ask(FeedQuestion(until=house.now - 3600.0)).entries
    assert [house.now - one.at for one in then] == [18000.0, 72000.0]
