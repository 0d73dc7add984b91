"""An answer that needs more knowledge than there is becomes one that needs less."""

from __future__ import annotations

from dataclasses import replace
from math import nan

import pytest
from gate_flight import AIRFRAME
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import Airframe, airframe_named
from housefly.config.limits import LimitsConfig
from housefly.messages import DroneFault, DroneStatus, SafetyMode, Telemetry
from housefly.messages.words import UNSAID, Words
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.drone_rules import DESCENT_MARGIN
from housefly.pilot.safety.fallbacks import can_wait_to_land, possible_mode
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.limits import DESCENT_RATE
from housefly.pilot.safety.observer import FlightObservations
from housefly.pilot.safety.rule import RuleContext
from housefly.pilot.safety.rules import MODE_SEVERITY

M = SafetyMode
FENCE = Geofence((0.0, 0.0, 10.0, 5.0), 2.4)
FINE = GateInputs(
    10.0, DroneStatus.FLYING, 0.9, 0.01, 0.05, (5.0, 2.0, 1.1), False, False, telemetry=None
)
DEAF = Telemetry(10.0, DroneStatus.FLYING, 0.9, faults=(DroneFault.ULTRASOUND_DEAF,))
LONGEST = FENCE.ceiling / DESCENT_RATE + DESCENT_MARGIN


def mode(
    wanted: SafetyMode,
    landing_for: float = 0.0,
    airframe: Airframe = AIRFRAME,
    **changes: object,
) -> SafetyMode:
    inputs = replace(FINE, **changes)  # type: ignore[arg-type]
    seen = FlightObservations(landing_for=landing_for)
    return possible_mode(wanted, RuleContext(inputs, seen, LimitsConfig(), FENCE, airframe))


@given(st.sampled_from(SafetyMode), st.booleans(), st.floats(0.0, 9.0), st.floats(-1.0, 1.0))
def test_what_takes_the_place_of_an_answer_is_never_milder(
    wanted: SafetyMode, has_way: bool, age: float, error: float
) -> None:
    known = TrackingConsistency(height_error=error)
    found = mode(wanted, has_way_home=has_way, pose_age=age, consistency=known)
    assert MODE_SEVERITY[found] >= MODE_SEVERITY[wanted]
    assert found is wanted or wanted in (M.RETURN, M.LAND)


@pytest.mark.parametrize(
    "changes",
    [
        {"has_way_home": False},
        {"pose_age": 2.01},
        {"pose_age": nan},
        {"consistency": TrackingConsistency(refused_for=2.01)},
        {"consistency": TrackingConsistency(mirrored=True)},
    ],
)
def test_without_a_way_home_or_a_place_to_believe_it_lands_instead(
    changes: dict[str, object],
) -> None:
    assert mode(M.RETURN) is M.RETURN
    assert mode(M.RETURN, **changes) is M.LAND


@pytest.mark.parametrize(
    "changes",
    [
        {"pose_age": 0.26},
        {"pose_age": 2.0},
        {"consistency": TrackingConsistency(refused_for=0.1)},
        {"consistency": TrackingConsistency(refused_for=2.0)},
    ],
)
def test_a_place_in_doubt_for_a_moment_is_no_reason_to_land_on_the_way_home(
    changes: dict[str, object],
) -> None:
    assert mode(M.RETURN, **changes) is M.RETURN


def test_a_drone_that_does_not_know_its_height_sinks_by_our_setpoint() -> None:
    assert mode(M.LAND) is M.LAND
    assert mode(M.LAND, telemetry=DEAF) is M.LAND, "the pilot sinks it to the floor"
    assert mode(M.LAND, telemetry=DEAF, pose_age=0.3) is M.DESCEND
    assert mode(M.LAND, consistency=TrackingConsistency(height_error=-0.31)) is M.DESCEND
    assert mode(M.RETURN, has_way_home=False, telemetry=DEAF, pose_age=0.3) is M.DESCEND
    assert mode(M.RETURN, consistency=TrackingConsistency(height_error=-0.31)) is M.DESCEND


def test_something_below_is_no_reason_to_sink_onto_it() -> None:
    assert mode(M.LAND, consistency=TrackingConsistency(height_error=0.9)) is M.LAND


BLOCKED = Words("somebody is below")


@pytest.mark.parametrize(
    ("waits", "late_steps", "changes"),
    [
        (True, 0, {}),
        (True, 0, {"telemetry_age": LimitsConfig().telemetry_age}),
        (False, 0, {"telemetry_age": LimitsConfig().telemetry_age + 0.01}),
        (False, 0, {"telemetry_age": nan}),
        (False, 0, {"status": DroneStatus.LANDING}),
        (False, 0, {"landing_blocker": UNSAID}),
        (False, 0, {"consistency": TrackingConsistency(flow_wrong=True)}),
        (False, 1, {}),
    ],
)
def test_a_landing_waits_for_what_stands_below_while_the_drone_can_keep_its_place(
    waits: bool, late_steps: int, changes: dict[str, object]
) -> None:
    inputs = replace(FINE, **({"landing_blocker": BLOCKED} | changes))  # type: ignore[arg-type]
    seen = FlightObservations(late_steps=late_steps)
    assert can_wait_to_land(RuleContext(inputs, seen, LimitsConfig(), FENCE, AIRFRAME)) is waits


def test_a_descent_ends_on_the_floor_or_where_the_floor_must_be() -> None:
    own = {"telemetry": DEAF, "steers": False}
    assert mode(M.LAND, **own, position=(5.0, 2.0, 0.09)) is M.LAND
    assert mode(M.LAND, **own, position=(5.0, 2.0, 0.11)) is M.DESCEND
    assert mode(M.LAND, telemetry=DEAF, position=None) is M.DESCEND
    assert mode(M.LAND, LONGEST - 0.1, **own) is M.DESCEND
    assert mode(M.LAND, LONGEST + 0.1, **own) is M.LAND


@pytest.mark.parametrize("flow", ["flow_wrong", "flow_untold"])
def test_without_place_and_own_speed_no_landing_is_left_to_the_drone(flow: str) -> None:
    doubted = TrackingConsistency(**{flow: True})  # type: ignore[arg-type]
    assert mode(M.LAND, consistency=doubted, pose_age=0.3) is M.DESCEND
    assert mode(M.LAND, consistency=doubted) is M.LAND, "the pilot sinks it to the floor"


@pytest.mark.parametrize("model", ["arducopter", "px4"])
def test_one_whose_own_loops_land_it_at_rest_is_told_to_at_once(model: str) -> None:
    own = airframe_named(model)
    assert own.lands_itself and not AIRFRAME.lands_itself
    for wanted in (M.DESCEND, M.LAND):
        assert mode(wanted, airframe=own, pose_age=0.3) is M.LAND
    assert mode(M.LAND, airframe=own) is M.LAND
    assert mode(M.RETURN, airframe=own, has_way_home=False, pose_age=0.3) is M.LAND
