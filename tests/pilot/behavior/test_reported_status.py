from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import DroneStatus, Telemetry
from housefly.pilot.behavior.reported_status import ReportedStatus

ENDS = (DroneStatus.LANDED, DroneStatus.EMERGENCY)


def believed(*told: DroneStatus, first: DroneStatus = DroneStatus.FLYING) -> DroneStatus:
    """Return what is believed of a drone that told these, 5 ms apart."""
    reported = ReportedStatus(first)
    for number, status in enumerate(told):
        reported = reported.updated(Telemetry(0.005 * number, status, 0.9))
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
        once = once.updated(damaged)
    assert once.status is DroneStatus.FLYING
    assert once.updated(replace(damaged, received_at=1.1)).status is DroneStatus.LANDED


@given(st.sampled_from(DroneStatus), st.sampled_from(DroneStatus))
def test_any_other_word_counts_at_once(first: DroneStatus, told: DroneStatus) -> None:
    if told is DroneStatus.UNKNOWN:
        assert believed(told, first=first) is first
    elif told not in ENDS or first not in (DroneStatus.TAKING_OFF, DroneStatus.FLYING):
        assert believed(told, first=first) is told
