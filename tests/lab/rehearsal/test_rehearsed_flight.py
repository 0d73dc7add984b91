"""Rehearsals: what may fly, what to expect, and what is refused before anything moves."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import pytest
from task_flights import premises, shipped

from housefly.errors import LinkError
from housefly.hub.api.questions import Question
from housefly.lab.lockstep.task_flight import TaskFlight
from housefly.lab.rehearsal.rehearsed_flight import RehearsedSite
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.messages import Obstacle
from housefly.record.truth import ContactRecord
from housefly.tasks.api.values import ReasonCode, RehearsalReport, TaskStage
from housefly.tasks.document.library import bind, read_task
from housefly.tasks.execution.task_room import SeenPerson

VISITOR = SeenPerson("visitor", (0.85, 4.2, 0.0), (0.0, 0.0), 0.1)


def nobody(question: Question) -> Any:
    raise LinkError("nobody remembers anything")


@cache
def rehearsed() -> RehearsedSite:
    return RehearsedSite(premises())


def rehearse(service: str, now: RoomNow | None = None, **parameters: Any) -> RehearsalReport:
    return rehearsed().rehearse(shipped(service, **parameters), now or RoomNow(), nobody)


def wall_across_corridor() -> tuple[Obstacle, ...]:
    """Return boxes that close the way to the entrance."""
    return tuple(
        Obstacle(f"box-{n}", (4.2, 3.5 + 0.35 * n), 0.25, source="laser-1", top=1.6)
        for n in range(5)
    )


def test_the_visitor_service_may_fly_and_says_what_to_expect() -> None:
    report = rehearse("visitor", RoomNow(people=(VISITOR,)))
    assert report.may_fly and report.code is ReasonCode.OK
    planned = premises().plan("entrance").duration
    assert planned is not None and report.duration is not None and report.charge is not None
    stay = 45.0
    assert 2.0 * planned < report.duration - stay < 2.0 * planned + 30.0
    assert report.charge == pytest.approx(report.duration / 600.0, rel=0.4)
    assert report.shortest == pytest.approx(report.duration - stay)
    assert f"takes {report.shortest:.0f} to {report.duration:.0f} s" in report.words
    assert report.clearance is not None and 0.2 < report.clearance < 0.5
    assert report.first_look is not None and planned < report.first_look < 1.3 * planned + 8.0
    assert min(x for x, _ in report.way) < 3.3 and len(report.way) > 50


def test_a_long_hover_is_added_and_said() -> None:
    report = rehearse("look", subject="tv", time=240.0)
    assert report.may_fly and report.duration is not None and report.duration > 240.0
    assert "hovering on the spot" in report.words
    assert report.charge is not None and report.charge > 0.33


@pytest.mark.parametrize(
    ("service", "parameters", "now", "code", "said"),
    [
        ("look", {"subject": "the moon"}, RoomNow(), ReasonCode.UNKNOWN_THING, "the moon"),
        ("look", {"subject": "tv"}, RoomNow(battery=0.19), ReasonCode.BATTERY, "charge"),
        (
            "look",
            {"subject": "entrance"},
            RoomNow(obstacles=wall_across_corridor()),
            ReasonCode.NO_WAY,
            "no free way",
        ),
    ],
    ids=["unknown", "battery", "way"],
)
def test_what_cannot_be_done_is_refused_in_one_sentence_before_any_flight(
    service: str, parameters: dict[str, Any], now: RoomNow, code: ReasonCode, said: str
) -> None:
    report = rehearse(service, now, **parameters)
    assert not report.may_fly and report.code is code
    assert said in report.words and "\n" not in report.words
    assert report.first_look is None and report.took < 1.0


def test_hovering_too_long_for_the_battery_is_refused() -> None:
    report = rehearse("look", RoomNow(battery=0.4), subject="tv", time=240.0)
    assert (report.may_fly, report.code) == (False, ReasonCode.BATTERY)


def of_text(steps: str, now: RoomNow | None = None) -> RehearsalReport:
    task = bind(read_task(f"name: t\nsteps:\n{steps}\n"), {})
    return rehearsed().rehearse(task, now or RoomNow(), nobody)


@pytest.mark.interop
def test_a_question_may_take_all_its_time_and_that_is_counted_before_take_off() -> None:
    """Answered at once it would fly; nobody says that it is."""
    report = rehearse("visitor", RoomNow(people=(VISITOR,), battery=0.5), stay=300.0)
    assert (report.may_fly, report.code) == (False, ReasonCode.BATTERY)
    assert report.duration is not None and report.duration > 300.0


def test_what_is_waited_for_may_never_come() -> None:
    """The room says at once that it is so; in the flight it may be otherwise."""
    free = of_text(
        "  - take_off\n  - wait: {time: 90 s, until: {not: {set: reply}}}\n  - ask: well"
    )
    assert free.may_fly and free.duration is not None and free.duration > 150.0


ASKS = (
    "  - take_off\n  - ask: {question: More, choices: [table, moon, no, never], wait: 5 s}\n"
    "  - if: {reply: {equals: table}}\n    then: [{go_to: {point: [9.55, 1.65]}}]\n"
    "  - if: {reply: {equals: never}}\n    then: [fail: Never]\n"
)
"""Nobody answers, and it never ends well; three other answers lead to three ways more."""


def test_every_answers_way_is_rehearsed() -> None:
    """Nobody answers, and it comes home; the way that another answer leads to counts as well."""
    report = of_text(ASKS)
    assert report.may_fly and "3 ways" in report.words, report.words
    assert max(abs(x - 10.55) for x, _ in report.way) > 0.8


def test_an_answer_that_leads_nowhere_is_refused_and_named() -> None:
    refused = of_text(ASKS + "  - if: {reply: {equals: moon}}\n    then: [look_at: the moon]")
    assert (refused.may_fly, refused.code) == (False, ReasonCode.UNKNOWN_THING)
    assert "if 'moon' is answered to 'More'" in refused.words


def test_a_task_that_only_ever_fails_does_not_fly() -> None:
    never = of_text("  - take_off\n  - fail: never")
    assert (never.may_fly, never.code, never.words) == (False, ReasonCode.STEP_FAILED, "never")


def test_a_step_that_fails_is_not_taken_for_the_documents_own_end() -> None:
    report = of_text(
        "  - take_off\n  - ask: {question: Milk, wait: 2 s}\n"
        "  - if: {reply: {equals: yes}}\n    then: [{find: milk}]\n"
        "  - if: {set: other}\n    then: [{fail: $other}]\n"
        "  - return_home\n  - ask: {question: Else, wait: 1 s, as: other}"
    )
    assert (report.may_fly, report.code) == (False, ReasonCode.STEP_FAILED), report.words
    assert "nobody remembers" in report.words


@pytest.mark.interop
def test_more_answers_than_can_be_rehearsed_are_refused() -> None:
    """Nothing flies here, so the ways are many but short."""
    many = "".join(
        f"  - ask: {{question: q, wait: 1 s, as: q{n}}}\n"
        f"  - if: {{reply: {{to: q{n}, equals: yes}}}}\n    then: [report: y]\n"
        for n in range(4)
    )
    report = of_text(many + "  - if: {set: q0}\n    then: [report: z]\n    else: [take_off]")
    assert (report.may_fly, report.code) == (False, ReasonCode.TOO_LONG)


@pytest.mark.parametrize(
    "steps",
    [
        "  - ask: {question: Where, choices: [moon, tv], wait: 5 s}\n  - look_at: $reply",
        pytest.param(
            "  - timeout: 4 s\n    do:\n      - ask: {question: Moon, wait: 30 s}\n"
            "      - {if: {reply: {equals: yes}}, then: [{look_at: moon}]}\n"
            "    otherwise: [{say: too late}]",
            marks=pytest.mark.interop,
        ),
    ],
    ids=["the answer is where it goes", "the question is given up before its time"],
)
def test_an_answers_way_that_only_an_early_one_or_a_name_leads_to_is_rehearsed(steps: str) -> None:
    report = of_text(f"  - take_off\n{steps}")
    assert (report.may_fly, report.code) == (False, ReasonCode.UNKNOWN_THING), report.words


def test_a_drone_in_the_air_is_rehearsed_from_where_it_hovers() -> None:
    height = premises().site.map.flight_height
    there = RoomNow(drone=(8.5, 1.7, height), yaw=0.0, is_airborne=True)
    report = of_text("  - snapshot\n  - go_to: {point: [8.0, 2.0]}\n  - return_home", there)
    assert report.may_fly, report.words
    x, y = report.way[0]
    assert abs(x - 8.5) < 0.2 and abs(y - 1.7) < 0.2
    assert report.first_look == 0.0  # no take-off before it


def test_live_obstacles_are_flown_around() -> None:
    box = Obstacle("box", (9.0, 1.9), 0.3, source="laser-1", top=1.6)
    free = rehearse("look", subject="table", time=1.0)
    around = rehearse("look", RoomNow(obstacles=(box,)), subject="table", time=1.0)
    assert free.may_fly and around.may_fly
    nearest = min(((x - 9.0) ** 2 + (y - 1.9) ** 2) ** 0.5 for x, y in around.way)
    assert nearest > 0.3 + 0.2259


def test_a_task_that_flies_nothing_may_always_run() -> None:
    text = "name: hello\ntitle: Hello\nabout: Says hello.\nsteps:\n  - say: hello\n"
    report = rehearsed().rehearse(bind(read_task(text, "hello.yaml"), {}), RoomNow(), nobody)
    assert report.may_fly and report.duration == 0.0


def test_a_rehearsal_that_takes_too_long_is_no_yes() -> None:
    task = shipped("look", subject="entrance")
    report = rehearsed().rehearse(task, RoomNow(), nobody, limit=0.05)
    assert (report.may_fly, report.code) == (False, ReasonCode.NOT_READY)


TOUCH = ContactRecord(12.0, "furniture", "sofa", 0.3, 1.0, 0.2, True)
_EMPTY = ((), (), (), (), ())
GOOD = TaskFlight(
    TaskStage.DONE, ReasonCode.OK, "done", 50.0, *_EMPTY, 0.01, True, 0.1, 50.0, 0.0, 0.07
)


@pytest.mark.parametrize(
    ("flight", "code"),
    [
        (GOOD, ReasonCode.OK),
        (replace(GOOD, contacts=(TOUCH,)), ReasonCode.SAFETY),
        (replace(GOOD, off_pad=1.4), ReasonCode.SAFETY),
        (replace(GOOD, stands=False), ReasonCode.SAFETY),
        (
            replace(GOOD, stage=TaskStage.FAILED, code=ReasonCode.NO_WAY, words="shut"),
            ReasonCode.NO_WAY,
        ),
        (replace(GOOD, stage=TaskStage.RUNNING, words=""), ReasonCode.TOO_LONG),
        (replace(GOOD, charge=0.9), ReasonCode.BATTERY),
    ],
    ids=["good", "touch", "elsewhere", "in the air", "failed", "endless", "empty"],
)
def test_only_a_whole_clean_flight_back_to_the_pad_is_a_yes(
    monkeypatch: pytest.MonkeyPatch, flight: TaskFlight, code: ReasonCode
) -> None:
    monkeypatch.setattr(
        "housefly.lab.rehearsal.rehearsed_flight.fly_task_lockstep", lambda *_, **__: flight
    )
    report = rehearse("look", subject="tv")
    assert report.code is code and report.may_fly is (code is ReasonCode.OK)
    assert report.words
