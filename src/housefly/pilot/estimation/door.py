"""The part that both estimators share: the drone's own sightings, checked, in order, with a restart
on the ground.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from math import inf

from housefly.geometry import Vec3
from housefly.messages import Event, Severity, Sighting
from housefly.pilot.estimation.height_yaw import Upright, stood, upright_seen
from housefly.pilot.estimation.intake import Complaints, Refusal, Refused, fault_of

RESTART_AFTER = 0.5
"""On the ground, after refusing jumps for this long, the new place is believed [s]."""


class Door(ABC):
    """Lets believable sightings of one body into a filter; the filter itself is in the subclasses."""

    def __init__(self, body: str, position_noise: float) -> None:
        self._body = body
        self._position_noise = position_noise
        self._complaints = Complaints()
        self._last_capture = -inf
        self._refusing = False
        self._upright: Upright | None = None
        self._believed: Sighting | None = None
        self._place: Vec3 | None = None

    @property
    def believed(self) -> Sighting | None:
        """The newest sighting that was taken in."""
        return self._believed

    @property
    def refused(self) -> Refused:
        """How many sightings were not believed, and why."""
        return self._complaints.refused

    def see(self, sightings: tuple[Sighting, ...], now: float, grounded: bool) -> tuple[Event, ...]:
        """Take in sightings of the drone's body; on the ground the filter may start anew where the
        drone was carried to.
        """
        events: list[Event] = []
        for sighting in sightings:
            if sighting.body == self._body:
                events.extend(self._see_one(sighting, now, grounded))
        return tuple(events)

    def _see_one(self, sighting: Sighting, now: float, grounded: bool) -> tuple[Event, ...]:
        fault = fault_of(sighting, now, self._last_capture)
        if fault is not None:
            return self._complaints.refuse(fault, now)
        if self._repeats(sighting) and not grounded:
            return self._complaints.refuse(Refusal.FROZEN, now)
        if self._upright is None:
            self._begin(sighting, now)
            return ()
        pose, at = sighting.pose, sighting.captured_at
        z, noise = pose.position[2], self._position_noise
        plausible, without, taken = upright_seen(
            self._upright, z, pose.yaw, at, self._refusing, noise
        )
        if self._believes(sighting, now, self._refusing) and plausible:
            self._upright = taken
            self._take(sighting, now)
            self._settled(sighting)
            return ()
        self._upright = without
        self._refusing = True
        return self._refuse_jump(sighting, now, grounded)

    def _repeats(self, sighting: Sighting) -> bool:
        """Return whether the place is the one before to the last bit: in the air only a system that
        repeats itself says so.
        """
        before, self._place = self._place, sighting.pose.position
        return self._place == before

    def _refuse_jump(self, sighting: Sighting, now: float, grounded: bool) -> tuple[Event, ...]:
        events = self._complaints.refuse(Refusal.JUMP, now)
        since = self._complaints.refused_since
        if not grounded or since is None or now - since < RESTART_AFTER:
            return events
        self._begin(sighting, now)
        return (
            Event(
                now,
                Severity.INFO,
                "tracking_restarted",
                "the drone was moved on the ground: tracking starts anew",
            ),
        )

    def _begin(self, sighting: Sighting, now: float) -> None:
        pose = sighting.pose
        self._upright = stood(
            pose.position[2], pose.yaw, sighting.captured_at, self._position_noise
        )
        self._settled(sighting)
        self._start(sighting, now)

    def _settled(self, sighting: Sighting) -> None:
        self._last_capture, self._refusing = sighting.captured_at, False
        self._believed = sighting
        self._complaints.believed()

    @abstractmethod
    def _start(self, sighting: Sighting, now: float) -> None:
        """Start the horizontal filter at this sighting."""

    @abstractmethod
    def _believes(self, sighting: Sighting, now: float, refusing: bool) -> bool:
        """Return whether the drone can be there.

        While sightings arrive and are being refused the doubt must not grow: else every jump would
            be believed in the end.
        """

    @abstractmethod
    def _take(self, sighting: Sighting, now: float) -> None:
        """Correct the horizontal filter."""
