"""Who flies when: priorities, turns, pre-emption, questions, bounds."""

from __future__ import annotations

from collections import Counter, deque
from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import TaskError
from housefly.tasks.api.values import (
    Confirm,
    OnPreempt,
    Priority,
    ReasonCode,
    RehearsalReport,
    RequestSurface,
    TaskRequest,
    TaskStage,
)
from housefly.tasks.scheduler.board import board_order, waiting_words
from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.values import (
    CONFIRM,
    CancelRun,
    DroneAvailability,
    PreemptTask,
    ResumeTask,
    RunReport,
    ScheduledTask,
    SchedulerLimits,
    StartTask,
    TaskAdmitted,
    TaskEnded,
    TaskMerged,
    TaskTraits,
)

READY, CHARGING = DroneAvailability(True), DroneAvailability(False, "the drone charges (43 %)")
LIMITS = SchedulerLimits()


def request(
    service: str,
    by: str = "ann",
    priority: Priority = Priority.PERSON,
    confirm: Confirm = Confirm.AUTO,
    deadline: float | None = None,
) -> TaskRequest:
    return TaskRequest(service, asked_by=by, priority=priority, confirm=confirm, deadline=deadline)


def take(
    scheduler: Scheduler, *requests: TaskRequest, now: float = 0.0, flies: bool = True
) -> Scheduler:
    for each in requests:
        traits = TaskTraits(each.service.title(), flies=flies)
        scheduler, _ = scheduler.requested(each, traits, now)
    return scheduler


def flown_order(scheduler: Scheduler, now: float = 1.0) -> list[ScheduledTask]:
    """Return the tasks as they fly, each of them at once done."""
    order, runs = [], []
    while scheduler.tasks:
        started = {task.id: task for task in scheduler.tasks}
        scheduler, decisions = scheduler.ticked(now, runs, READY)
        ids = [each.id for each in decisions if isinstance(each, StartTask)]
        order += [started[each] for each in ids]
        runs = [RunReport(each, TaskStage.DONE) for each in ids]
    return order


def ended(decisions: tuple[object, ...]) -> list[ScheduledTask]:
    return [each.task for each in decisions if isinstance(each, TaskEnded)]


@given(st.lists(st.sampled_from("abcd"), max_size=20))
def test_those_who_ask_at_once_are_served_in_turns(askers: list[str]) -> None:
    scheduler = take(Scheduler(), *(request(f"{n}", by) for n, by in enumerate(askers)))
    lanes = {by: deque(n for n, each in enumerate(askers) if each == by) for by in askers}
    rounds = []
    while any(lanes.values()):
        rounds.append(sorted(lane.popleft() for lane in lanes.values() if lane))
    flown = [task.asker for task in flown_order(scheduler)]
    first = 0
    for group in rounds:  # in each round everybody is served once
        served = flown[first : first + len(group)]
        assert Counter(served) == Counter(askers[n] for n in group)
        first += len(group)


def test_one_who_asks_for_twenty_does_not_keep_another_waiting() -> None:
    scheduler = take(Scheduler(), *(request(f"{n}", "ann") for n in range(19)))
    scheduler = take(scheduler, request("bell", "bob"))
    assert [task.asker for task in flown_order(scheduler)[:3]] == ["ann", "bob", "ann"]


def test_a_task_that_waits_is_never_passed_for_ever() -> None:
    scheduler = take(Scheduler(), request("first"), request("second"))
    runs: list[RunReport] = []
    for number in range(200):  # somebody else asks again and again
        scheduler = take(scheduler, request(f"{number}", by=f"visitor {number}"))
        scheduler, decisions = scheduler.ticked(1.0, runs, READY)
        begun = [each.id for each in decisions if isinstance(each, StartTask)]
        if 2 in begun:
            break
        runs = [RunReport(each, TaskStage.DONE) for each in begun]
    assert number <= LIMITS.queue + 2


@given(st.permutations(list(Priority)))
def test_the_more_urgent_flies_first(priorities: list[Priority]) -> None:
    scheduler = take(Scheduler(), *(request(each.value, priority=each) for each in priorities))
    flown = [task.request.priority for task in flown_order(scheduler)]
    assert flown == list(Priority)


