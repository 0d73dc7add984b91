"""No source that is no person fills the queue, and none takes the place of what a person wants."""

from __future__ import annotations

from dataclasses import replace

import pytest

from housefly.tasks.api.values import (
    Confirm,
    Priority,
    ReasonCode,
    RequestSurface,
    TaskRequest,
    TaskStage,
)
from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.values import (
    DroneAvailability,
    RunReport,
    ScheduledTask,
    SchedulerLimits,
    TaskEnded,
    TaskTraits,
)

LOOK = TaskTraits("look")
LIMITS = SchedulerLimits(queue=6, per_source=3, alarms=2)
MQTT, RULE, ASSISTANT = RequestSurface.MQTT, RequestSurface.RULE, RequestSurface.ASSISTANT
KIM = TaskRequest("look", {"n": 0.0}, "kim", owner="~kim")


def asked(scheduler: Scheduler, *requests: TaskRequest) -> tuple[Scheduler, list[ScheduledTask]]:
    """Return the queue after requests, each for something else, and what ended."""
    ended = []
    for request in requests:
        number = float(scheduler.next_id)
        scheduler, decisions = scheduler.requested(
            replace(request, parameters={"n": number}), LOOK, number
        )
        ended += [one.task for one in decisions if isinstance(one, TaskEnded)]
    return scheduler, ended


def by(surface: RequestSurface, **more: object) -> TaskRequest:
    given = {"asked_by": "x", "owner": "", "surface": surface, **more}
    return replace(KIM, **given)  # type: ignore[arg-type]


def askers(scheduler: Scheduler) -> list[str]:
    return [task.asker for task in scheduler.tasks]


@pytest.mark.parametrize("surface", [MQTT, RULE, ASSISTANT, RequestSurface.WEBHOOK])
@pytest.mark.parametrize("confirm", [Confirm.ASK, Confirm.AUTO])
def test_a_source_that_is_no_person_has_so_many_waiting_and_no_more(
    surface: RequestSurface, confirm: Confirm
) -> None:
    scheduler, ended = asked(Scheduler(LIMITS), *[by(surface, confirm=confirm)] * 5)
    assert len(scheduler.tasks) == 3
    assert [(task.stage, task.code) for task in ended] == [
        (TaskStage.REFUSED, ReasonCode.QUEUE_FULL)
    ] * 2
    assert ended[0].words == f"3 tasks of {surface.value} wait already; answer or cancel one"
    scheduler, ended = asked(scheduler, KIM)
    assert not ended and "kim" in askers(scheduler)


def test_names_that_a_source_gives_itself_make_it_no_other_source() -> None:
    requests = [by(MQTT, asked_by=f"panel {k}", owner=f"mqtt panel-{k}") for k in range(5)]
    scheduler, ended = asked(Scheduler(LIMITS), *requests)
    assert (len(scheduler.tasks), len(ended)) == (3, 2)


def test_what_a_person_asks_for_finds_room_among_what_no_person_asked_for() -> None:
    scheduler, _ = asked(Scheduler(LIMITS), *[by(MQTT)] * 3, *[by(ASSISTANT)] * 3)
    assert len(scheduler.tasks) == 6
    scheduler, ended = asked(scheduler, *[KIM] * 6)
    assert askers(scheduler) == ["kim"] * 6 and len(ended) == 6
    assert all(task.code is ReasonCode.QUEUE_FULL for task in ended)


@pytest.mark.parametrize("priority", Priority)
@pytest.mark.parametrize("surface", [MQTT, RULE, ASSISTANT])
def test_nothing_takes_a_persons_place_but_a_person(
    surface: RequestSurface, priority: Priority
) -> None:
    background = replace(KIM, priority=Priority.BACKGROUND)
    scheduler, _ = asked(Scheduler(LIMITS), *[background] * 6)
    scheduler, ended = asked(scheduler, *[by(surface, priority=priority)] * 4)
    assert not [task for task in ended if task.asker == "kim"]
    assert askers(scheduler)[:6] == ["kim"] * 6
    spare = 2 if priority is Priority.ALARM else 0
    assert len(scheduler.tasks) == 6 + spare, "an alarm has room of its own"
    scheduler, ended = asked(scheduler, replace(KIM, asked_by="ann", owner="~ann"))
    assert len(ended) == 1 and "ann" in askers(scheduler)


def test_who_may_only_ask_leaves_room_for_others() -> None:
    scheduler, ended = asked(Scheduler(LIMITS), *[replace(KIM, confirm=Confirm.ASK)] * 5)
    assert len(scheduler.tasks) == 3
    assert ended[0].words == "3 tasks of kim wait already; answer or cancel one"
    namesake = replace(KIM, confirm=Confirm.ASK, owner="another browser")
    assert not asked(scheduler, namesake)[1], "the same name is not the same person"


def test_what_a_person_wants_too_is_a_persons() -> None:
    scheduler, _ = Scheduler(LIMITS).requested(by(MQTT, confirm=Confirm.ASK), LOOK, 0.0)
    scheduler, _ = scheduler.requested(KIM, LOOK, 1.0)
    (task,) = scheduler.tasks
    assert (task.asker, task.lane, task.is_attended) == ("kim", "~kim", True)
    assert task.stage is TaskStage.QUEUED


def test_people_of_one_name_take_turns_like_others() -> None:
    ready = DroneAvailability(True)
    two = replace(KIM, owner="~kim at another browser")
    scheduler, _ = asked(Scheduler(LIMITS), KIM, KIM, KIM, two)
    flown = []
    for now in range(10, 14):
        scheduler, _ = scheduler.ticked(float(now), (), ready)
        flying = next(task for task in scheduler.tasks if task.started_at == now)
        flown.append(flying.lane)
        scheduler, _ = scheduler.cancelled(flying.id, "", float(now))
        done = RunReport(flying.id, TaskStage.DONE)
        scheduler, _ = scheduler.ticked(float(now), (done,), DroneAvailability(False))
    assert flown.index("~kim at another browser") == 1
