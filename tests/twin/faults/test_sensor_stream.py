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


def arrivals(fault: str, count: int = 100) -> list[list[tuple[float, int]]]:
    """Return what arrives at each tenth of a second: when it was taken, and its first beam."""
    stream = SensorStream(FaultComponent.LASER, changed_scan)
    schedule = FaultSchedule(parse_fault(fault))
    return [
        [
            (round(taken_at, 6), scan[0])
            for taken_at, scan in stream.read(
                "A",
                lambda n=n: tuple(d + n for d in SCAN),  # type: ignore[misc]
                schedule,
                0.1 * n,
            )
        ]
        for n in range(count)
    ]


def scans(fault: str, count: int = 100) -> list[tuple[int, ...] | None]:
    """Return the scan that arrives at each tenth of a second."""
    stream = SensorStream(FaultComponent.LASER, changed_scan)
    schedule = FaultSchedule(parse_fault(fault))
    read = (
        stream.read("A", lambda n=n: tuple(d + n for d in SCAN), schedule, 0.1 * n)  # type: ignore[misc]
        for n in range(count)
    )
    return [arrived[-1][1] if arrived else None for arrived in read]


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


def test_a_slow_scanner_says_so_much_a_second_and_no_other_is_slowed_by_it() -> None:
    found = scans("laser:slow@5s=2")
    assert None not in found[:50]
    assert found[50:].count(None) == 40
    stream = SensorStream(FaultComponent.LASER, changed_scan)
    schedule = FaultSchedule(parse_fault("laser:slow=2"))
    assert [bool(stream.read(name, lambda: SCAN, schedule, 0.0)) for name in "ABA"] == [
        True, True, False,
    ]  # fmt: skip


@pytest.mark.parametrize("fault", ["laser:delayed@2s+3s=0.5", "laser:delayed@2s+3s=0.25"])
def test_late_scans_come_late_in_order_and_none_is_lost(fault: str) -> None:
    found = arrivals(fault)
    late = float(fault.partition("=")[2])
    told = [(0.1 * at, taken_at, beam) for at, each in enumerate(found) for taken_at, beam in each]
    assert [beam for _, _, beam in told] == [1000 + n for n in range(100)]
    assert all(at == pytest.approx(taken) for at, taken, _ in told if taken < 2.0 or taken > 5.6)
    waited = [at - taken for at, taken, _ in told if 2.0 <= taken < 4.9]
    assert min(waited) == pytest.approx(late, abs=0.051)
    assert max(waited) < late + 0.1


def image_of(pixels: bytes, at: float = 1.0) -> DepthImage:
    return DepthImage("A", at, 2, 1, pixels, 1.0, 1.0, 1.0, 0.5, Pose((0.0, 0.0, 1.0)))


@pytest.mark.parametrize(
    ("size", "told"), [("0.3", [1300, 0, 65535]), ("-0.3", [700, 0, 65000]), ("-5", [1, 0, 60300])]
)
def test_wrong_depths_are_off_and_what_was_not_measured_stays_so(
    size: str, told: list[int]
) -> None:
    (fault,) = parse_fault(f"depth:wrong={size}")
    depths = b"".join(depth.to_bytes(2, "little") for depth in (1000, 0, 65300))
    data = changed_image(fault, image_of(depths), image_of(depths), 1).data
    assert [int.from_bytes(data[at : at + 2], "little") for at in (0, 2, 4)] == told


def test_late_depth_images_keep_their_true_stamps_and_slow_ones_are_fewer() -> None:
    def stamps(fault: str) -> list[float]:
        stream = SensorStream(FaultComponent.DEPTH, changed_image)
        schedule = FaultSchedule(parse_fault(fault))
        return [
            image.captured_at
            for n in range(20)
            for _, image in stream.read(
                "A",
                lambda n=n: image_of(b"abcd", 0.1 * n),  # type: ignore[misc]
                schedule,
                0.1 * n,
            )
        ]

    assert stamps("depth:delayed=0.5") == [0.1 * n for n in range(15)]
    assert stamps("depth:slow=2") == [0.1 * n for n in (0, 5, 10, 15)]


@pytest.mark.parametrize(("kind", "data"), [("stuck", b"old!"), ("garbage", None)])
def test_depth_images_keep_fresh_stamps(kind: str, data: bytes | None) -> None:
    stream = SensorStream(FaultComponent.DEPTH, changed_image)
    schedule = FaultSchedule(parse_fault(f"depth:{kind}"))
    stream.read("A", lambda: image_of(b"old!", 1.0), schedule, 1.0)
    ((_, found),) = stream.read("A", lambda: image_of(b"new!", 2.0), schedule, 2.0)
    assert found.captured_at == 2.0
    assert found.data != b"new!"
    assert data is None or found.data == data
    ((_, other),) = stream.read("B", lambda: image_of(b"more", 2.0), schedule, 2.0)
    assert data is None or other.data == b"more"


@pytest.mark.parametrize("kind", ["off", "stuck", "garbage"])
def test_pictures_stop_stand_still_or_are_noise(kind: str) -> None:
    stream = SensorStream(FaultComponent.VIDEO, changed_picture)
    schedule = FaultSchedule(parse_fault(f"video:{kind}"))
    pictures = [EncodedPicture(n, f"{n}data".encode(), True, 8, 8, 0.1 * n) for n in (1, 2)]
    found = [stream.read("", lambda p=p: p, schedule, p.at) for p in pictures]  # type: ignore[misc]
    if kind == "off":
        assert found == [(), ()]
        return
    ((_, last),) = found[1]
    assert (last.number, last.at) == (2, pictures[1].at)
    assert (last.data == b"1data") == (kind == "stuck")
    assert last.data != b"2data"
