"""A task in the queue as one total table: what each signal makes of each state.

    WAITING -> QUEUED -> RUNNING -> DONE | FAILED | CANCELLED ...
                 |          `-> SUSPENDED -> RUNNING        (pre-empted, later resumed)
                 `-> HELD   `-> PAUSED    -> RUNNING        (a person paused it)
                            `-> ENDING                      (cancelled, the drone comes home)

The table holds no conditions: the scheduler works them out and says them as signals.
"""

from __future__ import annotations

from enum import Enum

from housefly.tasks.api.values import TaskStage


class QueueState(Enum):
    """Where a task is, finer than its stage: whether it has a run, and whether that has the drone.

    A run is active in RUNNING, PAUSED and ENDING; it is kept, without the drone, in SUSPENDED,
    HELD_SUSPENDED and ASKED_AGAIN; else there is none.
    """

    WAITING = "waiting"
    ASKED_AGAIN = "asked_again"
    QUEUED = "queued"
    HELD = "held"
    RUNNING = "running"
    PAUSED = "paused"
    ENDING = "ending"
    SUSPENDED = "suspended"
    HELD_SUSPENDED = "held_suspended"
    DONE = "done"
    FAILED = "failed"
    CANCELLED = "cancelled"
    REFUSED = "refused"
    EXPIRED = "expired"


class TaskSignal(Enum):
    """What can happen to a task in the queue."""

    YES = "a person, or a second request that needs none, says yes"
    NO = "a person says no"
    CANCEL = "somebody cancels it"
    PAUSE = "somebody pauses it"
    CONTINUE = "somebody continues it"
    UNANSWERED = "nobody answered its question"
    DEADLINE = "it was not begun in time"
    STALE = "it would fly now, but the last yes is too old"
    TURN = "it may run now"
    MADE_WAY = "the queue is full and a more urgent task came"
    SET_ASIDE = "a more urgent task takes the drone; it goes on afterwards"
    START_OVER = "a more urgent task takes the drone; it begins anew afterwards"
    BROKEN_OFF = "a more urgent task takes the drone; it ends"
    RUN_DONE = "its run ended well"
    RUN_FAILED = "its run failed"
    RUN_CANCELLED = "its run was cancelled"
    RUN_REFUSED = "its run was refused"
    RUN_EXPIRED = "its run came too late"
    IMPOSSIBLE = "a rehearsal found that it cannot be flown"
    RESTARTED = "the program was started again, and the task flies"
    RESTARTED_BESIDE = "the program was started again, and the task does not fly"


_Q = QueueState
STAGES: dict[QueueState, TaskStage] = {
    _Q.WAITING: TaskStage.WAITING,
    _Q.ASKED_AGAIN: TaskStage.WAITING,
    _Q.QUEUED: TaskStage.QUEUED,
    _Q.HELD: TaskStage.PAUSED,
    _Q.RUNNING: TaskStage.RUNNING,
    _Q.PAUSED: TaskStage.PAUSED,
    _Q.ENDING: TaskStage.RUNNING,
    _Q.SUSPENDED: TaskStage.SUSPENDED,
    _Q.HELD_SUSPENDED: TaskStage.PAUSED,
    _Q.DONE: TaskStage.DONE,
    _Q.FAILED: TaskStage.FAILED,
    _Q.CANCELLED: TaskStage.CANCELLED,
    _Q.REFUSED: TaskStage.REFUSED,
    _Q.EXPIRED: TaskStage.EXPIRED,
}
"""The stage that people see."""
_ENDS = (_Q.DONE, _Q.FAILED, _Q.CANCELLED, _Q.REFUSED, _Q.EXPIRED)
_OPEN = tuple(state for state in QueueState if state not in _ENDS)
ACTIVE = frozenset({_Q.RUNNING, _Q.PAUSED, _Q.ENDING})
"""A run is stepped; a flying one has the drone."""
QUESTIONING = frozenset({_Q.WAITING, _Q.ASKED_AGAIN})
"""A person is asked."""
NOT_BEGUN = frozenset({_Q.WAITING, _Q.QUEUED, _Q.HELD})
"""There is no run yet, or none any more."""