def test_a_patrol_makes_way_for_an_alarm_at_a_safe_point_and_goes_on_afterwards() -> None:
    scheduler = take(Scheduler(), request("patrol", priority=Priority.RULE))
    scheduler, decisions = scheduler.ticked(1.0, (), READY)
    assert decisions == (StartTask(1),)
    scheduler = take(scheduler, request("alarm", priority=Priority.ALARM))
    scheduler, decisions = scheduler.ticked(2.0, (RunReport(1),), READY)
    assert decisions == ()
    safe = (RunReport(1, is_safe_point=True),)
    scheduler, decisions = scheduler.ticked(3.0, safe, READY)
    assert decisions == (PreemptTask(1, is_kept=True), StartTask(2))
    assert scheduler.task(1).stage is TaskStage.SUSPENDED
    scheduler = take(scheduler, request("look", priority=Priority.RULE))
    scheduler, decisions = scheduler.ticked(4.0, (RunReport(2, TaskStage.DONE),), READY)
    assert [task.id for task in ended(decisions)] == [2]
    assert decisions[-1] == ResumeTask(1)
    assert scheduler.task(1).started_at == 1.0


def test_what_has_begun_goes_on_before_an_equal_begins() -> None:
    rule = Priority.RULE
    scheduler = take(Scheduler(), request("look", priority=rule), request("patrol", priority=rule))
    scheduler, _ = scheduler.paused(1, "ann", 0.0)
    scheduler, decisions = scheduler.ticked(1.0, (), READY)
    assert decisions == (StartTask(2),)
    scheduler, _ = scheduler.continued(1, "ann", 2.0)
    scheduler = take(scheduler, request("alarm", priority=Priority.ALARM))
    scheduler, _ = scheduler.ticked(3.0, (RunReport(2, is_safe_point=True),), READY)
    scheduler, decisions = scheduler.ticked(4.0, (RunReport(3, TaskStage.DONE),), READY)
    assert decisions[-1] == ResumeTask(2)


def test_equals_do_not_take_the_drone_from_each_other() -> None:
    scheduler = take(Scheduler(), request("look"), request("patrol"))
    scheduler, _ = scheduler.ticked(1.0, (), READY)
    safe = (RunReport(1, is_safe_point=True),)
    assert scheduler.ticked(2.0, safe, READY) == (scheduler, ())


def test_a_drone_that_is_not_ready_takes_the_drone_from_nobody() -> None:
    scheduler = take(Scheduler(), request("look"))
    scheduler, _ = scheduler.ticked(1.0, (), READY)
    scheduler = take(scheduler, request("alarm", priority=Priority.ALARM))
    safe = (RunReport(1, is_safe_point=True),)
    assert scheduler.ticked(2.0, safe, CHARGING) == (scheduler, ())


def test_what_does_not_fly_runs_beside_up_to_a_bound() -> None:
    scheduler = take(Scheduler(), request("patrol"))
    scheduler = take(scheduler, *(request(f"{n}") for n in range(6)), flies=False)
    scheduler, decisions = scheduler.ticked(1.0, (), CHARGING)
    assert decisions == tuple(StartTask(each) for each in (2, 3, 4, 5))
    scheduler, decisions = scheduler.ticked(2.0, (RunReport(3, TaskStage.DONE),), READY)
    assert decisions[1:] == (StartTask(6), StartTask(1))


def test_a_task_is_asked_about_flies_on_yes_and_ends_on_no_or_silence() -> None:
    asking = take(Scheduler(), request("look", confirm=Confirm.ASK), now=10.0)
    question = asking.task(1).question
    assert question is not None and question.id == CONFIRM and question.otherwise == "no"
    assert question.words == "Fly 'Look'? Asked for by ann." and question.until == 130.0
    assert asking.ticked(11.0, (), READY) == (asking, ())
    agreed, _ = asking.replied(1, "yes", "bob", 12.0)
    assert agreed.ticked(13.0, (), READY)[1] == (StartTask(1),)
    (task,) = ended(asking.replied(1, "no", "bob", 12.0)[1])
    assert (task.stage, task.code) == (TaskStage.REFUSED, ReasonCode.DECLINED)
    assert task.words == "bob said no"
    (task,) = ended(asking.ticked(130.0, (), READY)[1])
    assert (task.stage, task.code) == (TaskStage.EXPIRED, ReasonCode.NO_ANSWER)


