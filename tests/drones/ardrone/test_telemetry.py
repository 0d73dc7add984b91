"""Which reports count: pure."""

from __future__ import annotations

import asyncio

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.clock import RealClock
from housefly.drones.ardrone.telemetry import NAVDATA_TIMEOUT, NavdataLink, NavdataReports
from housefly.messages import DroneStatus
from housefly.wires.ardrone.navdata import RawOption, StateBits, encode_navdata
from housefly.wires.ardrone.navdata_options import Demo, MajorState


def report(sequence: int, height: int = 1000, state: int = 0) -> bytes:
    return encode_navdata(
        state,
        sequence,
        [Demo(ctrl_state=MajorState.FLYING << 16, battery_percent=50, altitude=height)],
    )


def test_the_newest_report_is_told_in_our_units() -> None:
    reports = NavdataReports()
    assert reports.telemetry is None
    assert reports.accept(report(1), 10.0)
    told = reports.telemetry
    assert told is not None
    assert (told.status, told.battery, told.height, told.received_at) == (
        DroneStatus.FLYING,
        0.5,
        1.0,
        10.0,
    )


@given(st.permutations(range(20)))
def test_late_and_repeated_reports_do_not_turn_time_back(order: list[int]) -> None:
    reports, newest = NavdataReports(), -1
    for step, sequence in enumerate(order):
        for _ in range(2):
            reports.accept(report(sequence, height=sequence), step * 1e-3)
        newest = max(newest, sequence)
        assert reports.telemetry is not None
        assert reports.telemetry.height == newest / 1000
    assert reports.old >= len(order)


def test_after_a_silence_a_drone_that_started_again_is_heard() -> None:
    reports = NavdataReports()
    reports.accept(report(5000), 0.0)
    assert not reports.accept(report(1), 0.5 * NAVDATA_TIMEOUT)
    assert reports.accept(report(2), 2 * NAVDATA_TIMEOUT)
    assert reports.packet is not None and reports.packet.sequence == 2


@given(st.lists(st.binary(max_size=100), max_size=20))
def test_garbage_is_counted_and_changes_nothing(garbage: list[bytes]) -> None:
    reports = NavdataReports()
    reports.accept(report(7), 1.0)
    before = reports.telemetry
    for data in garbage:
        assert not reports.accept(data, 1.1)
    assert reports.broken == len(garbage)
    assert reports.telemetry is before


def test_a_report_that_makes_no_sense_leaves_the_one_before() -> None:
    reports = NavdataReports()
    reports.accept(report(1), 1.0)
    reports.accept(encode_navdata(0, 2, [Demo(theta=float("nan"))]), 1.1)
    reports.accept(encode_navdata(0, 3, [RawOption(0, b"short")]), 1.2)
    assert reports.telemetry is not None and reports.telemetry.received_at == 1.0
    reports.accept(encode_navdata(StateBits.NAVDATA_BOOTSTRAP, 4), 1.3)
    assert reports.telemetry.received_at == 1.0


def test_the_rate_is_of_the_last_second() -> None:
    reports = NavdataReports()
    for n in range(300):
        reports.accept(report(n), n * 0.01)
    assert 99 <= reports.rate_hz(2.99) <= 101
    assert reports.rate_hz(10.0) == 0


def test_an_unread_report_is_not_lost_to_a_bootstrap_packet() -> None:
    reports = NavdataReports()
    reports.accept(report(1), 1.0)
    reports.accept(encode_navdata(StateBits.NAVDATA_BOOTSTRAP, 2), 1.1)
    assert reports.telemetry is not None and reports.telemetry.received_at == 1.0


@pytest.mark.parametrize("timeout", [None, 10.0])
async def test_who_waits_for_a_report_and_is_told_to_end_as_it_comes_ends(
    timeout: float | None,
) -> None:
    link = NavdataLink("127.0.0.1", RealClock())
    waiting = asyncio.create_task(link.wait_for(lambda packet: True, timeout))
    await asyncio.sleep(0)
    link.datagram_received(report(1), ("127.0.0.1", 5554))
    waiting.cancel()
    with pytest.raises(asyncio.CancelledError):
        await waiting


async def test_nobody_waits_for_a_report_for_longer_than_he_said() -> None:
    link = NavdataLink("127.0.0.1", RealClock())
    assert await link.wait_for(lambda packet: True, 0.01) is None
    link.datagram_received(report(1), ("127.0.0.1", 5554))
