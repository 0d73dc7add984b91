"""All detectors on one stream of sensor data."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import floor

from housefly.hub.situations.appliance import Appliances
from housefly.hub.situations.bed import Beds
from housefly.hub.situations.door import Doors
from housefly.hub.situations.entrance import Entrance
from housefly.hub.situations.fall import Falls
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.objects import Objects
from housefly.hub.situations.person import People
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.hub.situations.reorder_buffer import REORDER_DELAY, ReorderBuffer
from housefly.hub.situations.situation import SOURCE_PREFIX, Detector, DetectorInput, Situation
from housefly.messages import RoomEvent

_DETECTOR_PERIOD = 0.25
"""Detectors run at whole multiples of this time [s], however often ``update`` is called."""
_MAX_CATCH_UP = 900.0
"""After a longer pause detectors catch up over this time only [s]."""


class Situations:
    """Runs the detectors in order of time, ``REORDER_DELAY`` behind it.

    The same items give the same events, however they are split into calls and in whatever order
    they arrive within ``REORDER_DELAY``.

    Args:
        layout: what is known of the room in advance.
    """

    def __init__(self, layout: Layout) -> None:
        self._stream = ReorderBuffer()
        self._tracks, beds = PersonTracks(layout.people), Beds(layout.beds)
        entrance, objects = Entrance(self._tracks, layout), Objects(self._tracks, layout)
        self._detectors: tuple[Detector, ...] = (
            beds, Doors(layout.open_limits), Appliances(layout.devices),
            People(self._tracks, beds, layout), Falls(self._tracks, beds, layout),
            entrance, objects,
        )  # fmt: skip
        self._steps: int | None = None

    @property
    def counts(self) -> Mapping[tuple[str, str], int]:
        """Numbers of refused items by reason ("late", "from the future", ...) and source."""
        return dict(self._stream.counts)

    def update(self, items: Iterable[DetectorInput], now: float) -> tuple[RoomEvent, ...]:
        """Add the items since the last call and return the events.

        Args:
            items: in any order, or none.
            now: the time [s, Unix time]; one that runs backwards is ignored.
        """
        goal = floor((now - REORDER_DELAY) / _DETECTOR_PERIOD)
        if self._steps is None:
            self._steps = goal - 1
        for item in items:
            if not item.source.startswith(SOURCE_PREFIX):  # they may come back over the bus
                self._stream.add(item, self._steps * _DETECTOR_PERIOD, now)
        begin = max(self._steps, goal - round(_MAX_CATCH_UP / _DETECTOR_PERIOD))
        events = [
            event
            for number in range(begin + 1, goal + 1)
            for event in self._step(number * _DETECTOR_PERIOD)
        ]
        self._steps = max(self._steps, goal)
        return tuple(events)

    def active(self) -> tuple[Situation, ...]:
        """Return what holds now, sorted by kind and thing."""
        claims = (claim for detector in self._detectors for claim in detector.active())
        return tuple(sorted(claims, key=lambda claim: (claim.kind, claim.thing)))

    def _step(self, now: float) -> list[RoomEvent]:
        for item in self._stream.until(now):
            self._tracks.add(item)
            for detector in self._detectors:
                detector.add(item)
        return [event for detector in self._detectors for event in detector.update(now)]