@pytest.mark.parametrize("of_request", Confirm)
@pytest.mark.parametrize("of_document", Confirm)
def test_the_stricter_of_request_and_document_counts(
    of_request: Confirm, of_document: Confirm
) -> None:
    traits = TaskTraits("Look", confirm=of_document)
    _, decisions = Scheduler().requested(request("look", confirm=of_request), traits, 0.0)
    (decision,) = decisions
    assert isinstance(decision, TaskAdmitted | TaskEnded)
    both = (of_request, of_document)
    expected = (
        TaskStage.REFUSED
        if Confirm.NEVER in both
        else TaskStage.WAITING
        if Confirm.ASK in both
        else TaskStage.QUEUED
    )
    assert decision.task.stage is expected


def test_no_assistant_makes_anything_fly_without_a_yes() -> None:
    asked = TaskRequest("look", surface=RequestSurface.ASSISTANT, priority=Priority.ALARM)
    waits = take(Scheduler(), asked)
    assert waits.task(1).stage is TaskStage.WAITING
    assert take(waits, asked).task(1).stage is TaskStage.WAITING
    assert take(Scheduler(), asked, flies=False).task(1).stage is TaskStage.QUEUED


def test_what_waited_long_for_the_drone_asks_again_instead_of_starting() -> None:
    scheduler = take(Scheduler(), request("look"))
    scheduler, decisions = scheduler.ticked(LIMITS.fresh_time + 1.0, (), CHARGING)
    assert decisions == () and scheduler.task(1).stage is TaskStage.QUEUED
    scheduler, decisions = scheduler.ticked(LIMITS.fresh_time + 2.0, (), READY)
    task = scheduler.task(1)
    assert decisions == () and task.stage is TaskStage.WAITING
    assert task.question is not None and task.question.words == "Fly 'Look'? It waited long."
    scheduler, _ = scheduler.replied(1, "yes", "ann", 700.0)
    assert scheduler.ticked(701.0, (), READY)[1] == (StartTask(1),)


def test_what_was_suspended_for_long_asks_before_it_goes_on() -> None:
    scheduler = take(Scheduler(), request("patrol", priority=Priority.RULE))
    scheduler, _ = scheduler.ticked(1.0, (), READY)
    scheduler = take(scheduler, request("alarm", priority=Priority.ALARM), now=500.0)
    scheduler, _ = scheduler.ticked(501.0, (RunReport(1, is_safe_point=True),), READY)
    _, decisions = scheduler.ticked(1000.0, (RunReport(2, TaskStage.DONE),), READY)
    assert decisions[-1] == ResumeTask(1)  # it flew until 501 s
    late, decisions = scheduler.ticked(1200.0, (RunReport(2, TaskStage.DONE),), READY)
    assert len(decisions) == 1 and late.task(1).stage is TaskStage.WAITING
    agreed, _ = late.replied(1, "yes", "ann", 1201.0)
    assert agreed.ticked(1202.0, (), READY)[1] == (ResumeTask(1),)


def test_a_clock_that_was_set_back_far_makes_nothing_fresh() -> None:
    scheduler = take(Scheduler(), request("look"), now=5000.0)
    assert scheduler.ticked(4999.5, (), READY)[1] == (StartTask(1),)
    asked, decisions = scheduler.ticked(1000.0, (), READY)
    assert decisions == () and asked.task(1).stage is TaskStage.WAITING


def test_a_deadline_ends_what_has_not_begun_and_nothing_else() -> None:
    scheduler = take(Scheduler(), request("look", deadline=100.0))
    (task,) = ended(scheduler.ticked(100.0, (), READY)[1])
    assert (task.stage, task.code) == (TaskStage.EXPIRED, ReasonCode.DEADLINE)
    begun, _ = scheduler.ticked(99.0, (), READY)
    assert begun.ticked(200.0, (), READY) == (begun, ())
    (task,) = ended(Scheduler().requested(request("x", deadline=0.0), TaskTraits("X"), 1.0)[1])
    assert (task.stage, task.code) == (TaskStage.EXPIRED, ReasonCode.DEADLINE)


