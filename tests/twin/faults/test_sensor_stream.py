"""Scanners, depth cameras and pictures that fail."""

from __future__ import annotations

import pytest

from housefly.messages import DepthImage, Pose
from housefly.twin.contracts import EncodedPicture
from housefly.twin.faults.fault import FaultSchedule
from housefly.twin.faults.parse import parse_fault
from housefly.twin.faults.sensor_stream import (
    SensorStream,
    changed_image,
    changed_picture,
    changed_scan,
)
from housefly.twin.faults.vocabulary import FaultComponent

SCAN = tuple(range(1000, 1100))


def scans(fault: str, count: int = 100) -> list[tuple[int, ...] | None]:
    stream = SensorStream(FaultComponent.LASER, changed_scan)
    schedule = FaultSchedule(parse_fault(fault))
    return [
        stream.read("A", lambda n=n: tuple(d + n for d in SCAN), schedule, 0.1 * n)  # type: ignore[misc]
        for n in range(count)
    ]


def test_a_scanner_is_true_but_for_its_faults() -> None:
    found = scans("laser:off@5s+1s")
    assert found[:50] == [tuple(d + n for d in SCAN) for n in range(50)]
    assert found[50:60] == [None] * 10
    assert None not in found[60:]


def test_a_stuck_scanner_says_what_it_said_first() -> None:
    found = scans("laser:stuck@5s")
    assert set(found[50:]) == {found[50]}


def test_a_wrong_scanner_is_off_and_never_below_nothing() -> None:
    assert scans("laser:wrong=0.3")[0] == tuple(d + 300 for d in SCAN)
    assert scans("laser:wrong=-5")[0] == (0,) * 100


def test_a_garbled_scanner_says_something_else_each_time_and_the_same_again() -> None:
    found = scans("laser:garbage#3")
    assert len(set(found)) == 100
    assert found == scans("laser:garbage#3") != scans("laser:garbage#4")


def test_some_scans_are_lost() -> None:
    assert scans("laser:intermittent=0.3").count(None) == pytest.approx(30, abs=15)


@pytest.mark.parametrize(("kind", "data"), [("stuck", b"old!"), ("garbage", None)])
def test_depth_images_keep_fresh_stamps(kind: str, data: bytes | None) -> None:
    def image(at: float, pixels: bytes) -> DepthImage:
        return DepthImage("A", at, 2, 1, pixels, 1.0, 1.0, 1.0, 0.5, Pose((0.0, 0.0, 1.0)))

    stream = SensorStream(FaultComponent.DEPTH, changed_image)
    schedule = FaultSchedule(parse_fault(f"depth:{kind}"))
    stream.read("A", lambda: image(1.0, b"old!"), schedule, 1.0)
    found = stream.read("A", lambda: image(2.0, b"new!"), schedule, 2.0)
    assert found is not None
    assert found.captured_at == 2.0
    assert found.data != b"new!"
    assert data is None or found.data == data
    other = stream.read("B", lambda: image(2.0, b"more"), schedule, 2.0)
    assert other is not None and (data is None or other.data == b"more")


@pytest.mark.parametrize("kind", ["off", "stuck", "garbage"])
def test_pictures_stop_stand_still_or_are_noise(kind: str) -> None:
    stream = SensorStream(FaultComponent.VIDEO, changed_picture)
    schedule = FaultSchedule(parse_fault(f"video:{kind}"))
    pictures = [EncodedPicture(n, f"{n}data".encode(), True, 8, 8, 0.1 * n) for n in (1, 2)]
    found = [stream.read("", lambda p=p: p, schedule, p.at) for p in pictures]  # type: ignore[misc]
    if kind == "off":
        assert found == [None, None]
        return
    last = found[1]
    assert last is not None and (last.number, last.at) == (2, pictures[1].at)
    assert (last.data == b"1data") == (kind == "stuck")
    assert last.data != b"2data"
