"""Scans and images of sensors that fail or lie."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from random import Random
from typing import Generic, TypeVar

import numpy as np

from housefly.messages import DepthImage
from housefly.twin.contracts import EncodedPicture
from housefly.twin.faults.delay_line import DelayLine
from housefly.twin.faults.fault import Fault, FaultSchedule
from housefly.twin.faults.slots import Slots
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind

Reading = TypeVar("Reading")
Scan = tuple[int, ...]
_FARTHEST = 10_000
"""Longest distance of a scan at random [mm]."""
_DEEPEST = 2**16 - 1
"""Largest depth that an image can say [mm]."""


class SensorStream(Generic[Reading]):
    """The readings of all sensors of one kind, by name.

    Args:
        component: whose faults count.
        changed: makes another reading of one: fault, the reading now, the reading at which the
            fault began, number of the reading.
        thins: whether a rate that falls leaves out readings here; else where they are taken.
    """

    def __init__(
        self,
        component: FaultComponent,
        changed: Callable[[Fault, Reading, Reading, int], Reading],
        *,
        thins: bool = True,
    ) -> None:
        self._component, self._changed, self._thins = component, changed, thins
        self._first: dict[tuple[Fault, str], Reading] = {}
        self._numbers: dict[str, int] = {}
        self._slots: dict[str, Slots] = {}
        self._under_way: dict[str, DelayLine[Reading]] = {}

    def read(
        self, name: str, take: Callable[[], Reading], schedule: FaultSchedule, now: float
    ) -> tuple[tuple[float, Reading], ...]:
        """Return what arrives now [s] of what a sensor says, oldest first.

        Each with the time at which it was taken [s]; nothing when it says nothing, and what is
        late with the first reading that is taken after its time.
        """
        reading: Reading | None = take()
        number = self._numbers[name] = self._numbers.get(name, 0) + 1
        active = schedule.active(now, self._component)
        for fault in active:
            if reading is None:
                break
            first = self._first.setdefault((fault, name), reading)
            lost = self._loses(fault, name, number, now)
            reading = None if lost else self._changed(fault, reading, first, number)
        under_way = self._under_way.setdefault(name, DelayLine())
        if reading is not None:
            under_way.put(reading, active, now)
        return under_way.arrived(now)

    def _loses(self, fault: Fault, name: str, number: int, now: float) -> bool:
        if fault.kind is FaultKind.SLOW:
            return self._thins and not self._slots.setdefault(name, Slots()).opens(fault, now)
        return fault.kind is FaultKind.OFF or (
            fault.kind is FaultKind.INTERMITTENT and fault.strikes(number)
        )


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
    if fault.kind is FaultKind.WRONG:
        return replace(image, data=_deeper(image.data, round(1000.0 * fault.size)))
    return image


def _deeper(data: bytes, by: int) -> bytes:
    """Return depths that are off [mm]; what was measured stays measured, what was not is not."""
    depths = np.frombuffer(data, "<u2").astype(np.int64)
    off = np.clip(depths + by, 1, _DEEPEST)
    return np.where(depths == 0, 0, off).astype("<u2").tobytes()


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
