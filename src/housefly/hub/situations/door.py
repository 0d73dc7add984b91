"""Detects a door that stands open too long: of a room, a cabinet or a refrigerator."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from housefly.hub.situations.confidence import freshness
from housefly.hub.situations.hysteresis import Hysteresis, claimed_by
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.situation import (
    SOURCE_PREFIX,
    Assessment,
    DetectorInput,
    Evidence,
    Situation,
    fact,
    flag,
    is_refused,
)
from housefly.messages import Observation, RoomEvent

_SOURCE = SOURCE_PREFIX + "doors"
OPEN_TOO_LONG = 60.0
"""How long a door may stand open unless the layout says otherwise [s]."""
DOOR_HEARTBEAT = 60.0
"""Longest time between two messages of a contact [s]."""
_CONTACT_CONFIDENCE = 0.95
"""Confidence in a contact that reports."""
_BOUNCE = 0.5
"""A door that opens again sooner than this was never closed [s]: contacts bounce."""
_DWELL = {SituationKind.DOOR_OPEN_LONG: 0.0, None: _BOUNCE}
"""How long a door must be open too long, or closed, before it counts [s]."""
_DOOR_EVENTS = {"door opened": True, "door closed": False}


@dataclass(slots=True)
class _Door:
    """One contact: its state, since when, and since when the state before [s, Unix time]."""

    hysteresis: Hysteresis
    open: bool
    since: float
    heard: float
    before: float = float("-inf")

    def turn(self, is_open: bool, at: float) -> None:
        self.heard = at
        if is_open == self.open:
            return
        bounced = is_open and at - self.since < _BOUNCE and self.before > float("-inf")
        self.before, self.since = self.since, self.before if bounced else at
        self.open = is_open


class Doors:
    """Detects which doors stand open too long.

    Args:
        limits: how long each may stand open, by id [s].
    """

    def __init__(self, limits: Mapping[str, float]) -> None:
        self._limits = limits
        self._doors: dict[str, _Door] = {}

    def add(self, item: DetectorInput) -> None:
        """Add what a device reports about its own door."""
        is_open = _DOOR_EVENTS.get(item.kind) if isinstance(item, RoomEvent) else flag(item, "open")
        if is_open is None and is_refused(item) and item.source in self._doors:
            self._doors[item.source].heard = float("-inf")
        if (
            is_open is None
            or fact(item, "kind") == "contact"  # a window may stand open all day
            or item.thing != item.source
            or (isinstance(item, Observation) and not item.valid)
        ):
            return
        at = item.captured_at if isinstance(item, Observation) else item.at
        door = self._doors.setdefault(
            item.source, _Door(Hysteresis(item.source, _SOURCE, _DWELL), is_open, at, at)
        )
        door.turn(is_open, at)

    def update(self, now: float) -> tuple[RoomEvent, ...]:
        """Return the doors that became open too long, or were closed, up to a time [s]."""
        rows = sorted(self._doors.items())
        return tuple(
            event
            for name, door in rows
            for event in door.hysteresis.update(now, self._assess(name, door, now))
        )

    def active(self) -> tuple[Situation, ...]:
        """Return the doors that stand open too long."""
        return claimed_by(door.hysteresis for _, door in sorted(self._doors.items()))

    def _assess(self, name: str, door: _Door, now: float) -> Assessment | None:
        confidence = _CONTACT_CONFIDENCE * freshness(now - door.heard, DOOR_HEARTBEAT)
        if confidence == 0.0:
            return None
        limit = self._limits.get(name, OPEN_TOO_LONG)
        if not door.open or now - door.since <= limit:
            return Assessment(
                None,
                confidence,
                door.since,
                (Evidence("open, not for long" if door.open else "closed", name),),
            )
        facts = (("open_since", door.since), ("open_for", now - door.since), ("limit", limit))
        return Assessment(
            SituationKind.DOOR_OPEN_LONG,
            confidence,
            door.since + limit,
            (Evidence(f"open for more than {limit:g} s", name),),
            facts,
        )
