"""Converts NatNet frames to poses in metres; holds the state that spans frames."""

from __future__ import annotations

from collections.abc import Iterable

from housefly.errors import WireError
from housefly.messages import Sighting
from housefly.tracking.counts import FrameCounts
from housefly.tracking.poses import checked_pose
from housefly.tracking.sender_clock import SenderClock
from housefly.wires.natnet import ModelDef, NatNetFrame

_LATENCY_MAX = 5.0


class NatNetFrames:
    """Converts the messages of one server to sightings.

    Args:
        clock_hz: ticks per second of the server's stamps [Hz].
        latency: from exposure to arrival [s], where the server does not say it.
        y_up: whether the server streams with y up.
        counts: kept up to date.

    Attributes:
        wants_names: whether the server must be asked for the names of the bodies (again).
    """

    def __init__(self, clock_hz: int, latency: float, y_up: bool, counts: FrameCounts) -> None:
        self.wants_names = True
        self._period = 1.0 / clock_hz
        self._latency = latency
        self._y_up = y_up
        self._counts = counts
        self._clock = SenderClock(counts)
        self._names: dict[int, str] = {}

    def learn_names(self, model: ModelDef) -> None:
        """Learn which number is which body."""
        self._names = {body.identity: body.name for body in model.bodies}
        self.wants_names = False

    def forget_names(self) -> None:
        """Drop all names: the server may have been replaced by one that numbers its bodies anew."""
        self._names = {}
        self.wants_names = True

    def read(self, frame: NatNetFrame, received_at: float) -> tuple[Sighting, ...] | None:
        """Return the bodies seen in a frame, or None when the frame is not new."""
        jumps_before = self._counts.jumps
        captured_at = self._captured_at(frame, received_at)
        self.wants_names = self.wants_names or frame.changed or self._counts.jumps > jumps_before
        if captured_at is None:
            return None
        self._counts.frames += 1
        return tuple(self._sightings(frame, captured_at, received_at))

    def _captured_at(self, frame: NatNetFrame, received_at: float) -> float | None:
        """Return the middle of the exposure on our clock, or the time of sending if not known."""
        if not frame.exposed:
            return self._clock.captured_at(frame.sent, self._period, self._latency, received_at)
        latency = (frame.sent - frame.exposed) * self._period
        if not 0 <= latency < _LATENCY_MAX:
            self._counts.misstamped += 1
            latency = self._latency
        return self._clock.captured_at(frame.exposed, self._period, latency, received_at)

    def _sightings(
        self, frame: NatNetFrame, captured_at: float, received_at: float
    ) -> Iterable[Sighting]:
        for body in frame.bodies:
            name = self._names.get(body.identity)
            if name is None:
                self._counts.unnamed += 1
                self.wants_names = True
            elif body.tracked:
                try:
                    pose = checked_pose(body.position, body.orientation, self._y_up)
                except WireError:
                    self._counts.refuse(name, body.position, received_at)
                else:
                    yield Sighting(name, pose, captured_at, received_at)
