"""The service that looks for a lost thing: what it flies, asks and claims."""

from __future__ import annotations

from dataclasses import replace

import pytest
from scripted_pilot import UNIX_BEGIN, Flight, ScriptedPilot, ScriptedRoom, ScriptedSearch, view

from housefly.errors import TaskError
from housefly.evidence.clip_values import TakeSnapshot
from housefly.geometry import Vec3
from housefly.hub.api.answers import AlternativePlace, WhereAnswer
from housefly.messages import OrderKind, OrderOutcome
from housefly.pilot.behavior.mission import Refused
from housefly.tasks.api.values import ReasonCode, TaskStage
from housefly.tasks.document.binding import bind
from housefly.tasks.document.library import load_library
from housefly.tasks.execution.search_step import LOOKS_MAX
from housefly.tasks.execution.task_run import TaskRun
from housefly.tasks.execution.values import AskPerson, PersonReply, Report, Say

LIBRARY = load_library()
CUP = WhereAnswer(
    thing="cup",
    name="the cup",
    kind="object",
    words="the cup: on the sofa table",
    position=(1.0, 1.0, 1.0),
    yaw=None,
    std=0.1,
    inside=(),
    by_container="",
    seen_at=UNIX_BEGIN,
    age=600.0,
    sources=(),
    said=(),
)
PLACES = ("the sofa table", "the kitchen", "the floor")


class SearchedRoom(ScriptedRoom):
    """A search is kept, to be looked at afterwards."""

    begun: ScriptedSearch

    def search(self, thing: str, drone: Vec3 | None, look_time: float) -> ScriptedSearch:
        self.begun = ScriptedSearch(list(self.looks))
        return self.begun


def searched(
    answer: WhereAnswer | None = CUP, places: tuple[str, ...] = PLACES
) -> tuple[Flight, SearchedRoom]:
    known = SearchedRoom(answers={("where", "cup"): answer} if answer else {})
    known.looks = [view(place, 1.0 + n, 0.0) for n, place in enumerate(places)]
    task = bind(LIBRARY["find"], {"thing": "cup", "wait": 5.0})
    return Flight(TaskRun(task, known), ScriptedPilot()), known


def flown(flight: Flight, *replies: str) -> list[str]:
    """Fly to the end; the questions get these replies, one each. Returns the reports."""
    left, asked = list(replies), 0
    for _ in range(9000):
        new = flight.of(AskPerson)[asked:]
        asked += len(new)
        reply = (PersonReply("seen", left.pop(0), "kim"),) if new and left else ()
        flight.tick(reply)
        if flight.run.is_over:
            break
    assert flight.run.stage is TaskStage.DONE, flight.run.words
    assert flight.stands_on_pad()
    return [action.words for action in flight.of(Report)]


def test_a_person_who_sees_it_in_the_second_picture_ends_the_search() -> None:
    flight, known = searched()
    told = flown(flight, "no", "yes")
    assert told == ["The cup: on the sofa table", "Somebody sees cup in the picture: the kitchen"]
    assert known.begun.shown == [("the sofa table", True)]
    goals = [order.goal for order in flight.orders if order.kind is OrderKind.GO]
    assert goals == [(1.0, 0.0), (2.0, 0.0)]
    assert len(flight.of(TakeSnapshot)) == 2


def test_what_nobody_sees_is_not_found_and_what_was_not_looked_at_is_said() -> None:
    flight, known = searched()
    told = flown(flight, "no", "no", "no")
    assert told[1:] == [
        "The cup was not found; the pictures cover 60 % of where it may be",
        "Looked at: the sofa table, the kitchen, the floor",
    ]
    assert all(nothing for _, nothing in known.begun.shown)
    assert not any("sees" in words for words in told)


@pytest.mark.parametrize("replies", [(), ("I cannot tell",) * 3])
def test_silence_finds_nothing_and_rules_nothing_out(replies: tuple[str, ...]) -> None:
    flight, known = searched()
    told = flown(flight, *replies)
    assert not any(nothing for _, nothing in known.begun.shown)
    assert any(
        words.startswith("For 60 % nobody said whether it is in the pictures") for words in told
    )
    assert len(flight.of(AskPerson)) == 3


def test_what_a_sensor_sees_now_is_found_on_the_ground() -> None:
    flight, _ = searched(replace(CUP, age=1.0))
    told = flown(flight)
    assert told[1] == "The sensors of the room have it now: the cup: on the sofa table"
    assert flight.of(TakeSnapshot) == [] and OrderKind.GO not in [o.kind for o in flight.orders]


@pytest.mark.parametrize(
    "answer",
    [
        replace(CUP, age=1.0, by_container="cabinet"),
        replace(CUP, age=1.0, position=None),
        replace(CUP, age=1.0, alternatives=(AlternativePlace("left", "bed", None, 0.4),)),
        replace(CUP, age=None),
    ],
)
def test_what_the_memory_only_concludes_is_not_found_by_it(answer: WhereAnswer) -> None:
    flight, _ = searched(answer)
    told = flown(flight, "yes")
    assert not any("sensors" in words for words in told)
    assert len(flight.of(TakeSnapshot)) == 1


def test_what_the_memory_does_not_know_is_looked_for_all_the_same() -> None:
    flight, _ = searched(None)
    assert flown(flight, "yes")[-1] == "Somebody sees cup in the picture: the sofa table"


def test_a_place_without_a_way_is_left_out_and_told() -> None:
    flight, known = searched()
    flight.pilot.refuses = Refused(OrderOutcome.NO_WAY, "there is no way to it")
    while flight.run._context.orders.answer is None:
        flight.tick()
    flight.pilot.refuses = None
    told = flown(flight, "no", "no")
    assert known.begun.skipped == ["the sofa table"]
    assert told[-1] == "Not looked at: the sofa table (20 %)"
    assert len(flight.of(TakeSnapshot)) == 2


def test_a_search_has_an_end_however_many_places_there_are() -> None:
    flight, known = searched(places=tuple(f"place {n}" for n in range(20)))
    flown(flight, *["no"] * 20)
    assert len(known.begun.shown) == LOOKS_MAX


def test_a_search_that_is_cancelled_comes_home() -> None:
    flight, _ = searched()
    while not flight.of(AskPerson):
        flight.tick()
    flight.run.cancel("enough")
    flight.fly()
    assert (flight.run.stage, flight.run.code) == (TaskStage.CANCELLED, ReasonCode.CANCELLED)
    assert flight.stands_on_pad() and len(flight.of(TakeSnapshot)) == 1


def test_what_cannot_be_searched_for_is_refused_on_the_ground() -> None:
    class Refusing(SearchedRoom):
        def search(self, thing: str, drone: Vec3 | None, look_time: float) -> ScriptedSearch:
            raise TaskError("the bed is furniture: ask to look at it", "bad_parameter")

    flight = Flight(TaskRun(bind(LIBRARY["find"], {"thing": "bed"}), Refusing()), ScriptedPilot())
    flight.fly()
    assert (flight.run.stage, flight.run.code) == (TaskStage.FAILED, ReasonCode.BAD_PARAMETER)
    assert flight.orders == [] and flight.of(Say) == []
