from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.validation import (
    CLOCK_TOLERANCE,
    SIGHTING_AGE_MAX,
    STAMP_REJECTIONS,
    StampFault,
    stamp_fault,
)


@given(st.floats(0.0, 2.0), st.floats(-0.01, 0.02), st.floats(0.0, 2.0))
def test_a_stamp_is_judged_by_the_clock_and_by_the_one_before(
    captured: float, ahead: float, last: float
) -> None:
    now, expected = captured - ahead, StampFault.NONE
    if captured > now + CLOCK_TOLERANCE:
        expected = StampFault.FUTURE
    elif captured <= last:
        expected = StampFault.OUT_OF_ORDER
    assert stamp_fault(captured, now, last) == expected
    assert stamp_fault(captured, captured + SIGHTING_AGE_MAX + 0.1, -1.0) == StampFault.STALE


def test_every_fault_of_a_stamp_is_a_reason_to_reject() -> None:
    assert set(STAMP_REJECTIONS) == set(StampFault) - {StampFault.NONE}