_T = TaskSignal
_NO = None
_W, _A, _QU, _H, _R, _P, _E, _S, _HS = _OPEN
_DON, _FLD, _CAN, _REF, _EXP = _ENDS


def _order(*targets: QueueState | None) -> dict[QueueState, QueueState | None]:
    """Return the row of an order of a person: an ended task refuses it."""
    return dict(zip((*_OPEN, *_ENDS), (*targets, *(None for _ in _ENDS)), strict=True))


def _happens(*targets: QueueState) -> dict[QueueState, QueueState | None]:
    """Return the row of what happens by itself: an ended task stays as it is."""
    return dict(zip((*_OPEN, *_ENDS), (*targets, *_ENDS), strict=True))


# fmt: off
TRANSITIONS: dict[TaskSignal, dict[QueueState, QueueState | None]] = {
    #                              WAIT- ASKED QUEU- HELD  RUN-  PAU-  END-  SUS-  HELD_
    #                              ING   AGAIN ED          NING  SED   ING   PEND. SUSP.
    _T.YES:               _order(  _QU,  _S,   _NO,  _NO,  _NO,  _NO,  _NO,  _NO,  _NO),
    _T.NO:                _order(  _REF, _CAN, _NO,  _NO,  _NO,  _NO,  _NO,  _NO,  _NO),
    _T.CANCEL:            _order(  _CAN, _CAN, _CAN, _CAN, _E,   _E,   _E,   _CAN, _CAN),
    _T.PAUSE:             _order(  _NO,  _NO,  _H,   _H,   _P,   _P,   _NO,  _HS,  _HS),
    _T.CONTINUE:          _order(  _NO,  _NO,  _QU,  _QU,  _R,   _R,   _NO,  _S,   _S),
    _T.UNANSWERED:        _happens(_EXP, _EXP, _QU,  _H,   _R,   _P,   _E,   _S,   _HS),
    _T.DEADLINE:          _happens(_EXP, _A,   _EXP, _EXP, _R,   _P,   _E,   _S,   _HS),
    _T.STALE:             _happens(_W,   _A,   _W,   _H,   _R,   _P,   _E,   _A,   _HS),
    _T.TURN:              _happens(_W,   _A,   _R,   _H,   _R,   _P,   _E,   _R,   _HS),
    _T.MADE_WAY:          _happens(_REF, _A,   _REF, _REF, _R,   _P,   _E,   _S,   _HS),
    _T.SET_ASIDE:         _happens(_W,   _A,   _QU,  _H,   _S,   _HS,  _CAN, _S,   _HS),
    _T.START_OVER:        _happens(_W,   _A,   _QU,  _H,   _QU,  _H,   _CAN, _S,   _HS),
    _T.BROKEN_OFF:        _happens(_W,   _A,   _QU,  _H,   _CAN, _CAN, _CAN, _S,   _HS),
    _T.RUN_DONE:          _happens(_W,   _A,   _QU,  _H,   _DON, _DON, _DON, _S,   _HS),
    _T.RUN_FAILED:        _happens(_W,   _A,   _QU,  _H,   _FLD, _FLD, _FLD, _S,   _HS),
    _T.RUN_CANCELLED:     _happens(_W,   _A,   _QU,  _H,   _CAN, _CAN, _CAN, _S,   _HS),
    _T.RUN_REFUSED:       _happens(_W,   _A,   _QU,  _H,   _REF, _REF, _REF, _S,   _HS),
    _T.RUN_EXPIRED:       _happens(_W,   _A,   _QU,  _H,   _EXP, _EXP, _EXP, _S,   _HS),
    _T.IMPOSSIBLE:        _happens(_REF, _REF, _REF, _REF, _R,   _P,   _E,   _REF, _REF),
    _T.RESTARTED:         _happens(_W,   _FLD, _W,   _W,   _FLD, _FLD, _FLD, _FLD, _FLD),
    _T.RESTARTED_BESIDE:  _happens(_W,   _FLD, _QU,  _H,   _FLD, _FLD, _FLD, _FLD, _FLD),
}
# fmt: on
"""Where each signal leads from each state; None is refused, the same state changes nothing."""
