"""Scans and images of sensors that fail or lie."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from random import Random
from typing import Generic, TypeVar

from housefly.messages import DepthImage
from housefly.twin.contracts import EncodedPicture
from housefly.twin.faults.fault import Fault, FaultSchedule
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind

Reading = TypeVar("Reading")
Scan = tuple[int, ...]
_FARTHEST = 10_000
"""Longest distance of a scan at random [mm]."""


class SensorStream(Generic[Reading]):
    """The readings of all sensors of one kind, by name.

    Args:
        component: whose faults count.
        changed: makes another reading of one: fault, the reading now, the reading at which the
            fault began, number of the reading.
    """

    def __init__(
        self,
        component: FaultComponent,
        changed: Callable[[Fault, Reading, Reading, int], Reading],
    ) -> None:
        self._component, self._changed = component, changed
        self._first: dict[tuple[Fault, str], Reading] = {}
        self._numbers: dict[str, int] = {}

    def read(
        self, name: str, take: Callable[[], Reading], schedule: FaultSchedule, now: float
    ) -> Reading | None:
        """Return what a sensor says now [s]; None when it says nothing."""
        reading = take()
        number = self._numbers[name] = self._numbers.get(name, 0) + 1
        for fault in schedule.active(now, self._component):
            first = self._first.setdefault((fault, name), reading)
            if fault.kind is FaultKind.OFF or (
                fault.kind is FaultKind.INTERMITTENT and fault.strikes(number)
            ):
                return None
            reading = self._changed(fault, reading, first, number)
        return reading


def changed_scan(fault: Fault, scan: Scan, first: Scan, number: int) -> Scan:
    """Return the distances [mm] that a faulty scanner tells."""
    if fault.kind is FaultKind.STUCK:
        return first
    if fault.kind is FaultKind.GARBAGE:
        random = Random(f"{fault.seed} {number}")
        return tuple(random.randrange(_FARTHEST) for _ in scan)
    if fault.kind is FaultKind.WRONG:
        off = round(1000.0 * fault.size)
        return tuple(max(0, distance + off) for distance in scan)
    return scan


def changed_image(fault: Fault, image: DepthImage, first: DepthImage, number: int) -> DepthImage:
    """Return the image that a faulty depth camera sends; its stamp stays fresh."""
    if fault.kind is FaultKind.STUCK:
        return replace(first, captured_at=image.captured_at)
    if fault.kind is FaultKind.GARBAGE:
        noise = Random(f"{fault.seed} {number}").randbytes(len(image.data))
        return replace(image, data=noise)
    return image


def changed_picture(
    fault: Fault, picture: EncodedPicture, first: EncodedPicture, number: int
) -> EncodedPicture:
    """Return the picture that a faulty camera sends; its number and stamp stay fresh."""
    if fault.kind is FaultKind.STUCK:
        return replace(first, number=picture.number, at=picture.at)
    if fault.kind is FaultKind.GARBAGE:
        noise = Random(f"{fault.seed} {number}").randbytes(len(picture.data))
        return replace(picture, data=noise)
    return picture
