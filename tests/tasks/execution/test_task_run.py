"""A running task on a scripted pilot: what it orders, and that it ends in a defined state."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scripted_pilot import PERIOD, Flight, ScriptedPilot, ScriptedRoom, view

from housefly.evidence.clip_values import StartClip, TakeSnapshot
from housefly.geometry import distance
from housefly.messages import (
    DroneStatus,
    Event,
    EventCode,
    Order,
    OrderAnswer,
    OrderKind,
    OrderOutcome,
    OrderSource,
    Phase,
    SafetyMode,
    Severity,
)
from housefly.pilot.behavior.mission import Refused
from housefly.tasks.api.values import ReasonCode, TaskLook, TaskStage, TaskStepState
from housefly.tasks.document.binding import bind
from housefly.tasks.document.document_parser import read_task
from housefly.tasks.document.library import load_library
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.execution.order_tracker import OrderTracker
from housefly.tasks.execution.task_run import CANCEL_TIME_MAX, HOLD_PERIOD, TaskRun
from housefly.tasks.execution.values import AskPerson, PersonReply, Say, StopClip, TaskInputs

LIBRARY = load_library()
MOVING = (OrderKind.GO, OrderKind.TAKE_OFF, OrderKind.HOME)


def task(steps: str, **extra: str) -> BoundTask:
    more = "".join(f"{key}: {value}\n" for key, value in extra.items())
    return bind(read_task(f"name: t\nsteps:\n{steps}\n{more}"), {})


def flight(bound: BoundTask, room: ScriptedRoom | None = None) -> Flight:
    known = ScriptedRoom({"fridge": view("fridge", 2.0, 1.0), "tv": view("tv", -1.0, 2.0)})
    return Flight(TaskRun(bound, room or known), ScriptedPilot())


LOOK = "  - look_at: fridge\n  - snapshot\n  - wait: 1 s\n  - return_home"
FULL = (
    "  - take_off\n  - look_at: fridge\n  - record: {}\n    do:\n      - snapshot\n"
    "      - ask: {question: Well, wait: 2 s}\n  - go_to: tv\n  - sweep: 2\n  - return_home"
)
TICKS = 260
"""Longer than FULL takes."""


def test_look_takes_off_looks_and_comes_home() -> None:
    done = flight(task(LOOK)).fly()
    assert done.run.stage is TaskStage.DONE
    assert done.run.code is ReasonCode.OK
    assert done.kinds == ["go", "home"]
    assert done.stands_on_pad()
    assert [step.state for step in done.run.steps] == [TaskStepState.DONE] * 4
    assert len(done.of(TakeSnapshot)) == 1


def test_what_it_shows_is_said_with_the_time_left_from_arrival_to_the_way_home() -> None:
    steps = (
        "  - look_at: fridge\n  - snapshot\n  - ask: {question: Well, wait: 5 s}\n"
        "  - follow: {person: tv, time: 5 s}\n  - sweep: 2\n  - return_home"
    )
    flying, told = flight(task(steps)), {}
    while not flying.run.is_over:
        flying.tick()
        look, pilot = flying.run.look, flying.pilot
        if look is not None:
            assert pilot.phase in (Phase.HOLDING, Phase.OUTBOUND)
            told.setdefault(str(look.words), []).append(look.until)
        else:
            assert pilot.phase is not Phase.HOLDING or flying.orders[-1].issued_at > pilot.now - 1
    assert list(told) == ["Looking at fridge", "Following tv", "Looking around"]
    for words in ("Looking at fridge", "Following tv"):
        ends = {until for until in told[words] if until is not None}
        assert len(ends) <= 2 and max(ends) - min(ends) <= 1.0, "the same end all the while"
    assert told["Looking around"] == [None] * len(told["Looking around"])


def test_a_paused_look_shows_the_same_and_has_no_end() -> None:
    flying = flight(task("  - look_at: fridge\n  - wait: 20 s"))
    for _ in range(60):
        flying.tick()
    before = flying.run.look
    assert before is not None and before.until is not None
    flying.run.pause()
    flying.tick()
    assert flying.run.look == TaskLook(before.words)
    flying.run.resume()
    for _ in range(50):
        flying.tick()
    again = flying.run.look
    assert again is not None and again.words == before.words and again.until is not None


def test_a_question_of_a_paused_task_is_asked_again_with_the_time_that_was_left() -> None:
    flying = flight(task("  - look_at: fridge\n  - ask: {question: Well, wait: 20 s}"))
    while not flying.of(AskPerson):
        flying.tick()
    for _ in range(50):
        flying.tick()
    flying.run.pause()
    for _ in range(300):
        flying.tick()
    flying.run.resume()
    flying.tick()
    first, again = flying.of(AskPerson)
    assert again.words == first.words and again.timeout == pytest.approx(15.0, abs=0.3)


def test_a_task_that_forgets_to_come_home_is_brought_home() -> None:
    done = flight(task("  - look_at: fridge")).fly()
    assert done.run.stage is TaskStage.DONE
    assert done.stands_on_pad()


ON_A_STOOL = "stands 0.60 m above where it took off: on something"


@pytest.mark.parametrize("steps", [LOOK, "  - look_at: fridge\n  - land", "  - look_at: fridge"])
def test_a_task_that_ends_on_a_stool_is_not_done(steps: str) -> None:
    flying = flight(task(steps))
    flying.pilot.floor = 0.6
    flying.fly()
    assert (flying.run.stage, flying.run.code) == (TaskStage.FAILED, ReasonCode.SAFETY)
    assert flying.run.words == ON_A_STOOL
    ends = [step.state for step in flying.run.steps if step.name in ("return_home", "land")]
    assert ends in ([TaskStepState.FAILED], [])


@pytest.mark.parametrize(("begin", "floor", "pose_age"), [(0.6, 0.6, 0.01), (0.0, 0.6, 0.6)])
def test_a_task_that_ends_as_high_as_it_began_or_unseen_is_done(
    begin: float, floor: float, pose_age: float
) -> None:
    flying = flight(task(LOOK))
    flying.pilot.position = (*flying.pilot.position[:2], begin)
    flying.pilot.floor = floor
    flying.tick()
    flying.pilot.pose_age = pose_age
    assert flying.fly().run.stage is TaskStage.DONE


def test_a_cancelled_task_says_that_the_drone_stands_on_something() -> None:
    flying = flight(task(LOOK))
    flying.pilot.floor = 0.6
    for _ in range(40):
        flying.tick()
    flying.run.cancel("enough")
    flying.fly()
    assert flying.run.stage is TaskStage.CANCELLED
    assert flying.run.words == f"enough; {ON_A_STOOL}"


def test_every_order_is_stamped_with_the_pilots_clock() -> None:
    done = flight(task(FULL)).fly()
    assert done.run.stage is TaskStage.DONE
    assert all(order.issued_at > 0.0 and order.source is OrderSource.TASK for order in done.orders)


@settings(max_examples=50, deadline=None)
@given(st.integers(0, TICKS), st.sampled_from([LOOK, FULL]), st.integers(0, 3))
@example(1, LOOK, 3)
@example(2, LOOK, 3)
def test_cancelled_at_any_tick_it_ends_on_the_pad_and_nothing_is_recorded(
    at: int, steps: str, delay: int
) -> None:
    flying = flight(task(steps))
    flying.delay = delay
    for _ in range(at):
        flying.tick()
    was_over, grounded = flying.run.is_over, not flying.pilot.was_up and not flying.waiting
    before = len(flying.orders)
    flying.run.cancel("enough")
    flying.fly()
    for _ in range(20):
        flying.tick()
    assert flying.stands_on_pad()
    assert len(flying.of(StartClip)) == len(flying.of(StopClip))
    if not was_over:
        assert (flying.run.stage, flying.run.code) == (TaskStage.CANCELLED, ReasonCode.CANCELLED)
        assert flying.run.words == "enough"
    if grounded and flying.pilot.phase is Phase.IDLE and not was_over and at < 2:
        assert not any(order.kind in MOVING for order in flying.orders[before:])


@settings(max_examples=50, deadline=None)
@given(st.integers(0, TICKS), st.integers(1, 600), st.sampled_from([LOOK, FULL]), st.integers(0, 3))
def test_paused_at_any_tick_it_holds_and_goes_on(
    at: int, ticks: int, steps: str, delay: int
) -> None:
    flying = flight(task(steps))
    flying.delay = delay
    for _ in range(at):
        flying.tick()
    was_flying = flying.pilot.phase in (Phase.OUTBOUND, Phase.RETURNING)
    flying.run.pause()
    for turn in range(ticks):
        flying.tick()
        assert flying.run.stage is not TaskStage.RUNNING
        if was_flying and turn > delay + 2:
            assert flying.pilot.phase not in (Phase.OUTBOUND, Phase.RETURNING)
    if flying.run.stage is TaskStage.PAUSED and ticks > 60:
        assert flying.pilot.phase in (Phase.IDLE, Phase.HOLDING)
    place = flying.pilot.position
    if ticks > 60:
        flying.tick()
        assert distance(place, flying.pilot.position) < 0.01
    flying.run.resume()
    flying.fly()
    assert flying.run.stage is TaskStage.DONE
    assert flying.stands_on_pad()
    assert len(flying.of(StartClip)) == len(flying.of(StopClip))


@settings(max_examples=20, deadline=None)
@given(st.integers(0, TICKS), st.integers(0, 40))
def test_cancelled_while_paused_it_ends_on_the_pad(at: int, ticks: int) -> None:
    flying = flight(task(FULL))
    for _ in range(at):
        flying.tick()
    flying.run.pause()
    for _ in range(ticks):
        flying.tick()
    flying.run.cancel("enough")
    flying.fly()
    for _ in range(20):
        flying.tick()
    assert flying.stands_on_pad()


@settings(max_examples=50, deadline=None)
@given(
    st.integers(1, TICKS),
    st.sampled_from(
        [OrderKind.STOP, OrderKind.LAND, OrderKind.HOVER, OrderKind.HOME, OrderKind.GO]
    ),
)
def test_a_persons_own_order_ends_it_and_it_orders_nothing_more(at: int, kind: OrderKind) -> None:
    flying = flight(task(FULL))
    for _ in range(at):
        flying.tick()
    if flying.run.is_over:
        return
    order = Order(kind, goal=(1.0, -1.0), issued_at=flying.pilot.now + PERIOD, sender="console")
    flying.tick(people=(order,))
    refused = any(event.code == "order_refused" for event in flying.pilot.events)
    if refused:
        return
    before = len(flying.orders)
    for _ in range(100):
        flying.tick()
    assert flying.run.code is ReasonCode.PERSON_TOOK_OVER
    assert flying.run.stage is TaskStage.CANCELLED
    assert "console took over" in flying.run.words
    assert flying.orders[before:] == []
    assert len(flying.of(StartClip)) == len(flying.of(StopClip))


@pytest.mark.parametrize("name", ["by me: go", "task 1: look", "task", ""])
def test_what_somebody_is_called_makes_their_order_no_tasks(name: str) -> None:
    flying = flight(task(LOOK))
    for _ in range(25):
        flying.tick()
    pilot = flying.pilot
    pilot.advance([], (Order(OrderKind.GO, goal=(1.0, 1.0), issued_at=pilot.now, sender=name),))
    flying.run.step(pilot.inputs())
    assert flying.run.code is ReasonCode.PERSON_TOOK_OVER
    assert flying.run.words.startswith(name or "a person")


def test_an_answer_to_the_same_order_of_somebody_else_is_not_taken_for_ours() -> None:
    tracker, inputs = OrderTracker(), TaskInputs(10.0, 0.0, phase=Phase.TAKING_OFF)
    ours = Order(OrderKind.TAKE_OFF, id="ours", source=OrderSource.TASK)
    theirs = Order(OrderKind.TAKE_OFF, id="theirs", sender="kim")
    tracker.gave(ours, 10.0)
    refused = OrderAnswer("theirs", OrderOutcome.BATTERY, "the battery is too low")
    assert tracker.update(replace(inputs, orders=(theirs,), answers=(refused,))) is None
    assert tracker.is_open(10.0) and tracker.answer is None
    assert tracker.update(replace(inputs, answers=(OrderAnswer("ours"),))) is None
    assert tracker.is_taken
    taken = tracker.update(replace(inputs, orders=(theirs,), answers=(OrderAnswer("theirs"),)))
    assert taken is not None and taken.words == "kim took over: take off"


def test_a_phase_that_nobody_explains_ends_it() -> None:
    """Where every event is lost the phase says that somebody else flies."""
    flying = flight(task("  - look_at: fridge\n  - wait: 20 s"))
    while flying.pilot.phase is not Phase.HOLDING:
        flying.tick()
    for _ in range(5):
        flying.tick()
    flying.pilot.phase, flying.pilot.goal = Phase.RETURNING, (-50.0, 0.0)
    flying.tick()
    assert not flying.run.is_over
    for _ in range(30):
        flying.tick()
    assert flying.run.code is ReasonCode.PERSON_TOOK_OVER
    assert "which this task did not order" in flying.run.words


@pytest.mark.parametrize(
    ("event", "code"),
    [
        ("forced_down", ReasonCode.SAFETY),
        ("return_wanted", ReasonCode.SAFETY),
        ("sinking", ReasonCode.SAFETY),
        ("emergency", ReasonCode.SAFETY),
        ("blocked", ReasonCode.NO_WAY),
        ("overdue", ReasonCode.TIMEOUT),
        ("cornered_landing", ReasonCode.SAFETY),
    ],
)
def test_what_the_pilot_decides_for_safety_ends_it(event: str, code: ReasonCode) -> None:
    flying = flight(task(LOOK))
    for _ in range(20):
        flying.tick()
    pilot = flying.pilot
    pilot.advance([])
    pilot.events = [Event(pilot.now, Severity.WARNING, EventCode(event), "in the pilot's words")]
    assert flying.run.step(pilot.inputs()) == ()
    assert (flying.run.stage, flying.run.code) == (TaskStage.FAILED, code)
    assert flying.run.words == "in the pilot's words"


def test_a_landing_for_safety_is_told_with_its_reason() -> None:
    flying = flight(task(LOOK))
    for _ in range(20):
        flying.tick()
    pilot = flying.pilot
    pilot.advance([])
    pilot.safety = SafetyMode.LAND
    pilot.events = [Event(pilot.now, Severity.WARNING, EventCode.FORCED_DOWN, "landing for safety")]
    inputs = replace(pilot.inputs(), warnings=("the drone is silent: 1.2 s", "somebody is near"))
    flying.run.step(inputs)
    assert flying.run.code is ReasonCode.SAFETY
    assert flying.run.words == "landing for safety: the drone is silent: 1.2 s"


def test_a_landing_where_there_is_no_room_to_make_way_ends_a_way_home_too() -> None:
    flying = flight(task(LOOK))
    while flying.pilot.phase is not Phase.RETURNING:
        flying.tick()
    pilot, words = flying.pilot, "somebody comes near and there is no room: landing here"
    pilot.advance([])
    pilot.phase = Phase.LANDING
    pilot.events = [Event(pilot.now, Severity.WARNING, EventCode.CORNERED_LANDING, words)]
    flying.run.step(pilot.inputs())
    assert (flying.run.stage, flying.run.code) == (TaskStage.FAILED, ReasonCode.SAFETY)
    assert flying.run.words == words


@pytest.mark.parametrize("mode", [SafetyMode.LAND, SafetyMode.DESCEND, SafetyMode.RETURN])
def test_a_gate_that_lands_or_brings_home_ends_it(mode: SafetyMode) -> None:
    flying = flight(task(LOOK))
    for _ in range(20):
        flying.tick()
    flying.pilot.safety = mode
    assert flying.tick() == ()
    assert (flying.run.stage, flying.run.code) == (TaskStage.FAILED, ReasonCode.SAFETY)


def test_a_gate_that_brings_home_a_task_on_its_way_home_lets_it_end_well() -> None:
    flying = flight(task(LOOK))
    while flying.pilot.phase is not Phase.RETURNING:
        flying.tick()
    flying.pilot.safety = SafetyMode.RETURN
    assert flying.fly().run.stage is TaskStage.DONE


@pytest.mark.parametrize(
    ("outcome", "reason", "code"),
    [
        (OrderOutcome.BATTERY, "it needs charging", ReasonCode.BATTERY),
        (OrderOutcome.NO_WAY, "a chair", ReasonCode.NO_WAY),
        (OrderOutcome.PREFLIGHT, "a motor: look at it and its battery", ReasonCode.PREFLIGHT),
    ],
)
def test_a_refusal_ends_it_on_the_ground_as_the_pilot_says_and_not_by_its_words(
    outcome: OrderOutcome, reason: str, code: ReasonCode
) -> None:
    flying = flight(task(LOOK))
    flying.pilot.refuses = Refused(outcome, reason)
    flying.fly()
    assert (flying.run.stage, flying.run.code) == (TaskStage.FAILED, code)
    assert flying.run.words == reason
    assert flying.kinds == ["go"]


def test_a_refusal_in_the_air_brings_it_home() -> None:
    flying = flight(task("  - take_off\n  - look_at: fridge"))
    while flying.pilot.phase is not Phase.HOLDING:
        flying.tick()
    flying.pilot.refuses = Refused(OrderOutcome.NO_WAY, "no way to (2.0, 1.0)")
    flying.tick()
    flying.tick()
    flying.pilot.refuses = None
    flying.fly()
    assert flying.run.code is ReasonCode.NO_WAY
    assert flying.stands_on_pad()


def test_a_pilot_that_does_not_answer_is_asked_three_times() -> None:
    flying = flight(task(LOOK))
    for _ in range(200):
        flying.waiting = []
        flying.tick()
        if flying.run.is_over:
            break
    assert (flying.run.stage, flying.run.code) == (TaskStage.FAILED, ReasonCode.NOT_READY)
    assert flying.kinds == ["go"] * 3


def test_an_order_that_came_too_late_is_given_again() -> None:
    flying = flight(task(LOOK))
    flying.tick()
    late = flying.waiting
    flying.waiting = []
    for _ in range(6):
        flying.tick()
    flying.waiting = late
    assert flying.fly().run.stage is TaskStage.DONE


def test_an_unknown_subject_is_told_before_anything_flies() -> None:
    done = flight(task("  - look_at: unicorn")).fly()
    assert (done.run.stage, done.run.code) == (TaskStage.FAILED, ReasonCode.UNKNOWN_THING)
    assert done.orders == []


def test_a_step_that_takes_too_long_ends_the_task_at_home() -> None:
    done = flight(task("  - look_at: fridge\n    timeout: 2 s")).fly()
    assert (done.run.stage, done.run.code) == (TaskStage.FAILED, ReasonCode.TIMEOUT)
    assert done.stands_on_pad()
    assert "took longer than 2 s" in done.run.words


def test_a_task_has_a_time_limit_which_pauses_do_not_use_up() -> None:
    flying = flight(task("  - look_at: fridge\n  - wait: 1 h", time_limit="20 s"))
    for _ in range(100):
        flying.tick()
    flying.run.pause()
    for _ in range(300):
        flying.tick()
    flying.run.resume()
    flying.tick()
    assert not flying.run.is_over
    flying.fly()
    assert (flying.run.stage, flying.run.code) == (TaskStage.FAILED, ReasonCode.TIMEOUT)
    assert flying.run.words == "the task took too long"


def test_a_drone_that_arrives_after_a_long_way_is_not_stopped_in_its_turn() -> None:
    far = ScriptedRoom({"far": view("far", HOLD_PERIOD + 10.0, 0.0)})
    done = flight(task("  - look_at: far\n  - wait: 2 s\n  - return_home"), far).fly()
    assert done.run.stage is TaskStage.DONE
    assert done.kinds == ["go", "home"]


def test_a_long_hover_is_kept_alive() -> None:
    done = flight(task("  - look_at: fridge\n  - wait: 100 s\n  - return_home")).fly()
    assert done.run.stage is TaskStage.DONE
    assert done.kinds == ["go", "hover", "hover", "hover", "home"]
    gaps = [b.issued_at - a.issued_at for a, b in pairwise(done.orders)]
    assert max(gaps) < HOLD_PERIOD + 10.0


def test_on_cancel_is_done_in_the_air_and_then_it_comes_home() -> None:
    flying = flight(task(LOOK, on_cancel="[{say: Sorry}]"))
    for _ in range(25):
        flying.tick()
    flying.run.cancel("by Anna")
    flying.fly()
    assert flying.of(Say) == [Say("Sorry")]
    assert flying.stands_on_pad()
    assert flying.run.words == "by Anna"


def test_on_cancel_is_left_out_on_the_ground() -> None:
    flying = flight(
        task("  - wait: 5 s\n  - look_at: fridge", on_cancel="[{say: Sorry}, take_off]")
    )
    flying.tick()
    flying.run.cancel("")
    flying.fly()
    assert flying.actions == []
    assert not flying.pilot.was_up


def test_cancelled_while_the_drone_still_stands_it_does_not_take_off() -> None:
    flying = flight(task(LOOK))
    while flying.pilot.phase is not Phase.TAKING_OFF:
        flying.tick()
    assert flying.pilot.status is DroneStatus.LANDED
    flying.run.cancel("")
    flying.fly()
    assert flying.kinds == ["go", "land"]
    assert not flying.pilot.was_up


def refused_at_home(refused_for: float, **extra: str) -> Flight:
    """Return a flight whose way home the pilot refuses for a time [s]; it is at the fridge."""
    flying = flight(task("  - look_at: fridge\n  - fail: no more", **extra))
    while "home" not in flying.kinds:
        flying.tick()
        if flying.pilot.phase is Phase.HOLDING:
            flying.pilot.refuses = Refused(OrderOutcome.NO_WAY, "there is no way")
    until = flying.pilot.now + refused_for
    while not flying.run.is_over:
        flying.tick()
        if flying.pilot.now > until:
            flying.pilot.refuses = None
    return flying


def test_a_drone_that_cannot_come_home_tries_for_a_time_and_then_lands() -> None:
    done = refused_at_home(1e9)
    homes = [order.issued_at for order in done.orders if order.kind is OrderKind.HOME]
    assert done.kinds == ["go", *["home"] * len(homes), "land"]
    assert 8 <= len(homes) <= 12 and 9.0 < homes[-1] - homes[0] < 11.0
    assert done.pilot.phase is Phase.IDLE
    assert done.run.words == "no more"
    said = [each.words for each in done.of(Say)]
    assert len(said) == 2 and "there is no way" in said[0] and "landing" in said[1]


def test_a_way_home_that_is_free_again_is_flown() -> None:
    done = refused_at_home(4.0)
    assert "land" not in done.kinds
    assert done.stands_on_pad()
    assert len(done.of(Say)) == 1


def test_a_pause_is_no_time_in_which_the_way_home_was_tried() -> None:
    flying = flight(task("  - look_at: fridge\n  - return_home"))
    while flying.pilot.phase is not Phase.HOLDING:
        flying.tick()
    flying.pilot.refuses = Refused(OrderOutcome.NO_WAY, "there is no way")
    for ticks, act in ((20, flying.run.pause), (300, flying.run.resume), (20, lambda: None)):
        for _ in range(ticks):
            flying.tick()
        act()
    flying.pilot.refuses = None
    flying.fly()
    assert "land" not in flying.kinds and flying.stands_on_pad()


def test_a_way_home_that_is_refused_is_not_tried_twice_over() -> None:
    """A document that comes home itself, or does so on a cancel, does not begin to wait anew."""
    for steps, cancel in (("  - look_at: fridge\n  - return_home", False),
                          ("  - look_at: fridge\n  - wait: 90 s", True)):  # fmt: skip
        flying = flight(task(steps))
        while flying.pilot.phase is not Phase.HOLDING:
            flying.tick()
        flying.pilot.refuses = Refused(OrderOutcome.NO_WAY, "there is no way")
        began = flying.pilot.now
        if cancel:
            flying.run.cancel("enough")
        flying.fly()
        assert flying.kinds[-1] == "land" and flying.pilot.phase in {Phase.IDLE}
        assert flying.pilot.now - began < 20.0


def test_a_task_resumed_elsewhere_flies_back_first() -> None:
    """After an alarm the drone stands at home; what it looked at is flown to again."""
    flying = flight(task("  - look_at: fridge\n  - wait: 5 s\n  - snapshot\n  - return_home"))
    while flying.run.steps[1].state is not TaskStepState.RUNNING:
        flying.tick()
    flying.run.pause()
    flying.tick()
    pilot = flying.pilot
    pilot.phase, pilot.status, pilot.position = Phase.IDLE, DroneStatus.LANDED, (0.0, 0.0, 0.0)
    pilot.now += 300.0
    flying.waiting = []
    flying.run.resume()
    flying.fly()
    assert flying.run.stage is TaskStage.DONE
    assert flying.kinds[-2:] == ["go", "home"]
    assert flying.orders[-2].goal == (2.0, 1.0)
    shot = next(at for at, action in flying.actions if isinstance(action, TakeSnapshot))
    assert shot - flying.orders[-2].issued_at > 5.0


def test_safe_points_are_neither_take_off_nor_landing_nor_in_a_clip() -> None:
    flying = flight(task(FULL))
    unsafe = {Phase.TAKING_OFF, Phase.RETURNING, Phase.LANDING}
    seen = set()
    while not flying.run.is_over:
        flying.tick()
        records = len(flying.of(StartClip)) > len(flying.of(StopClip))
        if flying.run.is_safe_point and not flying.run.is_over:
            assert flying.pilot.phase not in unsafe
            assert not records
            seen.add(flying.pilot.phase)
    assert seen == {Phase.HOLDING, Phase.OUTBOUND}


def test_a_reply_of_a_person_is_waited_for_and_counts() -> None:
    text = (
        "  - ask: {question: Fly, choices: [go, stay], wait: 10 s, as: wish}\n"
        "  - if: {reply: {to: wish, equals: go}}\n    then: [say: Going]\n    else: [say: Staying]"
    )
    for reply, said in (("go", "Going"), ("stay", "Staying"), ("", "Staying"), ("else", "Staying")):
        flying = flight(task(text))
        flying.tick()
        assert flying.of(AskPerson)[0].choices == ("go", "stay")
        flying.tick(replies=(PersonReply("other", "go", "x"),))
        assert flying.of(Say) == []
        if reply:
            flying.tick(replies=(PersonReply("wish", reply, "Anna"),))
        flying.fly()
        assert [each.words for each in flying.of(Say)] == [said]
        assert flying.orders == []


def test_a_task_that_does_not_fly_leaves_a_persons_flight_alone() -> None:
    flying = flight(task("  - say: Hello\n  - wait: 3 s"))
    pilot = flying.pilot
    pilot.phase, pilot.status, pilot.position = Phase.HOLDING, DroneStatus.FLYING, (1.0, 1.0, 1.0)
    order = Order(OrderKind.GO, goal=(2.0, 0.0), issued_at=pilot.now + PERIOD, sender="console")
    flying.tick(people=(order,))
    flying.run.pause()
    flying.tick()
    flying.run.resume()
    flying.fly()
    assert flying.run.stage is TaskStage.DONE
    assert flying.orders == []


DALLIES = "[{say: Sorry}, {ask: {question: Stay, wait: 20 min}}, {look_at: tv}, {say: Bye}]"


def cancelled_at_the_fridge(on_cancel: str) -> Flight:
    flying = flight(task("  - look_at: fridge\n  - wait: 1 h", on_cancel=on_cancel))
    while flying.pilot.phase is not Phase.HOLDING:
        flying.tick()
    flying.run.cancel("enough")
    return flying


def test_what_is_done_on_a_cancel_has_an_end() -> None:
    done = cancelled_at_the_fridge(DALLIES)
    began = done.pilot.now
    done.fly()
    assert done.run.code is ReasonCode.CANCELLED
    assert done.stands_on_pad()
    assert CANCEL_TIME_MAX < done.pilot.now - began < CANCEL_TIME_MAX + 15.0
    assert done.of(Say) == [Say("Sorry")]


def test_a_second_cancel_leaves_out_the_rest_and_comes_home() -> None:
    flying = cancelled_at_the_fridge(DALLIES)
    for _ in range(30):
        flying.tick()
    flying.run.cancel("now")
    began = flying.pilot.now
    flying.fly()
    assert flying.run.words == "enough"
    assert flying.stands_on_pad() and flying.pilot.now - began < 10.0
    assert flying.of(Say) == [Say("Sorry")]


def test_a_cancel_after_the_landing_of_a_cancel_moves_nothing() -> None:
    flying = cancelled_at_the_fridge("[return_home, {wait: 20 min}]")
    while flying.pilot.phase is not Phase.IDLE:
        flying.tick()
    before = len(flying.orders)
    flying.run.cancel("now")
    flying.fly(100)
    assert flying.orders[before:] == []


def test_a_cancel_while_the_way_down_is_paused_goes_on() -> None:
    for first in (True, False):
        flying = cancelled_at_the_fridge("[return_home]") if first else flight(task(LOOK))
        while flying.pilot.phase is not Phase.RETURNING:
            flying.tick()
        flying.run.pause()
        for _ in range(30):
            flying.tick()
        assert flying.pilot.phase in {Phase.HOLDING}
        flying.run.cancel("now")
        flying.fly(600)
        assert flying.stands_on_pad()


def test_what_is_done_on_a_cancel_may_ask_and_hear_the_reply() -> None:
    on_cancel = (
        "[{ask: {question: Look, wait: 9 s, as: last}},"
        " {if: {reply: {to: last, equals: yes}}, then: [{say: so be it}]}]"
    )
    flying = cancelled_at_the_fridge(on_cancel)
    flying.tick()
    flying.tick(replies=(PersonReply("last", "yes", "Anna"),))
    flying.fly()
    assert flying.of(Say) == [Say("so be it")]
    assert flying.stands_on_pad()
