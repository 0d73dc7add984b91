"""A rescue is flown by what is believed: flow that fails, a draught, and what a person orders."""

from __future__ import annotations

import json

import pytest

from housefly.lab.safety_case.campaign import fly_alike
from housefly.lab.safety_case.fault_phase import FaultPhase
from housefly.lab.safety_case.faulty_flight import course_of, fly_trial, orders_of
from housefly.lab.safety_case.plan import COURSES, crossed_out, flown_rows, variants_flown
from housefly.lab.safety_case.trial import (
    PersonOrder,
    TrialKey,
    TrialResult,
    result_from_json,
)
from housefly.messages import OrderKind
from housefly.pilot.safety import control_source
from housefly.pilot.safety.control_source import ControlSource

SEED = 12
"""Before a corner, tracking at 30 Hz."""
STUCK = "F46/stuck"


def test_a_sensor_that_fails_before_a_corner_harms_nobody_whatever_a_person_orders() -> None:
    keys = (
        TrialKey(STUCK, SEED, order=PersonOrder.LAND),
        TrialKey(STUCK, SEED, order=PersonOrder.DEAD_PILOT),
        TrialKey("F46/bias_0.6", SEED),
        TrialKey("F48/stuck", SEED, order=PersonOrder.LAND),
        TrialKey("F50/stuck", SEED, order=PersonOrder.DEAD_PILOT),
        TrialKey("F51/1.0", SEED, order=PersonOrder.STOP),
    )
    assert len({course_of(key) for key in keys}) == 1
    flown = {(r.key.row, r.key.order): r for r in fly_alike(keys)}
    assert len(flown) == len(keys)
    assert {key: r.violations for key, r in flown.items() if r.unsafe} == {}
    assert all(result.phase is FaultPhase.CORNER for result in flown.values())
    told = flown["F46/bias_0.6", PersonOrder.NOTHING].told_after
    assert told is not None and told < 0.5


def test_left_to_the_drones_own_hover_the_same_stop_ends_at_the_wall(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(
        control_source,
        "CONTROL_SOURCES",
        dict.fromkeys(control_source.CONTROL_SOURCES, ControlSource.ONBOARD_HOVER),
    )
    harmed = fly_trial(TrialKey(STUCK, SEED, order=PersonOrder.STOP))
    assert any(words.startswith("I1: touched") for words in harmed.violations)


def test_crossed_rows_are_flown_with_every_order_in_every_phase() -> None:
    rows = [row for row in flown_rows() if row.crossed]
    assert [row.number for row in rows] == ["F46", "F47", "F48", "F49", "F50", "F51", "F52"]
    for row in rows:
        most = len(variants_flown(row)) * len(PersonOrder) * COURSES
        keys = crossed_out(variants_flown(row), most)
        assert len(set(keys)) == len(keys) == most
        assert crossed_out(variants_flown(row), 50) == keys[:50]
        assert len({key.seed for key in keys[:50]}) == COURSES
        assert {(key.row, key.order) for key in keys} == {
            (name, order) for name in variants_flown(row) for order in PersonOrder
        }
    assert crossed_out((), 50) == []


@pytest.mark.parametrize("order", PersonOrder)
def test_whatever_a_person_orders_ends_in_a_landing_soon_after_the_fault(
    order: PersonOrder,
) -> None:
    orders = orders_of(TrialKey(STUCK, 3, order=order))
    kinds = [given.kind for _, given in orders]
    is_ordered = order not in (PersonOrder.NOTHING, PersonOrder.DEAD_PILOT)
    assert (kinds[-1:] == [OrderKind.LAND]) is is_ordered
    assert all(0.2 <= after <= 12.0 for after, _ in orders)


def test_an_order_is_kept_with_its_result_and_older_results_had_none() -> None:
    key = TrialKey(STUCK, 3, order=PersonOrder.STOP)
    result = TrialResult(key, FaultPhase.LOOK, (), "", None, None, 0.0, None, None, 0.0)
    kept = result.to_json()
    assert result_from_json(json.dumps(kept)) == result
    del kept["key"]["order"]
    assert result_from_json(json.dumps(kept)).key == TrialKey(STUCK, 3)
