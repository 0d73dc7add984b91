from __future__ import annotations

from collections.abc import Callable
from math import isnan, nan
from typing import Any

import numpy as np
import pytest

from housefly.config.site import Site
from housefly.lab.experiments import loop
from housefly.messages import Action, Behavior, OrderKind, SafetyMode
from housefly.pilot import pilot, step
from housefly.pilot.behavior.acceptor import STATES, AcceptorState
from housefly.pilot.behavior.path_profile import NO_PATH
from housefly.pilot.estimation import boxed_estimator, estimator, pose_estimator
from housefly.pilot.estimation.delay_filter import COMMAND_SPAN
from housefly.pilot.estimation.estimator import (
    estimator_created,
    estimator_initialized,
)
from housefly.pilot.estimation.estimator_state import (
    EstimatorState,
    Measurement,
    PoseEstimate,
)
from housefly.pilot.safety.limits import SafetyModeCode
from housefly.pilot.safety.rules import MODE_SEVERITY
from housefly.pilot.site_parameters import pilot_parameters
from housefly.pilot.step import (
    INITIAL_STEP,
    NO_OVERRIDE,
    Guidance,
    Override,
    StepOutput,
    StepState,
    step_commanded,
)

Fly = Callable[..., Any]
SITE = Site()
SIZE = 64
HERE = PoseEstimate(1.0, 2.0, 1.1, 0.0, 0.0, 0.0, 0.0)
HOLD = Guidance(True, False, 1.0, 2.0, 0.0, nan, 1.1, 1.0)
AWAY = HOLD._replace(x=1.3, y=2.1, yaw=0.2)
REST = HOLD._replace(active=False)


def stepped(
    guidance: Guidance,
    paper: bool = False,
    before: StepState = INITIAL_STEP,
    override: Override = NO_OVERRIDE,
    mode: SafetyModeCode = SafetyModeCode.NOMINAL,
    airborne: bool = True,
) -> tuple[StepState, EstimatorState, StepOutput, np.ndarray]:
    """Return states and decisions of one tick of a drone just seen, and the history."""
    params = pilot_parameters(paper, SITE.drone, SITE.control, SITE.limits)
    history, seen = np.zeros(SIZE, COMMAND_SPAN), Measurement(1.0, 1.0, 2.0, 1.1, 0.0)
    known = estimator_created(history, params.estimator, 1.0)
    known = estimator_initialized(known, history, params.estimator, seen, 1.0)
    state, known, output = step_commanded(
        before, known, history, params, HERE, guidance, NO_PATH,
        override, int(mode), airborne, 1.0, 0.01,
    )  # fmt: skip
    return state, known, output, history


def flown(known: EstimatorState, history: np.ndarray) -> bool:
    """Return whether the newest command in the history is one of ours."""
    return bool(history[known.delay_filter.newest & (history.size - 1)]["flown"])


def test_the_codes_of_compiled_code_are_those_of_the_messages_in_their_order() -> None:
    assert [code.name for code in AcceptorState] == [state.name for state in Behavior]
    assert [int(code) for code in AcceptorState] == [STATES.index(state) for state in Behavior]
    assert [code.name for code in SafetyModeCode] == [mode.name for mode in SafetyMode]
    assert [int(code) for code in SafetyModeCode] == [MODE_SEVERITY[mode] for mode in SafetyMode]


def _names(function: Any) -> tuple[str, ...]:
    """Return what a compiled function calls."""
    names: tuple[str, ...] = getattr(function, "py_func", function).__code__.co_names
    return names


def test_the_live_pilot_and_the_batch_call_the_same_functions() -> None:
    assert pilot.boxed_step is step.boxed_step and "step_commanded" in _names(step.boxed_step)
    assert loop.step_commanded is step.step_commanded
    for name in ("estimator_created", "pose_estimate"):
        own = getattr(estimator, name)
        assert getattr(pose_estimator, name) is getattr(loop, name) is own, name
    assert loop.estimator_updated is boxed_estimator.estimator_updated
    assert pose_estimator.sighting_taken is boxed_estimator.sighting_taken
    assert "estimator_updated" in _names(boxed_estimator.sighting_taken)
    assert pose_estimator.estimated is boxed_estimator.estimated
    assert "estimate_at" in _names(boxed_estimator.estimated)
    assert {"estimator_advanced", "pose_estimate"} <= set(_names(estimator.estimate_at))
    assert loop.estimator_advanced is estimator.estimator_advanced


