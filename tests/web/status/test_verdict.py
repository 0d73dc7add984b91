"""The verdict held against what is true: every state, every fault, by properties."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import pytest
from fake_room import EXAMPLE_CHECKS, example_room
from hypothesis import given
from hypothesis import strategies as st

from housefly.app.people_note import UNSEEN_PEOPLE
from housefly.hub.api.pilot_queries import PreflightView
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    LinkStatus,
    OrderKind,
    Outputs,
    Phase,
    PilotStep,
    PreflightCheck,
    SafetyMode,
    Telemetry,
)
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.words import Words, literal
from housefly.tasks.api.values import TaskLook
from housefly.web.messages.verdict_message import (
    ConsoleVerdict,
    HeadlineShape,
    Standing,
    StopProgress,
    StopView,
)
from housefly.web.status.console_knowledge import ConsoleKnowledge
from housefly.web.status.verdict import console_verdict, says_the_same

NOW = 100.0
ROOM = example_room()
PAD = (*ROOM.home, 0.05)
UNDER_THE_TABLE = (3.4, 2.0, 0.05)
PASSED = PreflightView(True, EXAMPLE_CHECKS)
TOO_LOW = replace(EXAMPLE_CHECKS[0], passed=False, value="12%")
AIRBORNE = tuple(phase for phase in Phase if phase is not Phase.IDLE)


def knowing(
    *,
    status: DroneStatus | None = DroneStatus.LANDED,
    position: tuple[float, float, float] = PAD,
    pose_age: float = 0.02,
    telemetry_age: float = 0.03,
    step_age: float = 0.01,
    phase: Phase = Phase.IDLE,
    safety: SafetyMode = SafetyMode.NOMINAL,
    goal: str = "",
    checks: PreflightView = PASSED,
    stop: StopView | None = None,
    moved: str | None = None,
) -> ConsoleKnowledge:
    """Return what the server knows of a drone that is as told."""
    at = NOW - step_age
    estimate = Estimate(at, position, (0.0, 0.0, 0.0), 0.0, pose_age, 0.004)
    told = Telemetry(at - telemetry_age, status, 0.8) if status else None
    out = Outputs(
        Command(Action.FLY), estimate, phase=phase, safety=safety, goal_name=goal, reason="a reason"
    )
    step = PilotStep(7, at, Inputs((), told), out)
    view = stop or StopView()
    return ConsoleKnowledge(
        NOW, step, step_age, None, checks, ROOM, view, 1, "Anna", hand_motion=moved
    )


def objection(verdict: ConsoleVerdict, order: OrderKind) -> str:
    return next((one.words for one in verdict.orders if one.order is order), "")


ages = st.one_of(st.floats(0.0, 0.4), st.floats(0.6, 30.0), st.just(inf))
places = st.tuples(st.floats(0.1, 7.4), st.floats(0.1, 3.9), st.floats(0.0, 1.5))
knowledge = st.builds(
    knowing,
    status=st.one_of(st.none(), st.sampled_from(DroneStatus)),
    position=st.one_of(st.just(PAD), places),
    pose_age=ages,
    telemetry_age=st.one_of(st.floats(0.0, 0.9), st.floats(1.1, 30.0)),
    step_age=st.one_of(st.floats(0.0, 1.9), st.floats(2.1, 60.0)),
    phase=st.sampled_from(Phase),
    safety=st.sampled_from(SafetyMode),
    goal=st.sampled_from(["", "entrance", "sofa"]),
    checks=st.sampled_from(
        [PASSED, PreflightView(), PreflightView(False, (TOO_LOW, *EXAMPLE_CHECKS[1:]))]
    ),
    stop=st.builds(StopView, st.sampled_from(StopProgress)),
    moved=st.sampled_from(["", "moved by hand by Anna"]),
)


@given(knowledge)
def test_ready_on_the_pad_is_said_only_of_a_drone_that_is(known: ConsoleKnowledge) -> None:
    verdict = console_verdict(known)
    if verdict.shape is HeadlineShape.READY or verdict.headline == "Your drone is home":
        assert known.step is not None and known.step.inputs.telemetry is not None
        assert known.step_age <= 2.0 and known.telemetry_age <= 1.0
        assert known.step.inputs.telemetry.status is DroneStatus.LANDED
        assert known.pose_age <= 0.5 and known.pad_distance is not None
        assert known.pad_distance <= 0.4 and known.preflight.ready
        assert known.stop.progress is StopProgress.NONE
        assert verdict.may_take_off and verdict.standing is Standing.ON_PAD


@given(knowledge)
def test_nothing_is_said_of_the_present_by_what_is_of_the_past(known: ConsoleKnowledge) -> None:
    verdict = console_verdict(known)
    if known.step_age > 2.0:
        assert verdict.shape is HeadlineShape.LOST and "pilot" in verdict.headline
        assert verdict.airborne is None and verdict.banner
    if known.step_age > 2.0 or known.pose_age > 0.5:
        assert verdict.pad_distance is None and verdict.pose_is_old
        assert verdict.standing not in (Standing.ON_PAD, Standing.OFF_PAD)
    if not known.drone_is_heard:
        assert verdict.standing is Standing.UNKNOWN and not verdict.may_take_off


@given(knowledge)
def test_a_drone_that_may_fly_is_never_promised_to_stay_down(known: ConsoleKnowledge) -> None:
    verdict = console_verdict(known)
    is_under_way = known.step is not None and known.step.outputs.phase is not Phase.IDLE
    may_fly = known.last_status in AIRBORNE_STATUSES or (is_under_way and not known.drone_is_heard)
    is_known = known.last_status is not DroneStatus.UNKNOWN
    assert verdict.may_be_airborne == may_fly
    assert ("ground" in verdict.if_contact_lost) == (is_known and not may_fly)
    assert "for inf s" not in f"{verdict.banner} {verdict.detail}"
    if may_fly:
        assert objection(verdict, OrderKind.LAND) == ""


@given(knowledge)
def test_what_may_not_fly_says_why_and_how_to_mend_it(known: ConsoleKnowledge) -> None:
    verdict = console_verdict(known)
    assert verdict.may_take_off == (not verdict.reasons)
    assert all(one.words for one in verdict.reasons)
    if not verdict.may_be_airborne:
        assert all(one.mend for one in verdict.reasons)
    assert (objection(verdict, OrderKind.TAKE_OFF) == "") == verdict.may_take_off
    assert {OrderKind.STOP, OrderKind.CUT}.isdisjoint(one.order for one in verdict.orders)


@given(knowledge)
def test_a_verdict_says_the_same_of_the_same(known: ConsoleKnowledge) -> None:
    one = console_verdict(known)
    assert says_the_same(one, replace(one, at=one.at + 1.0))
    assert not says_the_same(one, replace(one, headline=f"{one.headline}!"))


@given(st.sampled_from(AIRBORNE), st.sampled_from(SafetyMode))
def test_in_flight_it_is_said_what_comes_without_this_page(
    phase: Phase, safety: SafetyMode
) -> None:
    known = knowing(status=DroneStatus.FLYING, phase=phase, safety=safety, goal="entrance")
    words = console_verdict(known).if_contact_lost
    if safety in (SafetyMode.NOMINAL, SafetyMode.WARN, SafetyMode.SLOW):
        assert ("Entrance" in words) == (phase in (Phase.OUTBOUND, Phase.TAKING_OFF))
        assert "hovers or lands" not in words
    else:
        assert "Entrance" not in words


TABLE = [
    ("tracking lost", {"pose_age": 4.0}, "Not ready", "tracking saw the drone last 4 s ago"),
    ("crashed under furniture", {"position": UNDER_THE_TABLE}, "Not ready", "table"),
    ("motors cut", {"status": DroneStatus.EMERGENCY}, "Motors are cut", "on the pad"),
    ("landed away", {"position": (6.4, 1.0, 0.05)}, "Not on the pad", "5.4 m from the pad"),
    ("battery low", {"checks": PreflightView(False, (TOO_LOW,))}, "Not ready", "12%"),
    ("pilot gone", {"step_age": 5.0}, "No contact with the pilot", "was on the ground"),
    ("twin gone", {"telemetry_age": 5.0, "pose_age": 5.0}, "Waiting for the drone", ""),
    ("never heard", {"status": None, "step_age": 5.0}, "No contact with the pilot", "nobody has t"),
    ("no checks", {"checks": PreflightView()}, "On the pad", "looking"),
    ("all well", {}, "Your drone is home", "motors are off"),
]


@pytest.mark.parametrize(
    ("change", "headline", "detail"), [row[1:] for row in TABLE], ids=[row[0] for row in TABLE]
)
def test_on_the_ground_each_fault_has_its_own_words(
    change: dict[str, object], headline: str, detail: str
) -> None:
    verdict = console_verdict(knowing(**change))  # type: ignore[arg-type]
    assert verdict.headline == headline and detail in verdict.detail
    assert (verdict.shape is HeadlineShape.READY) == (headline == "Your drone is home")


IN_FLIGHT = [
    ("pilot gone", {"step_age": 5.0}, "No contact with the pilot", "flying to Entrance"),
    ("drone gone", {"telemetry_age": 5.0}, "No contact with the drone", "flying to Entrance"),
    ("tracking lost", {"pose_age": 1.0, "safety": SafetyMode.HOLD}, "HOLDING FOR SAFETY", "a re"),
    ("not seen, not yet held", {"pose_age": 3.0}, "Flying to Entrance", "tracking saw it last 3 s"),
    ("landing", {"safety": SafetyMode.LAND}, "Landing for safety", "a reason"),
    ("no charge", {"safety": SafetyMode.RETURN}, "Coming home for safety", "a reason"),
    ("all well", {}, "Flying to Entrance", ""),
]


@pytest.mark.parametrize(
    ("change", "headline", "detail"),
    [row[1:] for row in IN_FLIGHT],
    ids=[row[0] for row in IN_FLIGHT],
)
def test_in_flight_each_fault_has_its_own_words(
    change: dict[str, object], headline: str, detail: str
) -> None:
    flying = {"status": DroneStatus.FLYING, "phase": Phase.OUTBOUND, "goal": "entrance"}
    verdict = console_verdict(knowing(**{**flying, **change}))  # type: ignore[arg-type]
    assert verdict.headline == headline and detail in verdict.detail


def test_a_silent_drone_that_is_told_to_take_off_is_not_said_to_stand() -> None:
    known = knowing(phase=Phase.TAKING_OFF, telemetry_age=5.0)
    silent = console_verdict(known)
    assert silent.may_be_airborne and silent.airborne is None
    assert silent.headline == "No contact with the drone"
    assert silent.detail == "for 5 s; it was taking off"
    assert "5 s: nobody has told yet what the drone does" in silent.banner
    gone = console_verdict(replace(known, step_age=6.0))
    assert "if the pilot has ended" in gone.banner and "goes on taking off" in gone.banner
    assert not console_verdict(knowing(phase=Phase.TAKING_OFF)).may_be_airborne


def test_a_drone_that_somebody_moves_is_said_to_be_moved_and_by_whom() -> None:
    flying = knowing(status=DroneStatus.FLYING, phase=Phase.HOLDING, moved="Anna")
    verdict = console_verdict(flying)
    assert verdict.headline == "Moved by hand by Anna" and verdict.shape is HeadlineShape.MOVING
    assert "let go" in verdict.detail
    silent = console_verdict(replace(flying, step_age=6.0))
    assert (
        silent.headline == "No contact with the pilot"
        and "it was moved by hand by Anna" in silent.detail
    )
    still = console_verdict(replace(flying, hand_motion=None))
    assert still.headline == "Hovering" and still.shape is HeadlineShape.HOLDING


def test_a_dead_console_is_not_said_to_end_a_flight() -> None:
    flying = knowing(status=DroneStatus.FLYING, phase=Phase.OUTBOUND, goal="entrance")
    words = console_verdict(flying).if_contact_lost
    assert words.startswith("it flies on to Entrance")
    silent = console_verdict(replace(flying, step_age=6.0))
    assert "if the pilot has ended" in silent.banner and "flies on to Entrance" in silent.banner


def test_a_stop_that_holds_keeps_everything_down_until_resume() -> None:
    verdict = console_verdict(knowing(stop=StopView(StopProgress.CONFIRMED)))
    assert verdict.headline == "Stopped" and not verdict.may_take_off
    assert objection(verdict, OrderKind.SERVICE) == "Stopped: hold Resume first."
    assert objection(verdict, OrderKind.RESUME) == ""
    assert objection(console_verdict(knowing()), OrderKind.RESUME) == "Only after STOP."


def test_checks_that_forbid_nothing_are_known_and_no_reasons() -> None:
    unseen = replace(EXAMPLE_CHECKS[1], passed=False, value="no sensor")
    verdict = console_verdict(knowing(checks=PreflightView(True, (EXAMPLE_CHECKS[0], unseen))))
    assert verdict.may_take_off
    assert verdict.known == ("people without markers are unseen (no sensor)",)


def check(code: str) -> PreflightCheck:
    return replace(TOO_LOW, code=code)


def test_one_thing_is_one_reason() -> None:
    codes = ("tracking", "stop", "drone_answers", "drone_landed")
    checks = PreflightView(False, tuple(check(code) for code in codes))
    stop = StopView(StopProgress.CONFIRMED)
    verdict = console_verdict(knowing(pose_age=3.0, stop=stop, checks=checks))
    found = [one.code for one in verdict.reasons]
    assert sorted(found) == sorted({*codes}) and len(found) == len(codes)


def test_what_is_known_is_said_once() -> None:
    unseen = replace(EXAMPLE_CHECKS[1], passed=False, value="no sensor")
    notes = (UNSEEN_PEOPLE, literal("the ultrasound sensor is deaf"))
    known = replace(
        knowing(checks=PreflightView(True, (EXAMPLE_CHECKS[0], unseen))),
        link=LinkStatus(NOW, notes=notes),
    )
    said = "people without markers are unseen (no sensor)"
    assert console_verdict(known).known == (said, *notes)
    twice = replace(known, link=LinkStatus(NOW, notes=(*notes, unseen.fault, *notes)))
    assert console_verdict(twice).known == (said, *notes)
    without_checks = replace(known, preflight=PreflightView())
    assert console_verdict(without_checks).known == notes


def test_under_stop_a_silent_pilot_is_not_said_to_fly_on() -> None:
    flying = knowing(
        status=DroneStatus.FLYING, phase=Phase.HOLDING, safety=SafetyMode.STOPPED, step_age=5.0
    )
    banner = console_verdict(flying).banner
    assert "until somebody resumes" in banner and "comes home" not in banner


@pytest.mark.parametrize(
    ("known", "order"),
    [
        (knowing(), OrderKind.SERVICE),
        (knowing(checks=PreflightView(False, (TOO_LOW,))), None),
        (knowing(status=DroneStatus.FLYING, phase=Phase.HOLDING), OrderKind.HOME),
        (knowing(status=DroneStatus.FLYING, phase=Phase.LOOKING), OrderKind.HOME),
        (knowing(status=DroneStatus.FLYING, phase=Phase.RETURNING), None),
        (knowing(status=DroneStatus.LANDING, phase=Phase.LANDING), None),
        (knowing(status=DroneStatus.EMERGENCY), OrderKind.RESET),
        (knowing(step_age=5.0), None),
        (
            knowing(status=DroneStatus.FLYING, stop=StopView(StopProgress.CONFIRMED)),
            OrderKind.RESUME,
        ),
    ],
)
def test_the_large_button_says_what_is_sensible_next(
    known: ConsoleKnowledge, order: OrderKind | None
) -> None:
    assert console_verdict(known).next_order is order


@given(knowledge)
def test_what_is_proposed_next_is_never_what_comes_to_nothing(known: ConsoleKnowledge) -> None:
    told = console_verdict(known)
    assert told.next_order is None or objection(told, told.next_order) == ""


@pytest.mark.parametrize("phase", [Phase.HOLDING, Phase.OUTBOUND])
def test_what_a_task_shows_is_said_and_its_picture_counts(phase: Phase) -> None:
    known = replace(knowing(status=DroneStatus.FLYING, phase=phase, goal="entrance"), unix=1000.0)
    assert not console_verdict(known).is_showing
    look = TaskLook(Words("Looking at {goal}", goal="entrance"), 1044.6)
    told = console_verdict(replace(known, task_look=look))
    assert (told.headline, told.detail) == ("Looking at Entrance", "45 s left")
    assert told.is_showing and told.shape is HeadlineShape.HOLDING
    late = console_verdict(replace(known, task_look=look, unix=1050.0))
    assert late.detail == "0 s left"
    paused = replace(known, task_look=TaskLook(look.words), task_is_paused=True)
    told = console_verdict(paused)
    assert told.headline == "Paused" and told.is_showing
    assert told.detail == "Looking at Entrance; waits until you press Go on"
    between = replace(known, task_subject="Entrance")
    told = console_verdict(between)
    assert not told.is_showing and "waiting for an order" not in told.detail
    assert not console_verdict(replace(paused, task_look=None)).is_showing


@pytest.mark.parametrize("phase", [Phase.RETURNING, Phase.LANDING, Phase.TAKING_OFF])
def test_a_drone_that_flies_for_itself_shows_nothing_whatever_its_task_says(phase: Phase) -> None:
    flying = knowing(status=DroneStatus.FLYING, phase=phase)
    known = replace(flying, task_look=TaskLook(Words("Looking around")), task_is_paused=True)
    told = console_verdict(known)
    assert not told.is_showing and told.headline == console_verdict(flying).headline


def test_a_look_of_the_pilots_own_counts_too_and_one_on_the_ground_does_not() -> None:
    assert console_verdict(knowing(status=DroneStatus.FLYING, phase=Phase.LOOKING)).is_showing
    assert not console_verdict(
        replace(knowing(), task_look=TaskLook(Words("Looking around")))
    ).is_showing


def test_a_point_that_a_task_flies_to_has_its_name() -> None:
    known = knowing(status=DroneStatus.FLYING, phase=Phase.LOOKING, goal="(3.0, 4.2)")
    assert console_verdict(known).headline == "Looking at the chosen point"
    told = console_verdict(replace(known, task_subject="the refrigerator"))
    assert told.headline == "Looking at the refrigerator"