def test_the_same_asked_for_twice_is_one_task_that_says_so() -> None:
    scheduler = take(Scheduler(), request("look", "ann", Priority.RULE, deadline=100.0))
    again, decisions = scheduler.requested(
        request("look", "bob", deadline=200.0), TaskTraits("Look"), 10.0
    )
    (merged,) = decisions
    assert isinstance(merged, TaskMerged) and again.tasks == (merged.task,)
    assert merged.task.words == "also asked for by bob" and again.next_id == scheduler.next_id
    assert merged.task.request.priority is Priority.PERSON
    assert merged.task.request.deadline == 200.0 and merged.task.fresh_at == 10.0
    begun, _ = again.ticked(11.0, (), READY)
    assert len(take(begun, request("look")).tasks) == 2  # what flies is not what waits


def test_a_second_request_that_needs_a_yes_makes_nothing_fly_sooner_or_later() -> None:
    scheduler = take(Scheduler(), request("look", "ann", Priority.RULE, deadline=100.0))
    asked = request("look", "assistant", Priority.ALARM, Confirm.ASK)
    again = take(scheduler, asked, now=50.0)
    before, after = scheduler.task(1), again.task(1)
    assert after.request == before.request and after.fresh_at == before.fresh_at
    waits = take(Scheduler(), asked)
    assert take(waits, asked).task(1).stage is TaskStage.WAITING
    assert take(waits, request("look", "ann")).task(1).stage is TaskStage.QUEUED


def test_a_full_queue_refuses_and_only_the_more_urgent_finds_room() -> None:
    limits = SchedulerLimits(queue=3)
    scheduler = take(Scheduler(limits), *(request(f"{n}") for n in range(3)))
    after, decisions = scheduler.requested(request("one more"), TaskTraits("One more"), 1.0)
    (task,) = ended(decisions)
    assert (task.stage, task.code) == (TaskStage.REFUSED, ReasonCode.QUEUE_FULL)
    assert after.tasks == scheduler.tasks and after.next_id == task.id + 1
    alarm = request("alarm", priority=Priority.ALARM)
    after, decisions = scheduler.requested(alarm, TaskTraits("Alarm"), 1.0)
    (gone,) = ended(decisions)
    assert gone.id == 3 and gone.words == "the queue was full, it made way for 'Alarm'"
    assert [task.id for task in after.tasks] == [1, 2, 4]


def test_cancelling_ends_what_waits_at_once_and_lets_what_flies_come_home() -> None:
    scheduler = take(Scheduler(), request("look"), request("patrol"))
    scheduler, _ = scheduler.ticked(1.0, (), READY)
    scheduler, decisions = scheduler.cancelled(0, "ann", 2.0)
    assert decisions[0] == CancelRun(1, "ann cancelled it")
    assert [task.id for task in ended(decisions)] == [2]
    assert scheduler.task(1).stage is TaskStage.RUNNING
    home = RunReport(1, TaskStage.CANCELLED, ReasonCode.CANCELLED, "ann cancelled it")
    scheduler, decisions = scheduler.ticked(9.0, (home,), READY)
    assert [task.stage for task in ended(decisions)] == [TaskStage.CANCELLED]
    with pytest.raises(TaskError, match="no open task has the number 1") as raised:
        scheduler.cancelled(1, "ann", 10.0)
    assert raised.value.code == ReasonCode.UNKNOWN_TASK.value


def test_a_second_cancel_reaches_the_run_that_comes_home() -> None:
    """It leaves out the rest of what is done on a cancel."""
    scheduler, _ = take(Scheduler(LIMITS), request("look")).ticked(1.0, [], READY)
    scheduler, first = scheduler.cancelled(1, "ann", 2.0)
    scheduler, second = scheduler.cancelled(1, "bob", 3.0)
    assert (*first, *second) == (
        CancelRun(1, "ann cancelled it"), CancelRun(1, "bob cancelled it"),
    )  # fmt: skip
    assert [task.stage for task in scheduler.tasks] == [TaskStage.RUNNING]


def test_what_is_paused_in_the_air_and_pre_empted_waits_for_a_person_to_continue_it() -> None:
    scheduler = take(Scheduler(), request("patrol", priority=Priority.RULE))
    scheduler, _ = scheduler.ticked(1.0, (), READY)
    scheduler, _ = scheduler.paused(1, "ann", 2.0)
    scheduler = take(scheduler, request("alarm", priority=Priority.ALARM))
    safe = (RunReport(1, TaskStage.PAUSED, is_safe_point=True),)
    scheduler, decisions = scheduler.ticked(3.0, safe, READY)
    assert decisions == (PreemptTask(1, is_kept=True), StartTask(2))
    scheduler, decisions = scheduler.ticked(4.0, (RunReport(2, TaskStage.DONE),), READY)
    assert len(decisions) == 1 and scheduler.task(1).stage is TaskStage.PAUSED
    scheduler, _ = scheduler.continued(1, "ann", 5.0)
    assert scheduler.ticked(6.0, (), READY)[1] == (ResumeTask(1),)


