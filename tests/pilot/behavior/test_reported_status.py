from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import DroneStatus, Telemetry
from housefly.pilot.behavior.reported_status import ReportedStatus

ENDS = (DroneStatus.LANDED, DroneStatus.EMERGENCY)


def believed(
    *told: DroneStatus, first: DroneStatus = DroneStatus.FLYING, ends: bool = False
) -> DroneStatus:
    """Return what is believed of a drone that told these, 5 ms apart; ``ends`` when told to."""
    reported = ReportedStatus(first)
    for number, status in enumerate(told):
        report = Telemetry(0.005 * number, status, 0.9)
        reported = reported.updated(report, told_to_end=ends)
    return reported.status


@pytest.mark.parametrize("end", ENDS)
@pytest.mark.parametrize("first", [DroneStatus.TAKING_OFF, DroneStatus.FLYING])
def test_the_end_of_a_flight_takes_two_reports_in_a_row(
    first: DroneStatus, end: DroneStatus
) -> None:
    assert believed(end, first=first) is first
    assert believed(end, first, end, first=first) is first
    assert believed(end, end, first=first) is end
    assert believed(end, DroneStatus.UNKNOWN, end, first=first) is end


def test_one_report_that_is_read_again_stays_one() -> None:
    once = ReportedStatus(DroneStatus.FLYING)
    damaged = Telemetry(1.0, DroneStatus.LANDED, 0.9)
    for _ in range(5):
        once = once.updated(damaged, told_to_end=False)
    assert once.status is DroneStatus.FLYING
    again = once.updated(replace(damaged, received_at=1.1), told_to_end=False)
    assert again.status is DroneStatus.LANDED


@pytest.mark.parametrize("end", ENDS)
def test_a_drone_that_was_told_to_end_its_flight_is_believed_at_once(end: DroneStatus) -> None:
    assert believed(end, ends=True) is end


@given(st.sampled_from(DroneStatus), st.sampled_from(DroneStatus))
def test_any_other_word_counts_at_once(first: DroneStatus, told: DroneStatus) -> None:
    if told is DroneStatus.UNKNOWN:
        assert believed(told, first=first) is first
    elif told not in ENDS or first not in (DroneStatus.TAKING_OFF, DroneStatus.FLYING):
        assert believed(told, first=first) is told
