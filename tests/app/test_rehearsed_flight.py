"""Rehearsals: what may fly, what to expect, and what is refused before anything moves."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import pytest
from task_flights import premises, shipped

from housefly.app.rehearsed_flight import RehearsedSite
from housefly.app.room_now import RoomNow
from housefly.app.task_flight import TaskFlight
from housefly.errors import LinkError
from housefly.hub.api.questions import Question
from housefly.messages import Obstacle
from housefly.record.truth import ContactRecord
from housefly.tasks.api.values import ReasonCode, RehearsalReport, TaskStage
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
    assert 2.0 * planned < report.duration < 2.0 * planned + 30.0
    assert report.charge == pytest.approx(report.duration / 600.0, rel=0.4)
    assert report.clearance is not None and 0.2 < report.clearance < 0.5
    assert report.first_look is not None and planned < report.first_look < 1.3 * planned + 8.0
    assert min(x for x, _ in report.way) < 3.3 and len(report.way) > 50


def test_a_long_hover_is_added_and_said() -> None:
    report = rehearse("look", subject="tv", time=240.0)
    assert report.may_fly and report.duration is not None and report.duration > 240.0
    assert "hovering that was added" in report.words
    assert report.charge is not None and report.charge > 0.35


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


def test_live_obstacles_are_flown_around() -> None:
    box = Obstacle("box", (9.0, 1.9), 0.3, source="laser-1", top=1.6)
    free = rehearse("look", subject="table", time=1.0)
    around = rehearse("look", RoomNow(obstacles=(box,)), subject="table", time=1.0)
    assert free.may_fly and around.may_fly
    nearest = min(((x - 9.0) ** 2 + (y - 1.9) ** 2) ** 0.5 for x, y in around.way)
    assert nearest > 0.3 + 0.2259


def test_a_task_that_flies_nothing_may_always_run() -> None:
    from housefly.tasks.document.library import bind, read_task

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
    monkeypatch.setattr("housefly.app.rehearsed_flight.fly_task_lockstep", lambda *_, **__: flight)
    report = rehearse("look", subject="tv")
    assert report.code is code and report.may_fly is (code is ReasonCode.OK)
    assert report.words
