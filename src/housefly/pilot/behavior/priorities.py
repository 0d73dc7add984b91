"""Which monitors may change a mission, and which has the last word: one table.

Each row sees the mission as the rows above it would have it, and may propose another. So the last
row that proposes something decides.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.pilot.behavior.proposal import MissionChange


class Watch(Enum):
    """What the monitors of a mission watch."""

    LANDING = "the column below a landing"
    BLIND_LANDING = "the floor below a landing without tracking"
    COLLISION = "what stands in the way"
    OFF_COURSE = "a drone that was held, and rests off its course"
    PASSING = "who walks into the way"
    FASTER_WAY = "a faster way that has become free"
    SEPARATION = "who comes near"
    NUDGE = "a person's hand on the keys"


class Situation(Enum):
    """What silences a monitor."""

    MAKING_WAY = "it makes way for somebody"
    AWAITING_PASSAGE = "it waits on its trajectory for somebody to pass"


@dataclass(frozen=True, slots=True)
class Priority:
    """One row of the table.

    Attributes:
        watch: of which monitor.
        may: what it may propose.
        silenced_by: in which situations it proposes nothing.
    """

    watch: Watch
    may: tuple[MissionChange, ...]
    silenced_by: tuple[Situation, ...] = ()


_M, _S = MissionChange, Situation
PRIORITIES = (
    Priority(Watch.LANDING, (_M.DESCEND, _M.LAND_ELSEWHERE)),
    Priority(Watch.BLIND_LANDING, ()),
    Priority(Watch.COLLISION, (_M.HOLD, _M.GO_AROUND), (_S.MAKING_WAY, _S.AWAITING_PASSAGE)),
    Priority(Watch.OFF_COURSE, (_M.GO_AROUND,), (_S.MAKING_WAY, _S.AWAITING_PASSAGE)),
    Priority(Watch.PASSING, (_M.RETIME, _M.HOLD, _M.GO_ON, _M.GO_AROUND), (_S.MAKING_WAY,)),
    Priority(Watch.FASTER_WAY, (_M.GO_AROUND,), (_S.MAKING_WAY,)),
    Priority(Watch.SEPARATION, (_M.MAKE_WAY, _M.GO_BACK, _M.LAND)),
    Priority(Watch.NUDGE, (_M.MOVE,)),
)
"""All monitors, the mildest first; ``docs/safety.md`` shows the table. Orders come before, and what
happened (``mission_tables``) before the first row; the safety gate stands behind all of it.
"""
