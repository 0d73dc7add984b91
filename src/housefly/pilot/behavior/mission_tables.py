"""The mission as two total tables: what an order does in each phase, and where a signal leads.

    IDLE -> TAKING_OFF -> OUTBOUND -> LOOKING -> RETURNING -> LANDING -> IDLE
                             `-> HOLDING (after GO, HOVER, STOP, TAKE_OFF) -> RETURNING

The tables hold no conditions: those are worked out beforehand, as signals and refusals.
"""

from __future__ import annotations

from enum import Enum

from housefly.messages.flight import OrderKind, Phase


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
    NUDGE = "move by hand"
    GOING_UP = "the drone is taking off already"
    NOT_FLYING = "the drone is on the ground"
    IN_THE_AIR = "the drone flies already"
    COMING_DOWN = "the drone is landing"
    ON_ITS_WAY = "the drone flies somewhere: press Hover first"


REFUSALS = frozenset(
    {
        Response.GOING_UP,
        Response.NOT_FLYING,
        Response.IN_THE_AIR,
        Response.COMING_DOWN,
        Response.ON_ITS_WAY,
    }
)
"""Responses that change nothing."""

_R = Response
_PHASES = tuple(Phase)
_UP, _AIR, _DOWN = Response.GOING_UP, Response.IN_THE_AIR, Response.COMING_DOWN
_NO, _DEP, _OFF = Response.NOT_FLYING, Response.DEPART, Response.ON_ITS_WAY


def _row(*responses: Response) -> dict[Phase, Response]:
    """Return one row in the order of ``Phase``; a single response counts for every phase."""
    row = responses * len(_PHASES) if len(responses) == 1 else responses
    return dict(zip(_PHASES, row, strict=True))


# fmt: off
ORDERS: dict[OrderKind, dict[Phase, Response]] = {
    #                        IDLE      TAKING_OFF OUTBOUND LOOKING  HOLDING  RETURNING LANDING
    OrderKind.TAKE_OFF: _row(_R.START, _UP,       _AIR,    _AIR,    _AIR,    _AIR,     _DOWN),
    OrderKind.HOVER:    _row(_NO,      _R.HOLD,   _R.HOLD, _R.HOLD, _R.HOLD, _R.HOLD,  _DOWN),
    OrderKind.GO:       _row(_R.START, _R.LATER,  _DEP,    _DEP,    _DEP,    _DEP,     _DOWN),
    OrderKind.SERVICE:  _row(_R.START, _R.LATER,  _DEP,    _DEP,    _DEP,    _DEP,     _DOWN),
    OrderKind.HOME:     _row(_NO,      _R.LATER,  _DEP,    _DEP,    _DEP,    _DEP,     _DOWN),
    OrderKind.LAND:     _row(_R.LAND),
    OrderKind.STOP:     _row(_R.STOP),
    OrderKind.RESUME:   _row(_R.RESUME),
    OrderKind.CUT:      _row(_R.CUT),
    OrderKind.RESET:    _row(_R.RESET),
    OrderKind.NUDGE:    _row(_NO,      _UP,       _OFF,    _OFF,    _R.NUDGE, _OFF,    _DOWN),
}
# fmt: on
"""What each order does in each phase."""


class Signal(Enum):
    """What can happen to a mission besides orders."""

    AIRBORNE = "the drone says it flies"
    FLIES_AFTER_CUT = "it says so after its motors were cut, and nobody ordered a flight since"
    SINKING = "the drone says it lands"
    GROUNDED = "the drone says it stands"
    EMERGENCY = "the drone cut its motors"
    ARRIVED_TO_STAY = "at the goal, nothing to look at"
    ARRIVED_TO_LOOK = "at the goal of a service"
    ARRIVED_HOME = "above the pad"
    LOOKED = "looked long enough"
    OVERDUE = "the phase takes too long"
    BLOCKED = "the way stays blocked"
    RETURN_WANTED = "the safety gate wants the drone to come home"
    FORCED_DOWN = "the safety gate lands the drone"


_I, _T, _O, _L, _H, _R_, _D = _PHASES
# fmt: off
SIGNALS: dict[Signal, dict[Phase, Phase]] = {
    signal: dict(zip(_PHASES, targets, strict=True))
    for signal, targets in {
        #                      IDLE TAKING_OFF OUTBOUND LOOKING HOLDING RETURNING LANDING
        Signal.AIRBORNE:        (_H, _H,        _O,      _L,     _H,     _R_,      _D),
        Signal.FLIES_AFTER_CUT: (_D, _D,        _D,      _D,     _D,     _D,       _D),
        Signal.SINKING:         (_I, _D,        _D,      _D,     _D,     _D,       _D),
        Signal.GROUNDED:        (_I, _T,        _I,      _I,     _I,     _I,       _I),
        Signal.EMERGENCY:       (_I, _I,        _I,      _I,     _I,     _I,       _I),
        Signal.ARRIVED_TO_STAY: (_I, _T,        _H,      _L,     _H,     _R_,      _D),
        Signal.ARRIVED_TO_LOOK: (_I, _T,        _L,      _L,     _H,     _R_,      _D),
        Signal.ARRIVED_HOME:    (_I, _T,        _O,      _L,     _H,     _D,       _D),
        Signal.LOOKED:          (_I, _T,        _O,      _R_,    _H,     _R_,      _D),
        Signal.OVERDUE:         (_I, _D,        _H,      _R_,    _R_,    _D,       _D),
        Signal.BLOCKED:         (_I, _T,        _R_,     _L,     _H,     _D,       _D),
        Signal.RETURN_WANTED:   (_I, _D,        _R_,     _R_,    _R_,    _R_,      _D),
        Signal.FORCED_DOWN:     (_I, _D,        _D,      _D,     _D,     _D,       _D),
    }.items()
}
# fmt: on
"""Where each signal leads from each phase."""
