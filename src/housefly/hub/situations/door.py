"""A door stands open too long: of a room, a cabinet or a refrigerator."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from housefly.hub.situations.latch import Latch
from housefly.hub.situations.situation import OURS, Finding, Item, Situation, flag
from housefly.hub.situations.trust import trust
from housefly.messages import Happening, Observation

TOO_LONG = "door open too long"
SOURCE = OURS + "doors"
OPEN_TOO_LONG = 60.0
"""A door may stand open for this long where the layout does not say otherwise [s]."""
HEARTBEAT = 60.0
"""A contact speaks at least this often [s]."""
BELIEF = 0.95
"""Confidence in a contact that speaks."""
BOUNCE = 0.5
"""A door that opens again sooner than this [s] was never closed: contacts bounce."""
DWELL = {TOO_LONG: 0.0, "": BOUNCE}
"""So long must a door be open too long, or closed, before it counts [s]."""
EVENTS = {"door opened": True, "door closed": False}


@dataclass(slots=True)
class _Door:
    """One contact: what it says, since when, and since when it said the opposite before [s, Unix
    time].
    """

    latch: Latch
    open: bool
    since: float
    heard: float
    before: float = float("-inf")

    def turn(self, is_open: bool, at: float) -> None:
        self.heard = at
        if is_open == self.open:
            return
        bounced = is_open and at - self.since < BOUNCE and self.before > float("-inf")
        self.before, self.since = self.since, self.before if bounced else at
        self.open = is_open


class Doors:
    """Watches everything that says whether it is open.

    Args:
        limits: how long each may stand open, by id [s].
    """

    def __init__(self, limits: Mapping[str, float]) -> None:
        self._limits = limits
        self._doors: dict[str, _Door] = {}

    def take(self, item: Item) -> None:
        """Take what a device says of its own door."""
        is_open = EVENTS.get(item.kind) if isinstance(item, Happening) else flag(item, "open")
        if (
            is_open is None
            or item.thing != item.source
            or (isinstance(item, Observation) and not item.valid)
        ):
            return
        at = item.captured_at if isinstance(item, Observation) else item.at
        door = self._doors.setdefault(
            item.source, _Door(Latch(item.source, SOURCE, DWELL), is_open, at, at)
        )
        door.turn(is_open, at)

    def after(self, now: float) -> tuple[Happening, ...]:
        """Return which doors came to stand open too long, or were closed, up to a time [s]."""
        rows = sorted(self._doors.items())
        return tuple(
            happening
            for name, door in rows
            for happening in door.latch.step(now, self._finding(name, door, now))
        )

    def holds(self) -> tuple[Situation, ...]:
        """Return the doors that stand open too long."""
        return tuple(
            door.latch.situation
            for _, door in sorted(self._doors.items())
            if door.latch.situation is not None
        )

    def _finding(self, name: str, door: _Door, now: float) -> Finding | None:
        believed = BELIEF * trust(now - door.heard, HEARTBEAT)
        if believed == 0.0:
            return None
        limit = self._limits.get(name, OPEN_TOO_LONG)
        if not door.open or now - door.since <= limit:
            return Finding(
                "",
                believed,
                door.since,
                (f"{name}: {'open, not for long' if door.open else 'closed'}",),
            )
        facts = (("open_since", door.since), ("open_for", now - door.since), ("limit", limit))
        return Finding(
            TOO_LONG,
            believed,
            door.since + limit,
            (f"{name}: open for more than {limit:g} s",),
            facts,
        )