@pytest.mark.parametrize(
    ("then", "stage", "code"),
    [
        (OnPreempt.END, TaskStage.CANCELLED, ReasonCode.PREEMPTED),
        (OnPreempt.RESTART, TaskStage.QUEUED, ReasonCode.OK),
    ],
)
def test_what_does_not_resume_loses_its_run(
    then: OnPreempt, stage: TaskStage, code: ReasonCode
) -> None:
    patrol = request("patrol", priority=Priority.RULE)
    scheduler, _ = Scheduler().requested(patrol, TaskTraits("Patrol", on_preempt=then), 0.0)
    scheduler, _ = scheduler.ticked(1.0, (), READY)
    scheduler = take(scheduler, request("alarm", priority=Priority.ALARM))
    scheduler, decisions = scheduler.ticked(2.0, (RunReport(1, is_safe_point=True),), READY)
    assert decisions[0] == PreemptTask(1, is_kept=False) and decisions[-1] == StartTask(2)
    (task,) = ended(decisions) or [scheduler.task(1)]
    assert (task.stage, task.code, task.words) == (stage, code, "'Alarm' took the drone")


def test_a_rehearsal_that_finds_no_way_refuses_what_waits_and_is_kept_otherwise() -> None:
    scheduler = take(Scheduler(), request("look"))
    good = RehearsalReport(True, ReasonCode.OK, "20 s")
    kept, decisions = scheduler.rehearsed(1, good, 1.0)
    assert decisions == () and kept.task(1).rehearsal == good
    bad = RehearsalReport(False, ReasonCode.NO_WAY, "a chair stands in the door")
    (task,) = ended(scheduler.rehearsed(1, bad, 1.0)[1])
    assert (task.stage, task.code, task.words) == (TaskStage.REFUSED, bad.code, bad.words)
    assert task.rehearsal == bad


def test_after_a_restart_what_flew_has_failed_and_what_would_fly_asks() -> None:
    scheduler = take(Scheduler(), request("patrol"), request("look"))
    scheduler, _ = scheduler.ticked(1.0, (), READY)
    scheduler, decisions = scheduler.restarted(5000.0)
    (failed,) = ended(decisions)
    assert (failed.id, failed.stage, failed.code) == (1, TaskStage.FAILED, ReasonCode.RESTARTED)
    assert failed.words.endswith("nothing starts again without a fresh order")
    question = scheduler.task(2).question
    assert question is not None and question.until == 5120.0
    assert scheduler.ticked(5001.0, (), READY) == (scheduler, ())
    again, _ = scheduler.restarted(5100.0)  # a second restart gives as much time again
    question = again.task(2).question
    assert question is not None and question.until == 5220.0


def test_people_are_told_in_which_order_tasks_fly_and_why_they_wait() -> None:
    scheduler = take(Scheduler(), request("patrol"), request("look"), request("bell", "bob"))
    assert waiting_words(scheduler, CHARGING) == {
        1: "the drone charges (43 %)",
        3: "the drone charges (43 %); 1 before it",
        2: "the drone charges (43 %); 2 before it",
    }
    scheduler, _ = scheduler.ticked(1.0, (), READY)
    assert [task.id for task in board_order(scheduler)] == [1, 3, 2]
    assert waiting_words(scheduler, READY)[3] == "'Patrol' has the drone"


@given(st.lists(st.tuples(st.sampled_from("ab"), st.sampled_from(Priority)), max_size=12))
def test_tasks_fly_in_the_order_that_people_are_told(asked: list[tuple[str, Priority]]) -> None:
    requests = (request(f"{n}", by, priority) for n, (by, priority) in enumerate(asked))
    scheduler = take(Scheduler(), *requests)
    told = [task.id for task in board_order(scheduler)]
    assert [task.id for task in flown_order(scheduler)] == told