@pytest.mark.parametrize("paper", [False, True])
def test_while_nothing_is_to_be_tracked_all_rests_and_the_drone_flies_itself(paper: bool) -> None:
    begun = stepped(AWAY, paper)[0]
    state, known, output, history = stepped(REST, paper, begun)
    assert state.acceptor.state == AcceptorState.HOVER and isnan(state.yaw.reference)
    assert not output.flying and not output.command.flown and not flown(known, history)
    assert output.asked == (0.0,) * len(output.asked)


def test_mode_paper_leaves_the_hover_to_the_drone_and_mode_default_flies_it() -> None:
    for paper in (True, False):
        state, known, output, history = stepped(HOLD, paper)
        assert state.acceptor.state == AcceptorState.HOVER
        assert output.flying == output.command.flown == (not paper)
        assert flown(known, history) == (not paper)


def test_what_is_asked_goes_to_the_estimator_as_it_leaves_the_gate() -> None:
    _, known, output, history = stepped(AWAY)
    assert output.command.flown and output.command.theta == output.asked.theta > 0.0
    assert history[known.delay_filter.newest]["ux"] > 0.0 and flown(known, history)
    for change in ({"mode": SafetyModeCode.HOLD}, {"airborne": False}):
        state, known, output, history = stepped(AWAY, **change)
        assert output.flying and not output.command.flown and not flown(known, history)
        assert history[known.delay_filter.newest]["ux"] == output.command.theta == 0.0
        assert state.gate == change.get("mode", SafetyModeCode.NOMINAL)


def test_an_override_takes_the_place_of_control_and_passes_the_same_gate() -> None:
    limit, wild = SITE.limits.tilt_max, Override(True, 9.0, 0.1, 0.0, 0.0)
    for guidance in (HOLD, REST):
        output = stepped(guidance, override=wild)[2]
        assert output.asked[:2] == (9.0, 0.1) and output.flying
        assert output.command[2:4] == (limit, 0.1)
    assert not stepped(HOLD, override=wild, mode=SafetyModeCode.STOPPED)[2].command.flown


def test_an_override_that_is_no_number_levels_the_drone() -> None:
    state, known, output, history = stepped(HOLD, override=Override(True, nan, 0.0, 0.0, 0.0))
    assert output.command == (SafetyModeCode.HOLD, False, 0.0, 0.0, 0.0, 0.0)
    assert state.gate == SafetyModeCode.HOLD and not flown(known, history)


@pytest.mark.parametrize("mode", ["default", "paper"])
def test_in_a_flight_the_estimator_is_told_exactly_what_the_driver_gets(
    fly: Fly, mode: str
) -> None:
    flight = fly(mode=mode)
    flight.depart()
    orders = {40: OrderKind.STOP, 80: OrderKind.RESUME, 120: OrderKind.GO, 700: OrderKind.LAND}
    told = set()
    for tick in range(900):
        kind = orders.get(tick)
        if tick == 300:
            flight.tracking.gaps = ((flight.now, flight.now + 1.0),)
        outputs = flight.step(*((flight.order(kind, goal=(10.75, 1.25)),) if kind else ()))
        own = flight.pilot._estimator
        filtered = own.state.paper_filter
        is_flown = outputs.command.action is Action.FLY
        if mode == "default":
            assert flown(own.state, own.history) == is_flown
        else:
            assert is_flown or (filtered.ux, filtered.uy) == (0.0, 0.0)
        told.add((is_flown, outputs.safety))
    assert {(True, SafetyMode.NOMINAL), (mode == "default", SafetyMode.STOPPED)} <= told
    assert (False, SafetyMode.HOLD) in told
