"""What each row promises in numbers, and what a flight missed of it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from housefly.lab.safety_case.fault_phase import FaultPhase
from housefly.lab.safety_case.faulty_flight import fly_trial, variant_of
from housefly.lab.safety_case.outcome_bounds import (
    OUTCOME_BOUNDS,
    OutcomeBounds,
    bounds_of,
    missed_bounds,
)
from housefly.lab.safety_case.plan import FAULT_FREE
from housefly.lab.safety_case.trial import TrialKey, TrialResult
from housefly.twin.faults.catalogue import row_of

WITHIN = TrialResult(
    key=TrialKey("F17/off", 1),
    phase=FaultPhase.CRUISE,
    violations=(),
    ending="stands on the floor",
    told_after=1.1,
    safe_after=10.0,
    deviation=0.6,
    room_clearance=0.2,
    person_clearance=None,
    top_speed=0.5,
)


@pytest.mark.parametrize("name", [name for name in OUTCOME_BOUNDS if name != FAULT_FREE])
def test_every_promise_is_of_a_row_or_a_variant_of_the_matrix(name: str) -> None:
    number, _, variant = name.partition("/")
    assert row_of(number).variants
    assert not variant or variant_of(name).name == variant


def test_a_variant_has_its_own_promise_else_that_of_its_row_and_a_pair_has_none() -> None:
    assert bounds_of("F12/unstamped_0.3s") is not bounds_of("F12") is bounds_of("F12/0.2s")
    assert bounds_of("F17/off") is OUTCOME_BOUNDS["F17"]
    assert bounds_of("F17+F25") == OutcomeBounds()


def test_who_keeps_just_within_the_promise_misses_nothing() -> None:
    assert missed_bounds(WITHIN) == ()


@pytest.mark.parametrize(
    ("flown", "missed"),
    [
        ({"told_after": 1.2}, "told after 1.2 s (promised 1.1 s)"),
        ({"told_after": None}, "told never (promised 1.1 s)"),
        ({"safe_after": 11.0}, "on the floor after 11.0 s (promised 10 s)"),
        ({"safe_after": None}, "on the floor never (promised 10 s)"),
        ({"deviation": 0.66}, "0.66 m from its path (promised 0.6 m)"),
    ],
)
def test_what_is_missed_is_said_in_words(flown: dict[str, float], missed: str) -> None:
    assert missed_bounds(replace(WITHIN, **flown)) == (missed,)


@pytest.mark.parametrize("phase", [FaultPhase.BEFORE_TAKE_OFF, FaultPhase.LANDING])
def test_times_count_only_for_what_begins_in_flight(phase: FaultPhase) -> None:
    late = replace(WITHIN, phase=phase, told_after=None, safe_after=None)
    assert missed_bounds(late) == ()
    assert len(missed_bounds(replace(late, deviation=0.7))) == 1


def test_what_is_to_pass_unnoticed_and_is_told_is_a_false_alarm() -> None:
    calm = replace(WITHIN, key=TrialKey(FAULT_FREE, 1), deviation=0.05, told="a fence")
    assert missed_bounds(calm) == ("told: a fence",)
    assert missed_bounds(replace(calm, told_after=None)) == ()


@pytest.mark.parametrize(
    "flight",
    [
        pytest.param(TrialKey("F02/1s", 1), marks=pytest.mark.safety),
        TrialKey("F10/no_rotation", 4),
        pytest.param(TrialKey("F16/up_1s", 38), marks=pytest.mark.safety),
    ],
    ids=lambda key: key.row,
)
def test_flights_that_missed_their_promise_once_keep_it(flight: TrialKey) -> None:
    result = fly_trial(flight)
    assert not result.unsafe
    assert missed_bounds(result) == ()
