"""All detectors over one stream: what the room knows, from what its sensors tell."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import floor

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.door import Doors
from housefly.hub.situations.entrance import Entrance
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.objects import Objects
from housefly.hub.situations.person import People
from housefly.hub.situations.situation import OURS, Detector, Item, Situation
from housefly.hub.situations.stream import PATIENCE, Stream
from housefly.hub.situations.tracks import Tracks
from housefly.messages import Happening

STEP = 0.25
"""Detectors look at the room at whole multiples of this time [s], so that nothing depends on how
often they are called.
"""
LONGEST_GAP = 900.0
"""After a longer pause [s] they start this long before its end: everything but doors and missing
things is forgotten by then.
"""


class Situations:
    """Runs the detectors in order of time, ``PATIENCE`` behind it.

    The same items give the same happenings, however they are cut into calls and in whatever order
    they come within ``PATIENCE``.

    Args:
        layout: what is known of the room beforehand.
    """

    def __init__(self, layout: Layout) -> None:
        self._stream = Stream()
        self._tracks, beds = Tracks(layout.people), Beds(layout.beds)
        entrance, objects = Entrance(self._tracks, layout), Objects(self._tracks, layout)
        self._detectors: tuple[Detector, ...] = (
            beds, Doors(layout.open_limits), People(self._tracks, beds, layout), entrance, objects,
        )  # fmt: skip
        self._steps: int | None = None

    @property
    def counts(self) -> Mapping[tuple[str, str], int]:
        """What was not taken, by reason and source: late, doubled, from the future, not a number,
        too many.
        """
        return dict(self._stream.counts)

    def after(self, items: Iterable[Item], now: float) -> tuple[Happening, ...]:
        """Take what was told since the last call and return what happened.

        Args:
            items: in any order, or none.
            now: the time [s, Unix time]; a time that runs backwards is no time.
        """
        goal = floor((now - PATIENCE) / STEP)
        if self._steps is None:
            self._steps = goal - 1
        for item in items:
            if not item.source.startswith(OURS):  # they may come back over the bus
                self._stream.add(item, self._steps * STEP, now)
        begin = max(self._steps, goal - round(LONGEST_GAP / STEP))
        told = [
            happening
            for number in range(begin + 1, goal + 1)
            for happening in self._step(number * STEP)
        ]
        self._steps = max(self._steps, goal)
        return tuple(told)

    def holds(self) -> tuple[Situation, ...]:
        """Return what holds now, in order of kind and thing."""
        claims = (claim for detector in self._detectors for claim in detector.holds())
        return tuple(sorted(claims, key=lambda claim: (claim.kind, claim.thing)))

    def _step(self, now: float) -> list[Happening]:
        for item in self._stream.until(now):
            self._tracks.take(item)
            for detector in self._detectors:
                detector.take(item)
        return [happening for detector in self._detectors for happening in detector.after(now)]
