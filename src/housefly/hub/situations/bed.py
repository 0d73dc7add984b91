"""A bed is occupied: load cells, with hysteresis in load and time."""

from __future__ import annotations

from collections.abc import Collection

from housefly.hub.situations.latch import Latch
from housefly.hub.situations.situation import OURS, Finding, Item, Situation, flag, number
from housefly.hub.situations.trust import trust
from housefly.messages import Happening, Observation

OCCUPIED = "bed occupied"
SOURCE = OURS + "beds"
LOAD_ON = 20.0
"""From this load on somebody lies there [kg]."""
LOAD_OFF = 10.0
"""Below this load nobody does [kg]; in between it stays as it was."""
HEARTBEAT = 30.0
"""A bed speaks at least this often [s]."""
BELIEF = 0.95
"""Confidence in load cells that speak."""
DWELL = {OCCUPIED: 1.5, "": 3.0}
"""So long a bed must be loaded, or free, before it counts [s]: a suitcase thrown on it, somebody
turning over.
"""


class Beds:
    """Watches all beds that say their load.

    Args:
        beds: ids of the bed sensors.
    """

    def __init__(self, beds: Collection[str]) -> None:
        self._beds = {bed: _Bed(bed) for bed in sorted(beds)}

    def take(self, item: Item) -> None:
        """Take what a bed says of itself."""
        if (
            isinstance(item, Observation)
            and item.valid
            and item.thing == item.source
            and item.source in self._beds
        ):
            self._beds[item.source].take(item)

    def after(self, now: float) -> tuple[Happening, ...]:
        """Return which beds came to be occupied or free up to a time [s]."""
        return tuple(
            happening
            for bed in self._beds.values()
            for happening in bed.latch.step(now, bed.finding(now))
        )

    def holds(self) -> tuple[Situation, ...]:
        """Return the occupied beds."""
        return tuple(
            bed.latch.situation for bed in self._beds.values() if bed.latch.situation is not None
        )

    def occupied(self, bed: str, now: float) -> bool | None:
        """Return whether a bed feels somebody at a time [s], however shortly; None when it does not
        say.
        """
        known = self._beds.get(bed)
        found = known.finding(now) if known else None
        return found.kind == OCCUPIED if found else None

    def situation(self, bed: str) -> Situation | None:
        """Return the claim that a bed is occupied, if it is made."""
        return self._beds[bed].latch.situation if bed in self._beds else None


class _Bed:
    def __init__(self, bed: str) -> None:
        self.latch = Latch(bed, SOURCE, DWELL)
        self._bed, self._load, self._loaded, self._since = bed, 0.0, False, 0.0
        self._heard: float | None = None

    def take(self, said: Observation) -> None:
        load = number(said, "load")
        loaded = _loaded(load, self._loaded) if load is not None else flag(said, "occupied")
        if loaded is None:
            return
        if self._heard is None or loaded != self._loaded:
            self._since = said.captured_at
        self._heard, self._loaded, self._load = said.captured_at, loaded, load or 0.0

    def finding(self, now: float) -> Finding | None:
        believed = BELIEF * trust(now - self._heard, HEARTBEAT) if self._heard is not None else 0.0
        if believed == 0.0:
            return None
        words = f"{self._bed}: load {self._load:.1f} kg"
        return Finding(
            OCCUPIED if self._loaded else "",
            believed,
            self._since,
            (words,),
            (("load", self._load),),
        )


def _loaded(load: float, before: bool) -> bool:
    """Return whether a load is somebody's [kg], given whether it was."""
    return load >= (LOAD_OFF if before else LOAD_ON)
