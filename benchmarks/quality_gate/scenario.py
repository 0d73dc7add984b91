"""What a row of the gate flies, and what turns it red."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from housefly.geometry import Vec2
from housefly.twin.disturbance import NEUTRAL, Disturbances
from quality_gate.rooms import GateRoom


class FlightKind(Enum):
    """What is flown."""

    ERRANDS = "errands"
    SERVICE = "service"
    EIGHT = "figure eight"
    LANDING = "landing"


class Way(Enum):
    """How the pilot of a row finds and flies its ways; a tree may not offer all."""

    GRID = "grid"
    SPACE = "space"
    PAPER = "paper"


WAY_CHANGES: dict[Way, dict[str, Any]] = {
    Way.GRID: {"map__planner": "grid"},
    Way.SPACE: {},
    Way.PAPER: {"mode": "paper"},
}
BOTH = (Way.GRID, Way.SPACE)
ALL = (Way.GRID, Way.SPACE, Way.PAPER)


@dataclass(frozen=True, slots=True)
class Limit:
    """What a measure of a row must keep.

    Attributes:
        measure: name of a field of ``RowMeasures``.
        most, least: bounds, SI units; None for none.
        ways: for whom it counts.
        source: where it comes from.
    """

    measure: str
    most: float | None = None
    least: float | None = None
    ways: tuple[Way, ...] = (Way.SPACE,)
    source: str = "goal"

    def holds(self, value: float) -> bool:
        """Return whether a value keeps the limit; what is not a number does not."""
        above = self.least is None or value >= self.least
        return above and (self.most is None or value <= self.most)


@dataclass(frozen=True, slots=True)
class Scenario:
    """One row.

    Attributes:
        name: of the row, for ``--rows``.
        title: in words.
        kind: what is flown.
        room: where.
        goals: of the errands [m]; those of a service are its place.
        changes: of the site's keys, for the world and the pilot.
        pilot_changes: keys of which only the pilot knows: what it believes wrongly.
        weather: what disturbs the drone from the hover on.
        gap_every, gap: tracking is lost so often, for so long [s].
        rooms: so many numbered rooms are flown, one after the other.
        winds: one flight for each: wind in the plane [m/s].
        limits: what turns it red.
        ways: who flies it.
        quick: part of ``--quick``.
        quick_goals: so many errands of it then.
    """

    name: str
    title: str
    kind: FlightKind
    room: GateRoom = GateRoom.BSEN
    goals: tuple[Vec2, ...] = ()
    changes: dict[str, Any] = field(default_factory=dict)
    pilot_changes: dict[str, Any] = field(default_factory=dict)
    weather: Disturbances = NEUTRAL
    gap_every: float = 0.0
    gap: float = 0.0
    rooms: int = 1
    winds: tuple[Vec2, ...] = ()
    limits: tuple[Limit, ...] = ()
    ways: tuple[Way, ...] = BOTH
    quick: bool = False
    quick_goals: int = 6
