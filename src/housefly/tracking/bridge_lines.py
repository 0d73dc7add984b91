"""Converts the lines of the bridge's child to poses; holds the state that spans lines."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

from housefly.errors import LinkError, WireError
from housefly.messages import Sighting
from housefly.tracking.counts import FrameCounts
from housefly.tracking.poses import checked_pose


class BridgeLines:
    """Converts lines to sightings.

    ``motioncapture`` gives no capture time: it is the time of arrival less the configured latency,
    so network jitter moves the drone. With some systems it repeats the last pose of a lost body:
    a pose equal to the last one, bit for bit, is dropped.

    Args:
        latency: from exposure to arrival [s].
        y_up: whether the system has y up.
        counts: kept up to date.
    """

    def __init__(self, latency: float, y_up: bool, counts: FrameCounts) -> None:
        self._latency = latency
        self._y_up = y_up
        self._counts = counts
        self._last: dict[str, list[float]] = {}

    def read(self, line: bytes, received_at: float) -> tuple[Sighting, ...] | None:
        """Return the bodies of a line, or None when nothing in it is new.

        Raises:
            LinkError: the child reports a failure.
            WireError: the line makes no sense.
        """
        bodies = _bodies(line)
        fresh = {
            name: numbers for name, numbers in bodies.items() if self._last.get(name) != numbers
        }
        self._last = bodies
        if not fresh:
            self._counts.repeated += bool(bodies)
            return None
        self._counts.frames += 1
        return tuple(self._sightings(fresh, received_at))

    def _sightings(self, bodies: dict[str, list[float]], received_at: float) -> Iterable[Sighting]:
        for name, (px, py, pz, w, x, y, z) in bodies.items():
            try:
                pose = checked_pose((px, py, pz), (w, x, y, z), self._y_up)
            except WireError:
                self._counts.refuse(name, (px, py, pz), received_at)
            else:
                yield Sighting(name, pose, received_at - self._latency, received_at)


def _bodies(line: bytes) -> dict[str, list[float]]:
    try:
        tree: Any = json.loads(line)
        if "problem" in tree:
            raise LinkError(f"motioncapture says: {tree['problem']}")
        bodies = {
            str(name): [float(number) for number in numbers]
            for name, numbers in tree["bodies"].items()
        }
    except (
        ValueError,
        TypeError,
        KeyError,
        AttributeError,
        OverflowError,
        RecursionError,
    ) as error:
        raise WireError(f"bridge line: {line[:40]!r} is no frame") from error
    if any(len(numbers) != 7 for numbers in bodies.values()):
        raise WireError("bridge line: a pose has seven numbers")
    return bodies
