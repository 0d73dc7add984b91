"""The errand as two total tables: what an order does in each phase, and where a signal leads from
each phase.

    IDLE -> TAKING_OFF -> OUTBOUND -> LOOKING -> RETURNING -> LANDING -> IDLE
                             `-> HOLDING (after GO, HOVER, STOP, TAKE_OFF)

The tables hold no conditions; conditions are worked out beforehand and become signals and refusals.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

from housefly.geometry import Vec2, Vec3, heading_to
from housefly.messages import OrderKind, Phase


class Response(Enum):
    """What an order leads to."""

    START = "take off, then do it"
    LATER = "do it once in the air"
    DEPART = "do it from here"
    HOLD = "stay here"
    LAND = "land here"
    STOP = "hover, and accept nothing that moves until RESUME"
    RESUME = "accept orders again"
    CUT = "cut the motors"
    RESET = "leave the emergency state"
    GOING_UP = "nothing: the drone is taking off already"
    NOT_FLYING = "refused: the drone is on the ground"
    IN_THE_AIR = "refused: the drone flies already"
    COMING_DOWN = "refused: the drone is landing"


REFUSALS = frozenset(
    {Response.GOING_UP, Response.NOT_FLYING, Response.IN_THE_AIR, Response.COMING_DOWN}
)
"""Responses that change nothing."""

_R = Response
_ALL = tuple(Phase)


def _row(*responses: Response) -> dict[Phase, Response]:
    """Return one row; a single response counts for every phase, else they stand in the order of
    ``Phase``.
    """
    return dict(
        zip(_ALL, responses * len(_ALL) if len(responses) == 1 else responses, strict=False)
    )


ORDERS: dict[OrderKind, dict[Phase, Response]] = {
    # IDLE           TAKING_OFF   OUTBOUND       LOOKING        HOLDING        RETURNING
    # LANDING
    OrderKind.TAKE_OFF: _row(
        _R.START,
        _R.GOING_UP,
        _R.IN_THE_AIR,
        _R.IN_THE_AIR,
        _R.IN_THE_AIR,
        _R.IN_THE_AIR,
        _R.COMING_DOWN,
    ),
    OrderKind.HOVER: _row(
        _R.NOT_FLYING, _R.HOLD, _R.HOLD, _R.HOLD, _R.HOLD, _R.HOLD, _R.COMING_DOWN
    ),
    OrderKind.GO: _row(
        _R.START, _R.LATER, _R.DEPART, _R.DEPART, _R.DEPART, _R.DEPART, _R.COMING_DOWN
    ),
    OrderKind.SERVICE: _row(
        _R.START, _R.LATER, _R.DEPART, _R.DEPART, _R.DEPART, _R.DEPART, _R.COMING_DOWN
    ),
    OrderKind.HOME: _row(
        _R.NOT_FLYING, _R.LATER, _R.DEPART, _R.DEPART, _R.DEPART, _R.DEPART, _R.COMING_DOWN
    ),
    OrderKind.LAND: _row(_R.LAND),
    OrderKind.STOP: _row(_R.STOP),
    OrderKind.RESUME: _row(_R.RESUME),
    OrderKind.CUT: _row(_R.CUT),
    OrderKind.RESET: _row(_R.RESET),
}
"""What each order does in each phase."""


class Signal(Enum):
    """What can happen to an errand besides orders."""

    AIRBORNE = "the drone says it flies"
    SINKING = "the drone says it lands"
    GROUNDED = "the drone says it stands"
    EMERGENCY = "the drone cut its motors"
    ARRIVED_TO_STAY = "at the goal, nothing to look at"
    ARRIVED_TO_LOOK = "at the goal of a service"
    ARRIVED_HOME = "above the pad"
    LOOKED = "looked long enough"
    OVERDUE = "the phase takes too long"
    BLOCKED = "the way stays blocked"
    FORCED_DOWN = "the safety gate lands the drone"


_IDLE, _UP, _OUT, _LOOK, _HOLD, _BACK, _DOWN = _ALL
SIGNALS: dict[Signal, dict[Phase, Phase]] = {
    signal: dict(zip(_ALL, targets, strict=True))
    for signal, targets in {
        #                        IDLE  TAKING_OFF OUTBOUND LOOKING HOLDING RETURNING LANDING
        Signal.AIRBORNE: (_HOLD, _HOLD, _OUT, _LOOK, _HOLD, _BACK, _DOWN),
        Signal.SINKING: (_IDLE, _DOWN, _DOWN, _DOWN, _DOWN, _DOWN, _DOWN),
        Signal.GROUNDED: (_IDLE, _UP, _IDLE, _IDLE, _IDLE, _IDLE, _IDLE),
        Signal.EMERGENCY: (_IDLE, _IDLE, _IDLE, _IDLE, _IDLE, _IDLE, _IDLE),
        Signal.ARRIVED_TO_STAY: (_IDLE, _UP, _HOLD, _LOOK, _HOLD, _BACK, _DOWN),
        Signal.ARRIVED_TO_LOOK: (_IDLE, _UP, _LOOK, _LOOK, _HOLD, _BACK, _DOWN),
        Signal.ARRIVED_HOME: (_IDLE, _UP, _OUT, _LOOK, _HOLD, _DOWN, _DOWN),
        Signal.LOOKED: (_IDLE, _UP, _OUT, _BACK, _HOLD, _BACK, _DOWN),
        Signal.OVERDUE: (_IDLE, _DOWN, _HOLD, _BACK, _HOLD, _DOWN, _DOWN),
        Signal.BLOCKED: (_IDLE, _UP, _BACK, _LOOK, _HOLD, _DOWN, _DOWN),
        Signal.FORCED_DOWN: (_IDLE, _DOWN, _DOWN, _DOWN, _DOWN, _DOWN, _DOWN),
    }.items()
}
"""Where each signal leads from each phase."""


@dataclass(frozen=True, slots=True)
class Mission:
    """What to do in the air.

    Attributes:
        kind: TAKE_OFF (stay), GO, SERVICE or HOME.
        name: the goal in words.
        goal: world xy [m], None to stay.
        look_at: world point [m] to face on arrival, or None.
        look_s: how long to look [s].
        yaw: heading on arrival when there is nothing to look at [rad]; None keeps the heading.
    """

    kind: OrderKind = OrderKind.TAKE_OFF
    name: str = ""
    goal: Vec2 | None = None
    look_at: Vec3 | None = None
    look_s: float = 0.0
    yaw: float | None = None

    def arrival_yaw(self, position: Vec2) -> float | None:
        """Return the heading [rad] to take at the end of the way, seen from a position [m]; None
        keeps the present one.
        """
        return self.yaw if self.look_at is None else heading_to(position, self.look_at[:2])


STAY = Mission()
"""Hover where the drone is."""


@dataclass(frozen=True, slots=True)
class Errand:
    """How far the drone has come with what it was asked.

    Attributes:
        phase: where the errand stands.
        since: when the phase began [s].
        mission: what is done, or will be once in the air.
        stopped: STOP is latched.
        cutting: the motors are to be cut; asked until the drone says so.
        resetting: the emergency state is to be left; asked until the drone says so.
        pressed_at: when cut or reset was ordered [s].
    """

    phase: Phase = Phase.IDLE
    since: float = 0.0
    mission: Mission = STAY
    stopped: bool = False
    cutting: bool = False
    resetting: bool = False
    pressed_at: float = 0.0

    def entering(self, phase: Phase, now: float, mission: Mission | None = None) -> Errand:
        """Return the errand in a phase that begins now."""
        return replace(
            self, phase=phase, since=now, mission=self.mission if mission is None else mission
        )

    def after(self, signal: Signal, now: float) -> Errand:
        """Return the errand after a signal; the same errand when nothing changes."""
        phase = SIGNALS[signal][self.phase]
        return self if phase is self.phase else self.entering(phase, now)

    def stopping(self, now: float, grounded: bool) -> Errand:
        """Return the errand with STOP latched: what was under way is given up, a landing goes on."""
        stopped = replace(self, stopped=True, mission=STAY)
        if self.phase is Phase.TAKING_OFF and grounded:
            return stopped.entering(Phase.IDLE, now)
        if self.phase in (Phase.OUTBOUND, Phase.LOOKING, Phase.RETURNING):
            return stopped.entering(Phase.HOLDING, now)
        return stopped

    def pressing(self, now: float, *, cut: bool) -> Errand:
        """Return the errand with the motors to be cut, or the emergency to be left."""
        return replace(self, cutting=cut, resetting=not cut, pressed_at=now)

    def released(self) -> Errand:
        """Return the errand with neither cut nor reset wanted."""
        return (
            replace(self, cutting=False, resetting=False)
            if self.cutting or self.resetting
            else self
        )
