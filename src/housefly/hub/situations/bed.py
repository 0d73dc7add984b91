"""Detects an occupied bed from its load cells, with hysteresis in load and time."""

from __future__ import annotations

from collections.abc import Collection

from housefly.hub.situations.confidence import freshness
from housefly.hub.situations.hysteresis import Hysteresis, claimed_by
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.situation import (
    SOURCE_PREFIX,
    Assessment,
    DetectorInput,
    Evidence,
    Situation,
    flag,
    is_refused,
    number,
)
from housefly.messages import Observation, RoomEvent

_SOURCE = SOURCE_PREFIX + "beds"
LOAD_ON = 20.0
"""A load above this is a person [kg]."""
LOAD_OFF = 10.0
"""A load below this is nobody [kg]; in between the state stays as it was."""
BED_HEARTBEAT = 30.0
"""Longest time between two messages of a bed [s]."""
_LOAD_CONFIDENCE = 0.95
"""Confidence in load cells that report."""
_DWELL = {SituationKind.BED_OCCUPIED: 1.5, None: 3.0}
"""How long a bed must be loaded or free [s]: ignores thrown bags and people who turn over."""


class Beds:
    """Detects which beds are occupied.

    Args:
        beds: ids of the bed sensors.
    """

    def __init__(self, beds: Collection[str]) -> None:
        self._beds = {bed: _Bed(bed) for bed in sorted(beds)}

    def add(self, item: DetectorInput) -> None:
        """Add what a bed reports about itself."""
        if (
            isinstance(item, Observation)
            and item.thing == item.source
            and item.source in self._beds
            and (item.valid or is_refused(item))
        ):
            self._beds[item.source].add(item)

    def update(self, now: float) -> tuple[RoomEvent, ...]:
        """Return the beds that became occupied or free up to a time [s]."""
        return tuple(
            event
            for bed in self._beds.values()
            for event in bed.hysteresis.update(now, bed.assess(now))
        )

    def active(self) -> tuple[Situation, ...]:
        """Return the occupied beds."""
        return claimed_by(bed.hysteresis for bed in self._beds.values())

    def occupied(self, bed: str, now: float) -> bool | None:
        """Return whether a bed is loaded at a time [s], without hysteresis; None if unknown."""
        known = self._beds.get(bed)
        found = known.assess(now) if known else None
        return found.kind == SituationKind.BED_OCCUPIED if found else None

    def situation(self, bed: str) -> Situation | None:
        """Return the situation that a bed is occupied, None if it is not."""
        return self._beds[bed].hysteresis.situation if bed in self._beds else None


class _Bed:
    def __init__(self, bed: str) -> None:
        self.hysteresis = Hysteresis(bed, _SOURCE, _DWELL)
        self._bed, self._load, self._loaded, self._since = bed, 0.0, False, 0.0
        self._heard: float | None = None

    def add(self, sample: Observation) -> None:
        load = number(sample, "load")
        loaded = _loaded(load, self._loaded) if load is not None else flag(sample, "occupied")
        if loaded is None:
            self._heard = None if is_refused(sample) else self._heard
            return
        if self._heard is None or loaded != self._loaded:
            self._since = sample.captured_at
        self._heard, self._loaded, self._load = sample.captured_at, loaded, load or 0.0

    def assess(self, now: float) -> Assessment | None:
        confidence = (
            _LOAD_CONFIDENCE * freshness(now - self._heard, BED_HEARTBEAT)
            if self._heard is not None
            else 0.0
        )
        if confidence == 0.0:
            return None
        return Assessment(
            SituationKind.BED_OCCUPIED if self._loaded else None,
            confidence,
            self._since,
            (Evidence(f"load {self._load:.1f} kg", self._bed),),
            (("load", self._load),),
        )


def _loaded(load: float, before: bool) -> bool:
    """Return whether the load is a person [kg], given whether it was before."""
    return load >= (LOAD_OFF if before else LOAD_ON)
