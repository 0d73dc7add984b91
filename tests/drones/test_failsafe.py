"""What holds for every drone, whatever its wire: told by actions and setpoints, not by bytes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import Airframe, airframe_named
from housefly.drones.failsafe import HOVER_AFTER, LAND_AFTER, Failsafe
from housefly.messages import (
    Action,
    AnySetpoint,
    Command,
    DroneStatus,
    KnownMotion,
    PositionSetpoint,
    Setpoint,
    SetpointForm,
    Telemetry,
    VelocitySetpoint,
)
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.steering import flying

AIRBORNE = tuple(AIRBORNE_STATUSES)
TILT_MAX = 0.2
ARDRONE = airframe_named("ardrone")
WITHOUT_HOVER = ARDRONE.model_copy(
    update={"capabilities": ARDRONE.capabilities.model_copy(update={"manoeuvres": frozenset()})}
)

OTHER = {
    SetpointForm.TILT_AND_CLIMB: SetpointForm.VELOCITY,
    SetpointForm.VELOCITY: SetpointForm.POSITION,
    SetpointForm.POSITION: SetpointForm.TILT_AND_CLIMB,
}
ASKED: dict[SetpointForm, AnySetpoint] = {
    SetpointForm.VELOCITY: VelocitySetpoint(forward=0.5),
    SetpointForm.POSITION: PositionSetpoint(1.0, 2.0, 1.1),
}


def report(status: DroneStatus, at: float, height: float = 1.0) -> Telemetry:
    return Telemetry(at, status, 1.0, height=height)


def told(failsafe: Failsafe, now: float, status: DroneStatus) -> Action:
    return failsafe.decide(now, report(status, now)).command.action


def seen_standing(*, hovers: bool = True) -> Failsafe:
    failsafe = Failsafe(0.0, TILT_MAX, ARDRONE if hovers else WITHOUT_HOVER)
    failsafe.decide(0.0, report(DroneStatus.LANDED, 0.0))
    return failsafe


def of_form(form: SetpointForm) -> Airframe:
    able = ARDRONE.capabilities.model_copy(update={"setpoints": (form,)})
    return ARDRONE.model_copy(update={"capabilities": able})


@pytest.mark.parametrize(
    ("form", "asked"),
    [
        (SetpointForm.TILT_AND_CLIMB, Setpoint(theta=0.1)),
        (SetpointForm.VELOCITY, VelocitySetpoint(forward=0.5)),
        (SetpointForm.POSITION, PositionSetpoint(1.0, 2.0, 1.1, 0.3)),
    ],
)
def test_only_its_own_form_moves_a_drone_and_its_silence_is_answered_in_that_form(
    form: SetpointForm, asked: AnySetpoint
) -> None:
    own, other = (
        Failsafe(0.0, TILT_MAX, of_form(form)),
        Failsafe(0.0, TILT_MAX, of_form(OTHER[form])),
    )
    for failsafe in (own, other):
        failsafe.decide(0.0, report(DroneStatus.LANDED, 0.0))
        failsafe.update(flying(asked), 0.1, motion=KnownMotion(0.5, 0.0))
    assert own.decide(0.1, report(DroneStatus.FLYING, 0.1)).command == flying(asked)
    assert told(other, 0.1, DroneStatus.FLYING) is not Action.FLY
    silent = 0.1 + HOVER_AFTER + 0.01
    braked = own.decide(silent, report(DroneStatus.FLYING, silent)).command
    assert braked.action is Action.FLY and braked.form is form
    if form is SetpointForm.TILT_AND_CLIMB:
        assert braked.setpoint.theta < 0.0
    else:
        assert braked.asked == (
            VelocitySetpoint() if form is SetpointForm.VELOCITY else PositionSetpoint(1.0, 2.0, 1.1)
        )


@pytest.mark.parametrize("form", [SetpointForm.VELOCITY, SetpointForm.POSITION])
def test_one_that_cannot_hover_sinks_in_its_own_form(form: SetpointForm) -> None:
    able = of_form(form).capabilities.model_copy(update={"manoeuvres": frozenset()})
    failsafe = Failsafe(0.0, TILT_MAX, ARDRONE.model_copy(update={"capabilities": able}))
    failsafe.decide(0.0, report(DroneStatus.LANDED, 0.0))
    failsafe.update(flying(ASKED[form]), 0.1)
    heights = []
    for now in (0.5, 1.0, 1.5):
        asked = failsafe.decide(now, report(DroneStatus.FLYING, now)).command.asked
        if isinstance(asked, VelocitySetpoint):
            assert (asked.forward, asked.left) == (0.0, 0.0) and asked.vz < 0.0
        else:
            assert isinstance(asked, PositionSetpoint) and (asked.x, asked.y) == (1.0, 2.0)
            heights.append(asked.z)
    assert heights == sorted(heights, reverse=True)


def test_a_drone_that_was_never_asked_for_a_place_is_left_to_its_own_landing() -> None:
    able = of_form(SetpointForm.POSITION).capabilities.model_copy(
        update={"manoeuvres": frozenset()}
    )
    failsafe = Failsafe(0.0, TILT_MAX, ARDRONE.model_copy(update={"capabilities": able}))
    failsafe.decide(0.0, report(DroneStatus.LANDED, 0.0))
    failsafe.update(Command(Action.HOVER), 0.1)
    assert told(failsafe, 0.5, DroneStatus.FLYING) is Action.LAND


@given(st.sampled_from(AIRBORNE), st.sampled_from(Action))
def test_a_drone_that_is_found_in_the_air_is_only_held_landed_or_cut(
    status: DroneStatus, action: Action
) -> None:
    failsafe = Failsafe(0.0, TILT_MAX, ARDRONE)
    failsafe.update(Command(action, Setpoint(theta=0.1)), 0.01)
    kept = (Action.HOVER, Action.LAND, Action.CUT, Action.IDLE)
    assert told(failsafe, 0.02, status) in kept
    failsafe.update(Command(action, Setpoint(theta=0.1)), 5.0)
    told(failsafe, 5.0, DroneStatus.LANDED)
    failsafe.update(Command(Action.FLY, Setpoint(theta=0.1)), 5.1)
    assert told(failsafe, 5.1, DroneStatus.FLYING) is Action.FLY, "it was seen to stand"


@given(
    st.lists(
        st.tuples(st.sampled_from(Action), st.sampled_from(DroneStatus), st.floats(0.0, 3.0)),
        max_size=30,
    )
)
def test_once_its_driver_leaves_nothing_moves_a_drone_whatever_it_is_told(
    story: list[tuple[Action, DroneStatus, float]],
) -> None:
    failsafe, now = seen_standing(), 0.0
    failsafe.land_for_good()
    for action, status, pause in story:
        now += pause
        failsafe.update(Command(action, Setpoint(theta=0.1)), now)
        decided = failsafe.decide(now + 0.01, report(status, now))
        assert decided.lands_all
        assert decided.command.action not in (Action.FLY, Action.TAKE_OFF)
        if status in AIRBORNE and action not in (Action.CUT, Action.RESET):
            assert decided.command.action is Action.LAND


@pytest.mark.parametrize("pause", [HOVER_AFTER + 0.05, LAND_AFTER + 0.05])
def test_a_drone_that_cannot_hover_sinks_level_where_another_would_hover(pause: float) -> None:
    for hovers in (True, False):
        failsafe = seen_standing(hovers=hovers)
        failsafe.update(Command(Action.FLY), 0.1, motion=KnownMotion(0.0, 0.0))
        decided = failsafe.decide(0.1 + pause, report(DroneStatus.FLYING, 0.1 + pause)).command
        if hovers:
            assert decided.action is (Action.HOVER if pause < LAND_AFTER else Action.LAND)
        else:
            assert decided.action is Action.FLY and decided.setpoint.vz < 0.0
            assert decided.setpoint.theta == decided.setpoint.phi == 0.0


def test_one_that_cannot_hover_is_told_to_land_on_the_floor() -> None:
    failsafe = seen_standing(hovers=False)
    failsafe.update(Command(Action.FLY), 0.1, motion=KnownMotion(0.0, 0.0))
    failsafe.decide(0.5, report(DroneStatus.FLYING, 0.5))
    low = failsafe.decide(2.0, report(DroneStatus.FLYING, 2.0, height=0.05))
    assert low.command.action is Action.LAND
