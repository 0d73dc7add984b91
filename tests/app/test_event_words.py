"""What happened is told with the names that people use, and without numbers for programs."""

from __future__ import annotations

import re
from collections.abc import Mapping

import pytest

from housefly.app.event_words import EventWords, fact_words
from housefly.app.room_words import detailed_event_line, event_line
from housefly.hub.api.answers import EventAnswer
from housefly.hub.feed.worth_reading import worth_reading

WORDS = EventWords({"person-1": "the resident", "cup": "the cup", "cabinet": "cabinet"})
FOR_PROGRAMS = {
    "x": 11.9, "y": 4.2, "z": 0.6, "by_distance": 0.503, "by_confidence": 1.0, "sigma": 0.2,
}  # fmt: skip


def event(
    kind: str, thing: str, cause: str = "", source: str = "situations/x", **facts: str | float
) -> EventAnswer:
    return EventAnswer(kind, thing, 1_700_000_000.0, source, cause, 0.95, dict(facts))


@pytest.mark.parametrize(
    ("told", "words"),
    [
        (
            event(
                "object taken", "cup", "person-1", weight=0.21, evidence="cabinet: reports it",
                sources="cabinet",
                **{"from": "cabinet"}, **FOR_PROGRAMS,
            ),
            "the resident took the cup from the cabinet, 0.21 kg  (95 % sure, cabinet)",
        ),
        (
            event("tracking lost", "ardrone", source="pilot", words="unseen for 2 s"),
            "the ardrone: unseen for 2 s  (95 % sure, pilot)",
        ),
        (event("object put", "cup"), "somebody put the cup down  (95 % sure)"),
        (
            event(
                "person sitting", "person-1", on="sofa seat 0", evidence="floor-1: on seat",
                sources="floor-1",
            ),
            "the resident sits on the sofa  (95 % sure, floor-1)",
        ),
        (event("appliance on", "stove", power=1420.4), "the stove is on, 1420 W  (95 % sure)"),
        (event("task ended", "ardrone", task=1.0, words="done"), "task 1 ended: done  (95 % sure)"),
        (
            event("humidity high", "plug-2", "person-1", "plug-2", dew_point=11.234),
            "plug 2: humidity high, dew point 11.2, by the resident  (95 % sure, plug-2)",
        ),
    ],
    ids=lambda value: value if isinstance(value, str) else value.kind,
)  # fmt: skip
def test_an_event_is_a_sentence(told: EventAnswer, words: str) -> None:
    assert WORDS.sentence(told) == words
    assert event_line(told, told.at, WORDS).endswith(words)


def test_a_sentence_shows_no_key_and_no_id_of_a_known_thing() -> None:
    told = event("object taken", "cup", "person-1", **FOR_PROGRAMS)
    assert not re.search(r"person-1|by_|\bx \d|0\.503", WORDS.sentence(told))
    kept = detailed_event_line(told, told.at)
    assert "by distance 0.503" in kept and "person-1" in kept and "x 11.9" in kept


def test_what_another_line_says_better_is_left_out() -> None:
    told = [
        event("object taken", "cup", source="cabinet"),
        event("object taken", "cup", "person-1", evidence="cabinet: reports it", sources="cabinet"),
        event("person standing ended", "person-1"),
        event("person walking", "person-1", evidence="floor-1: moves"),
        event("door opened", "refrigerator", source="refrigerator"),
    ]
    assert worth_reading(told) == [told[1], told[3], told[4]]


@pytest.mark.parametrize(
    ("fact", "words"),
    [
        ({"power": 1420.0}, "1420 W"),
        ({"contents": "cup"}, "contents cup"),
        ({"is_open": True}, "is open yes"),
        ({"some_value": 12345.6}, "some value 12346"),
    ],
)
def test_a_fact_is_said_with_its_unit(fact: Mapping[str, float | str], words: str) -> None:
    ((key, value),) = fact.items()
    assert fact_words(key, value) == words
