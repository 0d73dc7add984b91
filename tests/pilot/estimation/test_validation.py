from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.pilot.estimation.validation import (
    CLOCK_TOLERANCE,
    REJECTION_REPORT_PERIOD,
    SIGHTING_AGE_MAX,
    STAMP_REJECTIONS,
    RejectionLog,
    RejectionReason,
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


def told(period: float, *accepted: bool) -> list[str]:
    """Return what is told of sightings that come so often [s], accepted or refused."""
    log, words = RejectionLog(), list[str]()
    for number, is_accepted in enumerate(accepted):
        if is_accepted:
            log.accepted()
        else:
            events = log.reject(RejectionReason.JUMP, period * number)
            words.extend(event.text for event in events)
    return words


def test_tracking_that_is_refused_in_part_is_told_and_not_with_every_pose() -> None:
    words = told(0.01, *([True, False] * 150))
    assert len(words) == 1 + int(3.0 // REJECTION_REPORT_PERIOD)
    assert words[0].startswith(
        "tracking is believed in part, 5 of the last 10 poses are not: it is"
    )
    assert "15 of the last 30" in words[1]


def test_single_outliers_and_short_bursts_are_refused_without_words() -> None:
    assert told(0.01, *([True] * 9 + [False]) * 30) == []
    assert told(0.01, *([True] * 100 + [False] * 40 + [True] * 100)) == []
    assert len(told(0.01, *([True] * 100 + [False] * 60 + [True] * 100))) == 1