@given(st.lists(st.sampled_from("ab"), min_size=2, max_size=12), st.data())
def test_an_askers_own_requests_stay_in_order_whatever_is_cancelled(
    askers: list[str], data: st.DataObject
) -> None:
    scheduler = take(Scheduler(), *(request(f"{n}", by) for n, by in enumerate(askers)))
    for number in data.draw(st.sets(st.integers(1, len(askers)), max_size=4)):
        scheduler, _ = scheduler.cancelled(number, "", 1.0)
    scheduler = take(scheduler, request("last", "a"), request("very last", "b"))
    flown = flown_order(scheduler)
    for by in "ab":
        own = [task.id for task in flown if task.asker == by]
        assert all(one < other for one, other in pairwise(own))


RED = DroneAvailability(True, name="red", place=(0.0, 0.0))
BLUE = DroneAvailability(True, name="blue", place=(9.0, 0.0))


def drones_of(scheduler: Scheduler) -> dict[str, str]:
    """Return which drone flies what."""
    return {task.drone: task.request.service for task in scheduler.tasks if task.drone}


def test_two_drones_fly_two_tasks_at_once_and_the_third_waits_for_whichever_is_free() -> None:
    scheduler = take(Scheduler(), request("look"), request("patrol"), request("visit"))
    scheduler, decisions = scheduler.ticked(1.0, (), RED, BLUE)
    assert decisions == (StartTask(1), StartTask(2))
    assert drones_of(scheduler) == {"red": "look", "blue": "patrol"}
    words = waiting_words(scheduler, RED, BLUE)
    assert words == {3: "red: 'Look' has the drone; blue: 'Patrol' has the drone"}
    scheduler, decisions = scheduler.ticked(2.0, (RunReport(2, TaskStage.DONE),), RED, BLUE)
    assert StartTask(3) in decisions and drones_of(scheduler) == {"red": "look", "blue": "visit"}


@pytest.mark.parametrize(("goal", "nearest"), [((1.0, 0.0), "red"), ((8.0, 0.0), "blue")])
def test_the_nearest_free_drone_flies_what_any_may_fly(
    goal: tuple[float, float], nearest: str
) -> None:
    report = RehearsalReport(True, ReasonCode.OK, "", way=((4.0, 3.0), goal, (4.0, 3.0)))
    scheduler, _ = take(Scheduler(), request("look")).rehearsed(1, report, 0.5)
    scheduler, _ = scheduler.ticked(1.0, (), RED, BLUE)
    assert drones_of(scheduler) == {nearest: "look"}


def test_what_one_drone_is_asked_for_waits_for_it_and_holds_up_no_other() -> None:
    wanted = replace(request("look"), drone="red")
    away = DroneAvailability(False, "it charges", "red")
    scheduler = take(Scheduler(), wanted, request("patrol"))
    scheduler, decisions = scheduler.ticked(1.0, (), away, BLUE)
    assert decisions == (StartTask(2),) and drones_of(scheduler) == {"blue": "patrol"}
    assert waiting_words(scheduler, away, BLUE)[1] == "red: it charges"
    scheduler, decisions = scheduler.ticked(2.0, (), RED, BLUE)
    assert decisions == (StartTask(1),) and drones_of(scheduler)["red"] == "look"


def test_what_was_set_aside_goes_on_with_its_own_drone() -> None:
    scheduler = take(Scheduler(), request("look", priority=Priority.BACKGROUND))
    scheduler, _ = scheduler.ticked(1.0, (), RED)
    alarm = replace(request("alarm", priority=Priority.ALARM), drone="red")
    scheduler = take(scheduler, alarm, now=2.0)
    scheduler, decisions = scheduler.ticked(3.0, (RunReport(1, is_safe_point=True),), RED, BLUE)
    assert decisions == (PreemptTask(1, is_kept=True), StartTask(2))
    assert scheduler.ticked(4.0, (), RED, BLUE)[1] == (), "blue has nothing to do with it"
    _, decisions = scheduler.ticked(5.0, (RunReport(2, TaskStage.DONE),), RED, BLUE)
    assert ResumeTask(1) in decisions


def test_who_flies_one_drone_by_hand_leaves_what_waits_for_the_other_alone() -> None:
    scheduler = take(Scheduler(), *(replace(request(name), drone=name) for name in ("red", "blue")))
    scheduler, _ = scheduler.taken_over(1.0, "red")
    assert [task.question is not None for task in scheduler.tasks] == [True, False]
