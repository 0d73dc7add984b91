"""The finite state acceptor of paper V-B as a total table: (state, conditions) -> next state.

The conditions are bits, so every input has exactly one row and the table can be checked, drawn and
compiled. The rows come from the paper's execution order (altitude, then yaw, then path), which
resolves the overlaps that the printed conditions leave; when no condition holds at all (an error
that equals its epsilon) no transition is taken.
"""

from __future__ import annotations

from enum import IntEnum, IntFlag
from math import radians
from typing import NamedTuple

import numpy as np

from housefly.messages.steering import Behavior
from housefly.numeric import compiled


class AcceptorState(IntEnum):
    """The states as compiled code knows them, in the order of ``messages.Behavior``."""

    HOVER = 0
    ALTITUDE_CONTROL = 1
    YAW_CONTROL = 2
    PATH_TRACKING = 3


class Tolerances(NamedTuple):
    """eps1 [m], eps2 [rad], eps3 [m], and the shortest stay in a state [s]."""

    height: float
    yaw: float
    position: float
    dwell: float


class Condition(IntFlag):
    """The transition conditions of the paper, and REST: nothing is to be tracked."""

    Q1 = 1
    Q2 = 2
    Q3 = 4
    Q4 = 8
    REST = 16


PAPER_TOLERANCES = Tolerances(height=0.2, yaw=radians(0.2), position=0.4, dwell=0.0)
"""As printed; eps2 stands there as 0.2 deg."""

REST = int(Condition.REST)

EXECUTION_ORDER: tuple[tuple[Condition, Behavior], ...] = (
    (Condition.REST, Behavior.HOVER),
    (Condition.Q1, Behavior.ALTITUDE_CONTROL),
    (Condition.Q2, Behavior.YAW_CONTROL),
    (Condition.Q3, Behavior.PATH_TRACKING),
    (Condition.Q4, Behavior.HOVER),
)
"""The first condition that holds decides."""

STATES = tuple(Behavior)


def _next_state(state: Behavior, conditions: int) -> Behavior:
    return next((target for condition, target in EXECUTION_ORDER if conditions & condition), state)


TABLE = np.array(
    [[STATES.index(_next_state(state, bits)) for bits in range(32)] for state in STATES],
    dtype=np.uint8,
)
"""Next state, by state and condition bits; indices into ``STATES``."""
TABLE.setflags(write=False)


@compiled
def printed_conditions(
    height_error: float, yaw_error: float, distance: float, eps1: float, eps2: float, eps3: float
) -> int:
    """Return q1..q4 as bits, as printed: strict comparisons, q4 on its own.

    Args:
        height_error: z - z_ref [m].
        yaw_error: wrapped psi - psi_ref [rad].
        distance: from the reference point in the plane [m].
        eps1: tolerance of height [m].
        eps2: tolerance of yaw [rad].
        eps3: tolerance of place [m].
    """
    q1 = abs(height_error) > eps1
    q2 = abs(yaw_error) > eps2 and abs(height_error) < eps1
    q3 = not q1 and not q2 and distance > eps3
    q4 = distance < eps3
    return 1 * q1 + 2 * q2 + 4 * q3 + 8 * q4


@compiled
def steady_conditions(
    state: int,
    height_error: float,
    yaw_error: float,
    distance: float,
    eps1: float,
    eps2: float,
    eps3: float,
) -> int:
    """Return q1..q4 as bits, mended: exactly one is set, with hysteresis of half the tolerance."""
    q1 = abs(height_error) > (0.5 * eps1 if state == AcceptorState.ALTITUDE_CONTROL else eps1)
    q2 = not q1 and abs(yaw_error) > (0.5 * eps2 if state == AcceptorState.YAW_CONTROL else eps2)
    q3 = (
        not q1
        and not q2
        and distance > (0.5 * eps3 if state == AcceptorState.PATH_TRACKING else eps3)
    )
    q4 = not q1 and not q2 and not q3
    return 1 * q1 + 2 * q2 + 4 * q3 + 8 * q4


@compiled
def next_state(state: int, since: float, conditions: int, now: float, dwell: float) -> int:
    """Return the next state; REST counts at once, the other conditions after ``dwell`` [s].

    Args:
        state: present one, an index into ``STATES``.
        since: when it was entered [s].
        conditions: bits.
        now: [s].
        dwell: shortest stay in a state [s].
    """
    if now - since < dwell and not conditions & REST:
        return state
    return int(TABLE[state, conditions])


class Acceptor(NamedTuple):
    """The acceptor in one state: an ``AcceptorState``, and when it was entered [s]."""

    state: int
    since: float


@compiled
def acceptor_advanced(acceptor: Acceptor, conditions: int, now: float, dwell: float) -> Acceptor:
    """Return the acceptor after one look at the conditions, as ``next_state`` has it."""
    state = next_state(acceptor.state, acceptor.since, conditions, now, dwell)
    return acceptor if state == acceptor.state else Acceptor(state, now)
