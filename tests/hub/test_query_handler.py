"""The room answers: where things are and were, what is in them, what happened."""

from __future__ import annotations

import pytest

from housefly.errors import ThingError, WireError
from housefly.hub.api.json import question_from_json, refusal_to_json
from housefly.hub.api.questions import (
    CatalogueQuestion,
    ContentsQuestion,
    EventsQuestion,
    NearQuestion,
    PictureQuestion,
    SensorsQuestion,
    TrajectoryQuestion,
    WhereQuestion,
)
from housefly.messages import RoomEvent
from housefly.sensors.contracts import SensorHealth


def test_where_a_thing_is_is_told_with_who_says_so_and_how_long_ago(house) -> None:
    house.see("drone", 3.0, (2.0, 3.0, 1.1))
    answer = house.ask(WhereQuestion("drone"))
    assert (answer.position, answer.age, answer.sources) == ((2.0, 3.0, 1.1), 3.0, ("vicon",))
    assert answer.words == "the drone: at (2.00, 3.00, 1.10) m, last seen 3 s ago by vicon"


def test_a_height_of_nothing_has_no_minus(house) -> None:
    house.see("drone", 3.0, (2.0, 3.0, -0.001))
    assert "at (2.00, 3.00, 0.00) m" in house.ask(WhereQuestion("drone")).words


def test_a_thing_in_a_thing_is_where_that_is_and_its_containers_are_named(house) -> None:
    house.see("cup", 100.0, inside="cabinet", source="cabinet")
    answer = house.ask(WhereQuestion("mug"))
    assert answer.inside == ("cabinet", "kitchen")
    assert answer.by_container == "cabinet"
    assert answer.position == (11.5, 4.2, 0.6)


def test_where_it_was_is_answered_from_the_past(house) -> None:
    house.see("drone", 600.0, (2.0, 3.0, 1.0))
    house.see("drone", 5.0, (9.0, 3.0, 1.0))
    assert house.ask(WhereQuestion("drone", at=house.now - 300.0)).position == (2.0, 3.0, 1.0)
    assert house.ask(WhereQuestion("drone")).position == (9.0, 3.0, 1.0)


def test_the_id_counts_before_another_things_alias(house) -> None:
    assert house.ask(WhereQuestion("cabinet")).thing == "cabinet"


def test_what_nobody_knows_is_refused_with_a_suggestion(house) -> None:
    with pytest.raises(ThingError, match="cabinet"):
        house.ask(WhereQuestion("cabnet"))
    with pytest.raises(ThingError, match="there are: person"):
        house.ask(CatalogueQuestion("animal"))


def test_what_is_in_it_and_near_it(house) -> None:
    house.see("drone", 1.0, (11.0, 4.2, 1.0))
    assert [placed.thing for placed in house.ask(ContentsQuestion("kitchen")).things] == [
        "cabinet",
        "cup",
    ]
    near = house.ask(NearQuestion(1.0, thing="drone")).things
    assert [(placed.thing, round(placed.distance, 2)) for placed in near] == [
        ("cabinet", 0.64),
        ("cup", 0.64),
    ]
    assert house.ask(NearQuestion(0.1, x=1.0, y=1.0)).things == ()


def test_the_catalogue_is_listed_by_kind(house) -> None:
    assert [thing.thing for thing in house.ask(CatalogueQuestion("object")).things] == ["cup"]


def test_the_way_of_a_thing_between_two_times(house) -> None:
    for second in range(10):
        house.see("drone", 10.0 - second, (float(second), 0.0, 1.0))
    rows = house.ask(TrajectoryQuestion("drone", house.now - 8.5, house.now - 4.5)).rows
    assert [x for _, x, _, _ in rows] == [2.0, 3.0, 4.0, 5.0]


def test_what_happened_is_listed_by_thing_kind_and_time(house, noon: float) -> None:
    for ago, kind, thing in (
        (90.0, "door opened", "cabinet"),
        (60.0, "bell pressed", "drone"),
        (30.0, "door closed", "cabinet"),
    ):
        house.memory.add(RoomEvent(kind, thing, noon - ago, "test", "somebody"))
    assert [event.kind for event in house.ask(EventsQuestion(thing="cabinet")).events] == [
        "door opened",
        "door closed",
    ]
    assert [
        event.kind
        for event in house.ask(EventsQuestion(since=noon - 70.0, until=noon - 50.0)).events
    ] == ["bell pressed"]
    assert [event.kind for event in house.ask(EventsQuestion(limit=1)).events] == ["door closed"]


def test_a_picture_of_the_past_holds_what_was_known_then(house) -> None:
    house.see("cup", 600.0, (1.0, 2.0, 0.8), source="floor")
    house.see("cup", 5.0, inside="cabinet", source="cabinet")
    then = {
        placed.thing: placed for placed in house.ask(PictureQuestion(at=house.now - 300.0)).things
    }
    now = {placed.thing: placed for placed in house.ask(PictureQuestion()).things}
    assert then["cup"].position == (1.0, 2.0, 0.8)
    assert (now["cup"].inside, now["cup"].position) == ("cabinet", (11.5, 4.2, 0.6))


def test_sensors_that_were_never_heard_have_no_age(house) -> None:
    house.status.add_health_source(
        lambda: (SensorHealth("door", "door", "Door", False, problem="never heard"),)
    )
    (sensor,) = house.ask(SensorsQuestion()).sensors
    assert (sensor.age, sensor.problem) == (None, "never heard")


@pytest.mark.parametrize(
    ("text", "key"),
    [
        ('{"ask":"where"}', "thing"),
        ('{"ask":"where","thing":"a","at":-1}', "at"),
        ('{"ask":"near","radius":0}', "radius"),
        ('{"ask":"near","radius":1,"x":1e9}', "x"),
        ('{"ask":"events","limit":0}', "limit"),
        ('{"ask":"dance"}', "ask"),
        ("[1", "question"),
    ],
)
def test_a_bad_question_is_refused_naming_the_key(text: str, key: str) -> None:
    with pytest.raises(WireError, match=key if key != "ask" else "dance|tag"):
        question_from_json(text)


def test_a_refusal_says_whether_the_thing_is_unknown() -> None:
    assert '"unknown": true' in refusal_to_json(ThingError("no"))
    assert '"unknown": false' in refusal_to_json(WireError("no"))
