"""The task service as a whole: asked in JSON, driven by ticks, on real parts."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from filming import video
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from task_stage import GOOD, TaskStage

from housefly.config.house_mode import HouseMode
from housefly.errors import TaskError
from housefly.evidence.clip_result import ClipOrigin, ClipOutcome, ClipResult
from housefly.evidence.clip_store import new_clip_row
from housefly.evidence.clip_values import ClipsQuestion, DeleteClip, KeepClip
from housefly.messages import DroneStatus, Order, OrderKind, OrderSource, Phase, RoomEvent
from housefly.tasks.api.answers import TASK_ANSWER_TYPES
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    ChangeRule,
    ContinueTask,
    DryRunQuestion,
    PauseTask,
    RehearseTask,
    ReplyToTask,
    RequestTask,
    RulesQuestion,
    Sentence,
    ServicesQuestion,
    SetMode,
    TakePhoto,
    TaskHistoryQuestion,
    TaskQuestion,
    Webhook,
)
from housefly.tasks.api.values import ENDED, Priority, ReasonCode, RehearsalReport, RequestSurface
from housefly.tasks.api.values import (
    TaskStage as Stage,
)
from housefly.tasks.engine.drone_state import TakeOffReadiness
from housefly.tasks.execution.task_run import TaskRun
from housefly.tasks.execution.values import TaskInputs
from housefly.tasks.rules.trigger import EventTrigger

LOOK = RequestTask("look", {"subject": "refrigerator"}, by="kim")


@pytest.fixture
def stage(tmp_path: Path) -> Iterator[TaskStage]:
    stage = TaskStage(tmp_path)
    yield stage
    stage.close()


@pytest.fixture
def new_stage(tmp_path: Path) -> Iterator[Callable[..., TaskStage]]:
    made: list[TaskStage] = []

    def make(**changes: object) -> TaskStage:
        made.append(TaskStage(tmp_path, **changes))  # type: ignore[arg-type]
        return made[-1]

    yield make
    for one in made:
        one.close()


def refused(stage: TaskStage, question: TaskQuestion) -> tuple[str, str]:
    with pytest.raises(TaskError) as caught:
        stage.ask(question)
    return caught.value.code, str(caught.value)


def test_what_a_sentence_asks_for_is_rehearsed_flown_and_told_with_its_causes(
    stage: TaskStage,
) -> None:
    answer = stage.ask(Sentence("look at the refrigerator", by="kim"))
    assert answer.task is not None and answer.task.state is Stage.QUEUED
    assert stage.fly(lambda: stage.task().state in ENDED)
    done = stage.task()
    assert (done.state, done.code) == (Stage.DONE, ReasonCode.OK), done
    assert done.rehearsal == GOOD and done.asked_by == "kim"
    assert done.started_at is not None and done.ended_at is not None
    assert done.took_off_at is not None and done.started_at <= done.took_off_at
    assert 5.0 < done.flown <= done.ended_at - done.took_off_at + 0.2
    assert stage.stands_on_pad()
    assert stage.loop is not None and not stage.loop.contacts()
    kinds = [event.kind for event in stage.told("task asked", "task started", "task ended")]
    assert kinds == ["task asked", "task started", "task ended"]
    assert {event.cause for event in stage.told("task started", "task ended")} == {"task 1"}
    assert {order.sender for order in stage.orders} == {"task 1: look"}
    assert stage.ask(TaskHistoryQuestion()).tasks[0].id == 1
    assert stage.hub is not None
    kept = stage.hub.memory
    kept.flush()
    with kept.store() as store:
        found = [event.kind for event in store.events(0.0, 4e9, kind="task ended")]
    assert found == ["task ended"], "the room's memory has it"


def test_without_a_memory_the_places_and_furniture_of_the_room_can_be_asked_for(
    new_stage: Callable[..., TaskStage],
) -> None:
    stage = new_stage(hub__enabled=False)
    stage.stand()
    for number, words in enumerate(("entrance", "refrigerator", "sofa"), 1):
        answer = stage.ask(Sentence(f"look at the {words}"))
        assert answer.task is not None and answer.task.id == number, answer
    stage.stand()
    assert [order.kind for order in stage.orders] == [OrderKind.GO]


def test_a_cancelled_flight_comes_home(stage: TaskStage) -> None:
    stage.ask(LOOK)
    assert stage.fly(lambda: stage.parts.inbox.status is DroneStatus.FLYING, 30.0)
    assert stage.ask(CancelTask(1, "kim")).tasks[0].state is Stage.RUNNING, "it comes home yet"
    assert stage.fly(lambda: stage.task().state in ENDED)
    assert (stage.task().state, stage.task().code) == (Stage.CANCELLED, ReasonCode.CANCELLED)
    assert "kim" in stage.task().words
    assert stage.stands_on_pad()


def test_no_order_is_given_on_old_news_and_a_lost_pilot_ends_the_task(stage: TaskStage) -> None:
    stage.ask(LOOK)
    assert stage.fly(lambda: stage.parts.inbox.status is DroneStatus.FLYING, 30.0)
    stage.new_orders()
    for _ in range(round(1.3 * 15)):
        stage.tick()
    stage.ask(CancelTask(1, "kim"))
    for _ in range(round(1.2 * 15)):
        stage.tick()
    assert stage.task().state is Stage.RUNNING, "it would come home as soon as the pilot hears"
    for _ in range(round(1.0 * 15)):
        stage.tick()
    assert (stage.task().state, stage.task().code) == (Stage.FAILED, ReasonCode.NOT_READY)
    assert stage.new_orders() == [], "nobody hears them, or obeys them when it is too late"


def test_a_pilot_that_was_started_again_flies_no_old_task(stage: TaskStage) -> None:
    stage.stand()
    stage.ask(LOOK)
    stage.stand(0.5)
    assert [order.kind for order in stage.new_orders()] == [OrderKind.GO]
    stage._sequence = 0
    stage.stand(1.0)
    assert (stage.task().state, stage.task().code) == (Stage.FAILED, ReasonCode.NOT_READY)
    assert stage.new_orders() == []


def test_what_cannot_be_flown_is_said_before_take_off(stage: TaskStage) -> None:
    stage.rehearsals.report = RehearsalReport(False, ReasonCode.NO_WAY, "there is no way there")
    stage.stand()
    stage.ask(LOOK)
    stage.stand()
    task = stage.task()
    assert (task.state, task.code, task.words) == (
        Stage.REFUSED,
        ReasonCode.NO_WAY,
        "there is no way there",
    )
    assert stage.orders == []


def test_a_rehearsal_that_fails_lets_nothing_fly(stage: TaskStage) -> None:
    stage.rehearsals.report = RuntimeError("broken")
    stage.stand()
    stage.ask(LOOK)
    stage.stand()
    assert (stage.task().state, stage.task().code) == (Stage.REFUSED, ReasonCode.NOT_READY)
    assert stage.orders == []


def test_a_rehearsal_that_is_not_ready_yet_is_tried_again(stage: TaskStage) -> None:
    not_ready = RehearsalReport(False, ReasonCode.NOT_READY, "still getting ready")
    stage.rehearsals.report = not_ready
    stage.stand()
    stage.ask(LOOK)
    stage.tick()
    assert stage.task().state not in ENDED and stage.orders == []
    stage.rehearsals.report = GOOD
    stage.stand()
    assert stage.task().state is Stage.RUNNING and len(stage.orders) == 1


def test_nothing_flies_while_its_rehearsal_goes_on(stage: TaskStage) -> None:
    stage.rehearsals.is_slow = True
    stage.stand()
    stage.ask(LOOK)
    stage.stand(5.0)
    assert stage.orders == []
    assert stage.ask(CancelTask(1, "kim")).tasks[0].id == 1
    stage.stand()
    assert stage.task().state is Stage.CANCELLED
    assert stage.orders == []


def test_an_old_rehearsal_is_done_again_before_the_flight(stage: TaskStage) -> None:
    stage.parts.drones.first.readiness = TakeOffReadiness(False, "the battery is empty")
    stage.stand()
    stage.ask(LOOK)
    stage.stand(30.0)
    assert stage.orders == [] and len(stage.rehearsals.asked) == 1
    assert "battery" in stage.ask(BoardQuestion()).tasks[0].words
    stage.parts.drones.first.readiness = TakeOffReadiness(True, "")
    stage.stand()
    assert len(stage.rehearsals.asked) == 2 and len(stage.orders) == 1


def test_what_can_no_longer_be_flown_when_its_turn_comes_does_not_fly(stage: TaskStage) -> None:
    stage.parts.drones.first.readiness = TakeOffReadiness(False, "the battery is empty")
    stage.stand()
    stage.ask(LOOK)
    stage.stand(30.0)
    stage.rehearsals.report = RehearsalReport(False, ReasonCode.NO_WAY, "there is no way there")
    stage.parts.drones.first.readiness = TakeOffReadiness(True, "")
    stage.stand()
    assert (stage.task().state, stage.task().code) == (Stage.REFUSED, ReasonCode.NO_WAY)
    assert stage.orders == []


def test_after_a_crash_nothing_that_was_in_the_air_starts_again(
    new_stage: Callable[..., TaskStage],
) -> None:
    first = new_stage()
    first.stand()
    first.ask(LOOK)
    first.stand()
    assert first.task().state is Stage.RUNNING and len(first.orders) == 1
    first.close()  # what kill -9 leaves is the same: each change was written at once
    second = new_stage(begin=100.0)
    second.stand(3.0, DroneStatus.FLYING)
    second.stand(30.0)
    assert (second.task().state, second.task().code) == (Stage.FAILED, ReasonCode.RESTARTED)
    assert second.orders == []


def test_a_flying_task_is_sent_home_when_the_process_is_told_to_end(stage: TaskStage) -> None:
    stage.stand()
    stage.ask(LOOK)
    stage.stand()
    stage.stand(1.0, DroneStatus.FLYING)
    stage.new_orders()
    with stage.service.desk.lock:
        now, unix = stage.clock.now(), stage.wall()
        stage.parts.engine.close("the process ends", now, unix)
    assert [order.kind for order in stage.new_orders()] == [OrderKind.HOME]
    assert stage.task().state is Stage.CANCELLED


def test_what_a_person_flies_is_left_to_the_person(stage: TaskStage) -> None:
    stage.stand(1.0, DroneStatus.FLYING)
    stage.ask(LOOK)
    stage.stand(2.0, DroneStatus.FLYING)
    assert stage.orders == []
    assert "a person flies" in stage.ask(BoardQuestion()).tasks[0].words


def test_a_clip_that_was_cut_off_and_saved_stays_with_its_task(stage: TaskStage) -> None:
    stage.ask(LOOK)
    stage.stand()
    clips = stage.parts.clips
    assert clips.flush(), "what a crash left is seen to"
    for outcome in (ClipOutcome.CUT_OFF, ClipOutcome.FAILED):
        row = new_clip_row("clip", 1_790_000_000.0, ClipOrigin(1, "look"))
        clips.index.finish(row)
        stage.parts.engine.keep_clip(1, row.id)
        clips._tell(ClipResult(row.id, outcome, f"{outcome.value}: the disk is full"))
        stage.stand()
        assert (row.id in stage.task().clips) is (outcome is ClipOutcome.CUT_OFF)
        assert f"{outcome.value}: the disk is full" in stage.task().report
    assert [event.kind for event in stage.told("clip kept")] == ["clip kept"]


def test_a_photo_that_a_person_takes_is_kept_and_told_with_who_took_it(stage: TaskStage) -> None:
    clips = stage.parts.clips
    assert clips.flush(), "what a crash left is seen to"
    now, unix = stage.clock.now(), stage.wall()
    for frame in video(2.0, now - 2.0):
        clips.tick(frame.received_at, unix, DroneStatus.FLYING, HouseMode.HOME)
        clips.add(frame, None)
    (photo,) = stage.ask(TakePhoto(now - 1.0, by="Ada")).clips
    assert (photo.kind, photo.task, photo.cause) == ("snapshot", 0, "Ada")
    assert clips.shows_light, "the light of the drone shows it"
    assert photo.keep_until is not None and clips.index.file(photo.id).exists()
    stage.stand()
    (told,) = stage.told("snapshot kept")
    assert told.cause == "Ada" and ("clip", photo.id) in told.facts


def test_what_people_should_know_is_on_the_board(stage: TaskStage) -> None:
    assert stage.ask(BoardQuestion()).notices == ()
    index = stage.parts.clips.index
    assert stage.parts.clips.flush(), "what a crash left is seen to"
    row = replace(new_clip_row("clip", 1_790_000_000.0, ClipOrigin()), size=3 * 10**9)
    index.finish(row)
    index.keep(row.id, "kim")
    (notice,) = stage.ask(BoardQuestion()).notices
    assert "clips take 3 GB, more than tasks.clip_space_gb = 2" in notice


def test_an_assistant_only_proposes(stage: TaskStage) -> None:
    stage.stand()
    answer = stage.ask(
        RequestTask("look", {"subject": "sofa"}, "a model", RequestSurface.ASSISTANT)
    )
    assert answer.tasks[0].state is Stage.WAITING and answer.tasks[0].question is not None
    stage.stand(5.0)
    assert stage.orders == []
    stage.ask(ReplyToTask(1, "confirm", "yes", "kim"))
    stage.stand()
    assert [order.kind for order in stage.orders] == [OrderKind.GO]
    assert "person answered" in {event.kind for event in stage.events}


@pytest.mark.parametrize(
    "text",
    ["set the house to home", "go on", "land", "fly home", "look at the sofa"],
)
def test_a_sentence_of_an_assistant_starts_and_changes_nothing(stage: TaskStage, text: str) -> None:
    stage.ask(SetMode(HouseMode.PRIVACY, "kim"))
    stage.stand()
    try:
        stage.ask(Sentence(text, by="a model", surface=RequestSurface.ASSISTANT))
    except TaskError as error:
        assert error.code == "mode"
    stage.stand(2.0)
    assert stage.orders == []
    assert stage.ask(BoardQuestion()).mode is HouseMode.PRIVACY


def test_stop_stops_whoever_says_it_and_whatever_else_was_allowed(stage: TaskStage) -> None:
    stage.stand()
    stage.ask(Sentence("stop", by="a model", surface=RequestSurface.ASSISTANT, fly=False))
    assert [order.kind for order in stage.orders] == [OrderKind.STOP]


def test_a_sentence_that_may_not_fly_is_only_answered(stage: TaskStage) -> None:
    stage.stand()
    answer = stage.ask(Sentence("look at the refrigerator", fly=False))
    assert answer.understood and answer.task is None
    stage.stand(2.0)
    assert stage.orders == []


def test_pictures_and_the_mode_of_the_house_are_told_in_words(stage: TaskStage) -> None:
    assert stage.ask(Sentence("show me the clips")).words == "There is no recording of that."
    assert "home" in stage.ask(Sentence("which mode is it")).words


def test_in_maintenance_nothing_flies_and_the_reason_is_given(stage: TaskStage) -> None:
    stage.ask(SetMode(HouseMode.MAINTENANCE, "kim"))
    code, words = refused(stage, LOOK)
    assert code == "mode" and "maintenance" in words
    assert stage.told("mode changed")


def test_what_there_is_not_is_refused_with_what_there_is(stage: TaskStage) -> None:
    assert refused(stage, RequestTask("loook")) == (
        "unknown_service",
        "there is no service 'loook': did you mean look?",
    )
    assert refused(stage, RequestTask("look"))[0] == "bad_parameter"
    assert refused(stage, CancelTask(7))[0] == "unknown_task"
    assert refused(stage, PauseTask(7))[0] == "unknown_task"


def test_a_webhook_that_no_rule_waits_for_does_nothing(stage: TaskStage) -> None:
    assert stage.ask(Webhook("nobody-waits")).firings == ()


def test_every_question_of_the_contract_is_answered_with_its_answer(stage: TaskStage) -> None:
    stage.rehearsals.is_slow = False
    stage.stand()
    stage.parts.drones.first.readiness = TakeOffReadiness(False, "no")
    questions: tuple[TaskQuestion, ...] = (
        LOOK,
        RehearseTask("look", {"subject": "sofa"}),
        BoardQuestion(),
        PauseTask(1),
        ContinueTask(1),
        ServicesQuestion(),
        TaskHistoryQuestion(),
        Sentence("where is the refrigerator"),
        SetMode(HouseMode.AWAY),
        RulesQuestion(),
        ChangeRule("bell", enabled=False),
        DryRunQuestion(0.0),
        ClipsQuestion(),
        Webhook("x"),
        RequestTask("look", {"subject": "sofa"}, surface=RequestSurface.ASSISTANT),
        ReplyToTask(2, "confirm", "no"),
        CancelTask(),
    )
    of_clips = {KeepClip, DeleteClip, TakePhoto}
    assert {type(question) for question in questions} | of_clips == set(TASK_ANSWER_TYPES)
    for order in (KeepClip("x"), DeleteClip("x")):
        assert refused(stage, order)[0] == "bad_parameter"
    assert refused(stage, TakePhoto()) == ("not_ready", "the camera records only in flight")
    for question in questions:
        assert isinstance(stage.ask(question), TASK_ANSWER_TYPES[type(question)]), question


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=100)
@given(st.text(max_size=200) | st.dictionaries(st.text(max_size=8), st.integers()).map(json.dumps))
def test_whatever_is_asked_it_is_answered_in_words_and_nothing_flies(
    stage: TaskStage, text: str
) -> None:
    assert "error" in json.loads(stage.service.answer(text))
    assert stage.orders == []


@pytest.mark.interop
def test_an_alarm_takes_the_drone_and_gives_it_back(stage: TaskStage) -> None:
    stage.ask(RequestTask("look", {"subject": "sofa", "time": 20.0}, by="kim"))
    assert stage.fly(lambda: stage.parts.inbox.status is DroneStatus.FLYING, 30.0)
    surface, times = RequestSurface.RULE, {"subject": "tv", "time": 1.0}
    stage.ask(RequestTask("look", times, by="rule", surface=surface, priority=Priority.ALARM))
    assert stage.fly(lambda: stage.task(2).state is Stage.RUNNING, 60.0)
    assert stage.task(1).state is Stage.SUSPENDED
    assert stage.fly(lambda: stage.task(1).state in ENDED, 240.0)
    assert (stage.task(1).state, stage.task(2).state) == (Stage.DONE, Stage.DONE)
    assert {order.source for order in stage.orders} == {OrderSource.TASK, OrderSource.RULE}
    assert stage.stands_on_pad()
    assert stage.loop is not None and not stage.loop.contacts()


@pytest.mark.interop
def test_a_paused_flight_hovers_until_it_is_continued(stage: TaskStage) -> None:
    stage.ask(LOOK)
    assert stage.fly(lambda: _phase(stage) is Phase.OUTBOUND, 30.0)
    assert stage.ask(PauseTask(1, "kim")).tasks[0].state is Stage.PAUSED
    assert stage.fly(lambda: _phase(stage) is Phase.HOLDING, 10.0)
    assert not stage.fly(lambda: _phase(stage) is not Phase.HOLDING, 8.0)
    stage.ask(ContinueTask(1, "kim"))
    assert stage.fly(lambda: stage.task().state in ENDED)
    assert stage.task().state is Stage.DONE
    assert stage.stands_on_pad()


def test_a_step_that_breaks_ends_the_task_and_sends_the_drone_home(
    stage: TaskStage, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage.stand()
    stage.ask(LOOK)
    stage.stand()
    stage.stand(1.0, DroneStatus.FLYING)
    stage.new_orders()

    def broken(run: TaskRun, inputs: TaskInputs) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(TaskRun, "step", broken)
    stage.stand(1.0, DroneStatus.FLYING)
    assert [order.kind for order in stage.new_orders()] == [OrderKind.HOME]
    assert (stage.task().state, stage.task().code) == (Stage.FAILED, ReasonCode.STEP_FAILED)


def test_a_person_who_takes_off_before_a_task_begins_keeps_the_drone(stage: TaskStage) -> None:
    stage.rehearsals.is_slow = True
    stage.stand()
    stage.ask(LOOK)
    stage.stand()
    by_hand = Order(OrderKind.TAKE_OFF, issued_at=stage.clock.now(), sender="kim")
    stage.stand(1.0, DroneStatus.FLYING, Phase.HOLDING, (by_hand,))
    assert (stage.task().state, stage.task().code) == (
        Stage.CANCELLED,
        ReasonCode.PERSON_TOOK_OVER,
    )
    assert stage.orders == []
    assert (stage.task().took_off_at, stage.task().flown) == (None, 0.0), "it did not fly"


def test_what_flew_while_the_tasks_died_is_not_said_to_have_stayed_on_the_ground(
    tmp_path: Path,
) -> None:
    crashed = TaskStage(tmp_path)
    crashed.stand()
    crashed.ask(LOOK)
    crashed.stand()
    flown = Order(OrderKind.GO, sender="task 1: look", source=OrderSource.TASK)
    crashed.stand(2.0, DroneStatus.FLYING, Phase.OUTBOUND, (flown,))
    assert crashed.task().took_off_at is not None
    crashed.close()
    stage = TaskStage(tmp_path)
    assert (stage.task().code, stage.task().flown) == (ReasonCode.RESTARTED, None)
    stage.close()


def test_after_a_person_landed_the_next_flight_asks_before_it_takes_off(stage: TaskStage) -> None:
    stage.stand()
    stage.ask(LOOK)
    stage.stand()
    stage.ask(RequestTask("look", {"subject": "sofa"}, by="ann"))
    flown = Order(OrderKind.GO, sender="task 1: look", source=OrderSource.TASK)
    stage.stand(2.0, DroneStatus.FLYING, Phase.OUTBOUND, (flown,))
    stage.stand(1.0, DroneStatus.FLYING, Phase.LANDING, (Order(OrderKind.LAND, sender="kim"),))
    assert stage.task(1).code is ReasonCode.PERSON_TOOK_OVER
    stage.new_orders()
    stage.stand(5.0)
    assert stage.new_orders() == []
    assert stage.task(2).state is Stage.WAITING


@pytest.mark.parametrize("mode", [HouseMode.MAINTENANCE])
def test_a_mode_in_which_no_task_flies_ends_what_waits_to_fly(
    stage: TaskStage, mode: HouseMode
) -> None:
    stage.parts.drones.first.readiness = TakeOffReadiness(False, "the battery is empty")
    stage.stand()
    stage.ask(LOOK)
    stage.ask(SetMode(mode, "kim"))
    stage.parts.drones.first.readiness = TakeOffReadiness(True, "")
    stage.stand(2.0)
    assert stage.task().state is Stage.CANCELLED and stage.orders == []


def test_a_second_click_is_no_second_flight(stage: TaskStage) -> None:
    stage.rehearsals.is_slow = True
    stage.stand()
    first = stage.ask(LOOK).tasks[0]
    stage.stand(0.5)
    assert stage.ask(LOOK).tasks[0].id == first.id
    assert len(stage.ask(BoardQuestion()).tasks) == 1


def test_a_drone_that_a_called_off_task_left_in_the_air_is_sent_home(stage: TaskStage) -> None:
    stage.stand()
    stage.ask(LOOK)
    stage.stand()
    flown = Order(OrderKind.GO, sender="task 1: look", source=OrderSource.TASK)
    stage.stand(1.0, DroneStatus.FLYING, Phase.OUTBOUND, (flown,))
    stage.rehearsals.is_slow = True
    stage.ask(RequestTask("look", {"subject": "tv"}, by="rule", priority=Priority.ALARM))
    stage.stand(1.0, DroneStatus.FLYING, Phase.HOLDING)
    assert stage.task(1).state is Stage.SUSPENDED
    stage.new_orders()
    stage.ask(CancelTask(0, "kim"))
    stage.stand(1.0, DroneStatus.FLYING, Phase.HOLDING)
    assert [order.kind for order in stage.new_orders()] == [OrderKind.HOME]


def test_a_refused_answer_is_no_answer_in_the_memory(stage: TaskStage) -> None:
    stage.stand()
    stage.ask(LOOK)
    assert refused(stage, ReplyToTask(1, "nonsense", "yes", "kim"))[0] == "bad_parameter"
    assert stage.told("person answered") == []


def test_who_wants_to_be_called_is_told_once(stage: TaskStage) -> None:
    stage.ask(Sentence("call me when the bell rings", by="kim"))
    bell = EventTrigger(RoomEvent("bell pressed", "doorbell", stage.wall(), "doorbell"))
    stage.service.desk.heard(bell)
    assert len(stage.told("said")) == 1
    stage.service.desk.heard(
        EventTrigger(RoomEvent("bell pressed", "doorbell", stage.wall() + 60.0, "doorbell"))
    )
    assert len(stage.told("said")) == 1


def test_the_bell_asks_for_a_visit_and_the_chain_of_causes_is_told(stage: TaskStage) -> None:
    stage.stand()
    bell = RoomEvent("bell pressed", "doorbell", stage.wall(), "doorbell")
    stage.service.desk.heard(EventTrigger(bell))
    task = stage.task()
    assert (task.state, task.service) == (Stage.WAITING, "visitor")
    (fired,), (asked,) = stage.told("rule fired"), stage.told("task asked")
    assert "bell pressed" in fired.cause and "bell pressed" in asked.cause
    assert asked.cause == task.cause


def _phase(stage: TaskStage) -> Phase:
    step = stage.parts.inbox.newest
    return step.outputs.phase if step else Phase.IDLE


TWO_DRONES = ({"name": "red"}, {"name": "blue", "address": "127.0.0.2", "pad": (4.0, 4.0, 0.0)})


def test_two_drones_fly_two_tasks_and_each_gets_the_orders_of_its_own(
    new_stage: Callable[..., TaskStage],
) -> None:
    stage = new_stage(drones=TWO_DRONES)
    stage.stand()
    for subject in ("refrigerator", "entrance"):
        stage.ask(RequestTask("look", {"subject": subject}, by="kim"))
        stage.stand()
    assert [stage.task(number).drone for number in (1, 2)] == ["red", "blue"]
    assert {order.sender for order in stage.orders_of["red"]} == {"task 1: look"}
    assert {order.sender for order in stage.orders_of["blue"]} == {"task 2: look"}
    assert stage.ask(BoardQuestion()).drone.startswith("red: ")
    for name in ("red", "blue"):
        stage.orders_of[name].clear()
    stage.stand(1.0, DroneStatus.FLYING)
    stage.ask(Sentence("stop", by="kim"))
    assert all(OrderKind.STOP in [o.kind for o in one] for one in stage.orders_of.values())


def test_a_task_is_flown_by_the_drone_that_is_asked_for_after_a_rehearsal_with_it(
    new_stage: Callable[..., TaskStage],
) -> None:
    stage = new_stage(drones=TWO_DRONES)
    stage.stand()
    stage.ask(RequestTask("look", {"subject": "refrigerator"}, drone="blue"))
    stage.stand(2.0)
    assert stage.orders_of["blue"] and not stage.orders_of["red"]
    assert set(stage.rehearsals.drones) == {"blue"}
    code, words = refused(stage, RequestTask("look", {"subject": "refrigerator"}, drone="green"))
    assert code == ReasonCode.BAD_PARAMETER.value and "allowed: red, blue" in words


def test_a_sentence_names_the_drone_that_is_meant(new_stage: Callable[..., TaskStage]) -> None:
    stage = new_stage(drones=TWO_DRONES)
    stage.stand()
    answer = stage.ask(Sentence("look at the refrigerator with blue", by="kim"))
    assert answer.task is not None and answer.task.drone == "blue"
    stage.stand(1.0, DroneStatus.FLYING)
    assert stage.ask(Sentence("Red, cancel that", by="kim")).task is None
    for orders in stage.orders_of.values():
        orders.clear()
    stage.ask(Sentence("Red, land!", by="kim"))
    assert [order.kind for order in stage.orders_of["red"]] == [OrderKind.LAND]
    assert OrderKind.LAND not in [order.kind for order in stage.orders_of["blue"]]
    cancelled = stage.ask(Sentence("Blue, cancel that", by="kim")).task
    assert cancelled is not None and cancelled.id == answer.task.id


def test_what_another_drone_than_the_rehearsed_one_flies_is_rehearsed_anew(
    new_stage: Callable[..., TaskStage],
) -> None:
    stage = new_stage(drones=TWO_DRONES)
    stage.parts.drones["red"].readiness = TakeOffReadiness(False, "it charges")
    stage.stand()
    stage.ask(RequestTask("look", {"subject": "refrigerator"}))
    stage.stand(2.0)
    assert stage.rehearsals.drones == ["red", "blue"] and stage.task().drone == "blue"
    assert stage.orders_of["blue"] and not stage.orders_of["red"]
