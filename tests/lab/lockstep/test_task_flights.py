"""Each shipped service flown by the very pilot in the simulated room, scored on the truth."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import hypot, inf

import pytest
from task_flights import flown, premises, scene_of

from housefly.evidence.clip_values import StartClip, TakeSnapshot
from housefly.geometry import distance
from housefly.lab.lockstep.task_flight import TaskFlight, TaskScript
from housefly.messages import Order, OrderKind
from housefly.tasks.api.values import ReasonCode, TaskStage
from housefly.tasks.execution.values import AskPerson, GiveOrder, Report, Say, StopClip


def words(flight: TaskFlight, kind: type[Report] | type[Say]) -> list[str]:
    return [
        one.action.words for one in flight.actions_of(kind) if isinstance(one.action, Report | Say)
    ]


def seen_share(flight: TaskFlight, name: str, start: float, end: float) -> float:
    """Return the share of the samples between two times [s] whose picture shows somebody."""
    shown = [name in one.picture for one in flight.samples if start <= one.at <= end]
    return sum(shown) / len(shown)


def assert_home_and_clean(flight: TaskFlight) -> None:
    assert flight.contacts == ()
    assert flight.is_on_pad and flight.off_pad < 0.15
    assert flight.clearance > 0.15


def person(
    name: str, *steps: Mapping[str, object], start: tuple[float, float]
) -> dict[str, object]:
    return {"name": name, "start": list(start), "steps": list(steps)}


STANDS: dict[str, object] = {"do": "wait", "seconds": 600.0}


@pytest.fixture(scope="module")
def visitor() -> TaskFlight:
    """Return the visitor service with somebody at the door."""
    return flown("visitor", TaskScript(reply_time=6.0))


def test_the_visitor_is_filmed_and_the_drone_comes_home(visitor: TaskFlight) -> None:
    assert (visitor.stage, visitor.code) == (TaskStage.DONE, ReasonCode.OK)
    assert_home_and_clean(visitor)
    (snapshot,) = visitor.actions_of(TakeSnapshot)
    assert snapshot.picture["visitor"] > 0.08
    (start,), (end,) = visitor.actions_of(StartClip), visitor.actions_of(StopClip)
    assert end.at - start.at > 5.0
    assert seen_share(visitor, "visitor", start.at, end.at) == 1.0
    assert any("visitor" in line for line in words(visitor, Say))


def test_the_visitor_is_faced_and_not_the_door(visitor: TaskFlight) -> None:
    (snapshot,) = visitor.actions_of(TakeSnapshot)
    going = [one.action.order for one in visitor.actions_of(GiveOrder)]  # type: ignore[union-attr]
    last = [order for order in going if order.kind is OrderKind.GO][-1]
    room = premises().room
    assert room.visitor is not None and last.look_at is not None
    assert distance(last.look_at[:2], room.visitor) < 0.3
    assert 1.2 < last.look_at[2] < 1.8
    assert distance(snapshot.place, room.visitor) > 1.6


def test_the_first_picture_comes_within_a_third_more_than_the_planned_flight(
    visitor: TaskFlight,
) -> None:
    planned = premises().plan("entrance").duration
    assert planned is not None
    (start,) = visitor.actions_of(StartClip)
    assert visitor.airborne_at is not None
    assert start.at - visitor.airborne_at < 1.3 * planned + 5.0


@pytest.mark.interop
def test_without_a_visitor_the_door_is_shown_and_that_is_said() -> None:
    flight = flown("visitor", loaded=premises(twin__visitor_present=False))
    assert flight.stage is TaskStage.DONE
    assert_home_and_clean(flight)
    (snapshot,) = flight.actions_of(TakeSnapshot)
    assert snapshot.picture["entrance door"] > 0.1 and "visitor" not in snapshot.picture
    assert any("nobody" in line for line in words(flight, Say))


@pytest.mark.parametrize(
    ("subject", "seen"),
    [("refrigerator", "refrigerator"), pytest.param("TV", "tv", marks=pytest.mark.interop)],
)
def test_a_thing_or_a_place_is_in_the_picture(subject: str, seen: str) -> None:
    flight = flown("look", subject=subject, time=1.0)
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    assert flight.actions_of(TakeSnapshot)[0].picture[seen] > 0.05


def test_what_nobody_knows_is_refused_on_the_ground() -> None:
    flight = flown("look", memory=True, subject="the blue elephant")
    assert flight.stage is TaskStage.FAILED and flight.airborne_at is None
    assert flight.code is ReasonCode.UNKNOWN_THING


def test_where_answers_from_memory_and_flies_only_when_that_is_wanted() -> None:
    flight = flown("where", memory=True, thing="refrigerator", look="never")
    assert flight.stage is TaskStage.DONE and flight.airborne_at is None
    assert any("refrigerator" in line.lower() for line in words(flight, Report))


def test_a_search_shows_a_picture_of_where_the_thing_may_be_and_asks() -> None:
    seen = TaskScript(replies={"seen": "yes"})
    flight = flown("find", seen, thing="cup", wait=5.0)
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    assert len(flight.actions_of(AskPerson)) == len(flight.actions_of(TakeSnapshot)) == 1
    (line,) = words(flight, Report)
    assert line.startswith("Somebody sees cup in the picture: ")
    (snapshot,) = flight.actions_of(TakeSnapshot)
    place = line.partition(": the ")[2].partition(" and ")[0]
    assert place == "floor" or any(place in thing for thing in snapshot.picture)


def test_a_patrol_shows_each_place_and_says_which_it_could_not() -> None:
    flight = flown("patrol", places="sofa, nowhere, tv", dwell=1.0)
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    sofa, tv = flight.actions_of(TakeSnapshot)
    assert sofa.picture["sofa"] > 0.1 and tv.picture["tv"] > 0.1
    assert sum("nowhere" in line for line in words(flight, Report)) == 1


@pytest.mark.safety
def test_a_room_without_named_places_is_gone_round_by_its_floor() -> None:
    loaded = premises()
    room = replace(loaded.room, places=(loaded.room.place("home"),))
    quick = {"hover_max": 1.0, "pictures": False}
    flight = flown("patrol", loaded=replace(loaded, room=room), options=quick, dwell=1.0)
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    assert len(flight.actions_of(TakeSnapshot)) > 4


def test_come_flies_to_a_person_and_keeps_its_distance() -> None:
    scene = scene_of(person("anna", STANDS, start=(8.6, 3.6)))
    flight = flown("come", scene=scene, person="anna", stay=8.0)
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    (asked,) = flight.actions_of(AskPerson)
    assert asked.picture["anna"] > 0.03
    people = premises().site.people
    assert min(one.person for one in flight.samples) > people.min_distance


def test_follow_keeps_a_walking_person_in_view_and_never_overhead() -> None:
    walk: list[dict[str, object]] = [
        {"do": "wait", "seconds": 14.0},
        {"do": "go", "to": [5.6, 4.1], "speed": 0.5},
        STANDS,
    ]
    scene = scene_of(person("anna", *walk, start=(9.6, 4.3)))
    flight = flown("follow", scene=scene, person="anna", time=20.0)
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    start = next(at for at, name in flight.began if name == "follow")
    assert seen_share(flight, "anna", start, start + 20.0) > 0.6
    assert min(one.person for one in flight.samples) > 0.4


@pytest.mark.safety
def test_who_vanishes_is_missed_though_the_memory_keeps_their_place() -> None:
    steps: list[dict[str, object]] = [{"do": "wait", "seconds": 18.0}, {"do": "vanish"}]
    scene = scene_of(person("anna", *steps, start=(8.6, 3.6)))
    flight = flown("follow", scene=scene, memory=True, person="anna", time=60.0)
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    assert [line.partition(":")[0] for line in words(flight, Say)] == [
        "Anna was not seen for 3 s", "Anna is lost", "Lost sight of them",
    ]  # fmt: skip
    waits, looks, comes_home = (one.at for one in flight.actions_of(Say))
    assert 19.0 < waits < 24.0 and 6.0 < looks - waits < 9.0 and 9.0 < comes_home - looks < 12.0


@pytest.mark.interop
def test_an_inventory_lists_what_is_inside_with_a_picture() -> None:
    flight = flown("inventory", memory=True, subject="refrigerator")
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    assert flight.actions_of(TakeSnapshot)[0].picture["refrigerator"] > 0.03


def test_somebody_on_the_floor_is_looked_at_and_a_person_is_asked() -> None:
    falls = (
        {"do": "go", "to": [8.6, 3.7]},
        {"do": "lie", "at": [8.2, 3.6], "yaw": 0.3, "height": 0.0, "seconds": 300.0},
    )
    scene = scene_of(person("anna", *falls, start=(9.4, 3.8)))
    silent = TaskScript(silent=True)
    flight = flown(
        "all_right", silent, scene=scene, memory=True, options={"begin_at": 30.0, "hover_max": 3.0}
    )
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    (snapshot,) = flight.actions_of(TakeSnapshot)
    assert snapshot.picture["anna"] > 0.01
    assert any("look after" in line for line in words(flight, Say))  # nobody answered


def test_when_everybody_is_well_nothing_flies() -> None:
    scene = scene_of(person("anna", STANDS, start=(9.4, 3.8)))
    flight = flown("all_right", scene=scene, memory=True, options={"begin_at": 5.0})
    assert flight.stage is TaskStage.DONE and flight.airborne_at is None
    assert words(flight, Say) == ["Nobody seems to need help"]


@pytest.mark.interop
def test_the_night_round_looks_at_the_places_it_is_given() -> None:
    flight = flown("night_round", memory=True, places="tv")
    assert flight.stage is TaskStage.DONE, flight.words
    assert_home_and_clean(flight)
    assert flight.actions_of(TakeSnapshot)[0].picture["tv"] > 0.05


def is_defined_end(flight: TaskFlight) -> bool:
    """Return whether the task says how it ended and the drone stands untouched on its pad."""
    ended = flight.stage in (TaskStage.DONE, TaskStage.CANCELLED, TaskStage.FAILED)
    return ended and flight.stands and flight.is_on_pad and flight.contacts == ()


@pytest.mark.parametrize("at", [3.0, 25.0])
def test_a_cancelled_visitor_flight_comes_home(at: float) -> None:
    flight = flown("visitor", TaskScript(cancel_at=at, silent=True))
    assert (flight.stage, flight.code) == (TaskStage.CANCELLED, ReasonCode.CANCELLED)
    assert is_defined_end(flight)
    later = [one for one in flight.actions if one.at > at + 0.5]
    assert not any(isinstance(one.action, StartClip | TakeSnapshot) for one in later)
    assert len(flight.actions_of(StartClip)) == len(flight.actions_of(StopClip))


def test_a_paused_flight_hovers_and_goes_on() -> None:
    flight = flown("look", TaskScript(pause_at=9.0, resume_at=19.0), subject="tv", time=1.0)
    assert flight.stage is TaskStage.DONE and is_defined_end(flight)
    still = [one.place for one in flight.samples if 13.0 < one.at < 18.5]
    assert max(hypot(x - still[0][0], y - still[0][1]) for x, y in still) < 0.25
    assert flight.actions_of(TakeSnapshot)[0].at > 19.0


def test_a_person_who_takes_over_ends_the_task_and_is_not_fought() -> None:
    script = TaskScript(orders=((8.0, Order(OrderKind.LAND)),))
    flight = flown("look", script, subject="tv")
    assert (flight.stage, flight.code) == (TaskStage.CANCELLED, ReasonCode.PERSON_TOOK_OVER)
    assert flight.stands and flight.contacts == ()
    assert all(one.at < 8.3 for one in flight.actions_of(GiveOrder))


@pytest.mark.interop
def test_hovering_that_is_not_flown_is_added_in_time_and_charge() -> None:
    whole = flown("come", scene=(alone := scene_of(person("anna", STANDS, start=(8.6, 3.6)))),
                  script=TaskScript(silent=True), person="anna", stay=30.0)  # fmt: skip
    short = flown("come", scene=alone, script=TaskScript(silent=True), person="anna", stay=30.0,
                  options={"hover_max": 2.0})  # fmt: skip
    assert short.skipped > 20.0 and whole.skipped == 0.0
    assert short.ended_at == pytest.approx(whole.ended_at, abs=8.0)
    assert short.charge == pytest.approx(whole.charge, rel=0.2)
    assert whole.clearance < inf
