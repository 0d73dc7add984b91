"""What happened is told as people would tell it, by person, thing, flight and task."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.api.answers import EventAnswer
from housefly.hub.api.feed_answers import FeedEntry
from housefly.hub.api.told_events import TOLD_EVENT_KINDS, TOLD_EVENT_SOURCE
from housefly.hub.feed.grouping import GAP, grouped
from housefly.hub.feed.steps import IS_OF_PERSON
from housefly.hub.flight_facts import PILOT
from housefly.hub.said import situation_words
from housefly.messages.words import Words, literal

KINDS = sorted({*IS_OF_PERSON, "object taken", "object put", "door opened", "bell pressed", "odd"})


class Names:
    """Of a room with a kitchen."""

    def name(self, thing: str) -> str:
        return {"person-1": "the resident", "cup": "the cup", "cabinet": "the cabinet"}.get(
            thing, thing
        )

    def spot(self, x: float, y: float) -> str:
        return "Kitchen" if x < 5.0 else ""


def event(
    kind: str,
    thing: str,
    at: float,
    source: str = "situations/people",
    cause: str = "",
    **facts: Any,
) -> EventAnswer:
    words = facts.get("words") if source == PILOT else None
    said = words or situation_words(kind)
    return EventAnswer(kind, thing, at, source, cause, 1.0, facts, literal(said))


def told(*events: EventAnswer, topic: Any = None) -> list[tuple[str, str]]:
    return [(str(one.name), str(one.words)) for one in grouped(events, Names(), topic)]


def person(kind: str, at: float, **facts: Any) -> EventAnswer:
    return event(f"person {kind}", "person-1", at, **facts)


def task(kind: str, at: float, **facts: Any) -> EventAnswer:
    facts = {"task": 7.0, "service": "visitor"} | facts
    return event(kind, "ardrone", at, TOLD_EVENT_SOURCE, "task 7", **facts)


def pilot(kind: str, at: float, cause: str = "", **facts: Any) -> EventAnswer:
    return event(kind, "ardrone", at, PILOT, cause, **facts)


def test_where_somebody_went_is_one_line() -> None:
    assert told(
        person("walking", 0.0, x=9.0, y=1.0),
        person("standing", 5.0, x=1.0, y=1.0),
        person("standing ended", 20.0),
        person("walking", 20.0, x=2.0, y=1.0),
        person("standing", 25.0, x=1.0, y=1.0),
        person("sitting", 60.0, on="sofa seat 0"),
    ) == [("the resident", "kitchen, then sofa")]
    assert told(person("walking", 0.0, x=9.0, y=1.0)) == [("the resident", "walking")]


def test_after_a_pause_it_is_told_anew() -> None:
    first, second = person("sitting", 0.0, on="sofa"), person("lying", GAP + 1.0, on="bed")
    assert [words for _, words in told(first, second)] == ["bed", "sofa"]


def test_who_may_have_fallen_is_an_alarm() -> None:
    found = grouped([person("standing", 0.0, x=1.0, y=1.0), person("fallen", 9.0)], Names())
    assert [(str(one.words), one.alarms) for one in found] == [
        ("kitchen, then may have fallen", True)
    ]


def test_a_thing_that_is_taken_and_put_is_told_once_with_who_has_it() -> None:
    by = {"source": "situations/objects", "cause": "person-1", "evidence": "cabinet: reports it"}
    assert told(
        event("object taken", "cup", 0.0, "cabinet"),
        event("object taken", "cup", 0.0, **by, **{"from": "cabinet"}),  # type: ignore[arg-type]
        event("object put", "cup", 9.0, **by),  # type: ignore[arg-type]
    ) == [("the cup", "with the resident, then put down")]
    assert told(event("appliance on", "stove", 0.0), event("appliance on ended", "stove", 4.0)) == [
        ("stove", "on, then off")
    ]


def test_a_task_is_one_entry_with_its_pictures_and_says_how_it_ended() -> None:
    events = [
        event("bell pressed", "doorbell", 0.0, "doorbell"),
        task("task asked", 1.0, title="See who is at the door", by="rule bell"),
        task("person asked", 1.1, words="Fly?"),
        task("task started", 5.0, title="See who is at the door"),
        pilot("flight started", 6.0, "task 7: visitor"),
        pilot("looking", 20.0, goal="Entrance"),
        task("clip kept", 30.0, clip="c-1"),
        task("snapshot kept", 31.0, clip="s-1"),
        pilot("flight ended", 47.0),
        task("task ended", 48.0, words="the visitor was seen", outcome="done"),
        task("clip deleted", 60.0, clip="c-1"),
    ]
    entries = grouped(events, Names())
    assert [(str(one.name), str(one.words), one.pictures) for one in entries] == [
        ("See who is at the door", "the visitor was seen", ("s-1",)),
        ("doorbell", "rang", ()),
    ]
    said = task("said", 47.5, words="At the entrance: the visitor")
    ends = [task("task ended", 48.0, words="done", outcome=one) for one in ("done", "failed")]
    assert told(*events[:4], said, ends[0])[0][1] == "At the entrance: the visitor"
    assert told(*events[:4], said, ends[1])[0][1] == "done"
    assert told(*events[:3])[0][1] == "asked for by rule bell"
    assert told(*events, topic="drone") == [("ardrone", "Entrance, 41 s in the air")]


def test_a_flight_of_a_person_and_what_is_wrong_with_the_drone_are_told() -> None:
    begun = [pilot("flight started", 0.0, "kim"), pilot("order accepted", 1.0, words="go")]
    assert told(*begun) == [("ardrone", "in the air")]
    warned = pilot("low battery", 9.0, severity="warning", words=Words("battery low"))
    (found,) = grouped([*begun, replace(warned, at=8.0, words=literal("hot")), warned], Names())
    assert (str(found.words), found.alarms) == ("in the air, battery low", True)


def test_each_mode_that_is_set_is_told_with_who_did_it() -> None:
    set_by = [
        event("mode changed", "house", at, TOLD_EVENT_SOURCE, "kim", mode=mode, before="home")
        for at, mode in ((1.0, "night"), (2.0, "home"))
    ]
    assert [words for _, words in told(*set_by)] == ["home (kim)", "night (kim)"]


def entries_of(rows: list[tuple[str, str, float]]) -> tuple[FeedEntry, ...]:
    events = [event(kind, thing, at) for kind, thing, at in sorted(rows, key=lambda row: row[2])]
    return grouped(events, Names())


@given(
    st.lists(
        st.tuples(
            st.sampled_from(KINDS),
            st.sampled_from(["person-1", "cup", "door"]),
            st.floats(0.0, 86400.0),
        ),
        max_size=60,
    )
)
def test_whatever_happens_entries_are_newest_first_say_something_and_are_told_apart(
    rows: list[tuple[str, str, float]],
) -> None:
    found = entries_of(rows)
    assert [one.at for one in found] == sorted((one.at for one in found), reverse=True)
    assert all(one.words and one.began_at <= one.at for one in found)
    keys = [(one.of, one.thing, one.began_at) for one in found]
    assert len(keys) == len(set(keys))


@given(st.sampled_from(sorted(TOLD_EVENT_KINDS)), st.booleans())
def test_whatever_the_tasks_tell_is_taken_without_its_facts(kind: str, has_task: bool) -> None:
    facts = {"task": 1.0} if has_task else {}
    grouped([event(kind, "ardrone", 0.0, TOLD_EVENT_SOURCE, **facts)], Names())
