"""The figures of a row are honest at its ends."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from housefly.lab.safety_case.fault_phase import FaultPhase
from housefly.lab.safety_case.statistics import harmless_controls, spread, upper_bound
from housefly.lab.safety_case.trial import TrialKey, TrialResult
from housefly.twin.faults.catalogue import FAULT_CATALOGUE


def control(row: str, seed: int, violations: tuple[str, ...]) -> TrialResult:
    """Return how a flight without guards ended."""
    key = TrialKey(row, seed, guarded=False)
    return TrialResult(key, FaultPhase.CRUISE, violations, "", None, None, 0.0, None, None, 0.5)


def test_no_unsafe_flight_in_three_hundred_bounds_the_share_by_one_percent() -> None:
    assert 0.0099 < upper_bound(0, 300) < 0.01


@given(st.integers(1, 500), st.data())
def test_the_bound_lies_above_the_share_and_grows_with_it(total: int, data: st.DataObject) -> None:
    hits = data.draw(st.integers(0, total - 1))
    assert hits / total < upper_bound(hits, total) <= upper_bound(hits + 1, total) <= 1.0


def test_a_spread_leaves_out_what_was_not_measured() -> None:
    assert spread([None, None]) is None
    found = spread([None, 3.0, 1.0, 2.0])
    assert found is not None
    assert (found.median, found.largest) == (2.0, 3.0)


def test_a_harmful_row_that_does_no_harm_without_guards_shows_nothing() -> None:
    harm = ("I1: touched room wall at 0.5 m/s",)
    flown = [
        control("F13/2cm", 0, ()),
        control("F13/2cm", 1, harm),
        control("F05", 0, ()),
        replace(control("F05", 1, harm), key=TrialKey("F05", 1)),
    ]
    assert harmless_controls(flown, FAULT_CATALOGUE) == ("F05",)
    assert harmless_controls(flown[:2], FAULT_CATALOGUE) == ()
