"""Where a drone is along one axis, how fast, and what pushes it steadily; pure.

Between two poses the model carries it on; each pose corrects all three by the gains of a critically
damped filter with three equal poles (Kalata 1984; Brookner, Tracking and Kalman Filtering Made
Easy, 1998, 1.3). What pushes steadily is what nobody asked for: a hover throttle that is not the
one that was believed, a draught, an attitude that is off.
"""

from __future__ import annotations

from math import exp, inf
from typing import NamedTuple

POLE = 5.0
"""How quickly a pose corrects [1/s]."""
POLE_TIMES_AGE = 0.35
"""A pose that is old corrects more slowly, or the loop swings: pole times age is no more."""
PUSH_MAX = 4.0
"""No steady push is larger [m/s^2]: more is no drone of this mass."""
_STEP_MAX, _GAP_MAX = 0.02, 0.5
_PERIOD_MIN, _PERIOD_MAX = 0.002, 0.2


class AxisState(NamedTuple):
    """One axis.

    Attributes:
        at: time of the state [s].
        place: [m].
        speed: [m/s].
        push: acceleration that nobody asked for [m/s^2].
        corrected_at: when the newest pose was captured [s].
    """

    at: float = -inf
    place: float = 0.0
    speed: float = 0.0
    push: float = 0.0
    corrected_at: float = -inf


UNSEEN = AxisState()
"""Before the first pose."""


def advanced(state: AxisState, now: float, acceleration: float, drag: float) -> AxisState:
    """Return the state carried on to now [s].

    Args:
        state: before.
        now: [s].
        acceleration: that was asked for meanwhile [m/s^2].
        drag: linear [1/s].
    """
    left = min(now - state.at, _GAP_MAX)
    if left <= 0.0:
        return state
    place, speed = state.place, state.speed
    while left > 0.0:
        dt = min(left, _STEP_MAX)
        place += dt * speed
        speed += dt * (acceleration + state.push - drag * speed)
        left -= dt
    return state._replace(at=now, place=place, speed=speed)


def corrected(state: AxisState, place: float, captured_at: float) -> AxisState:
    """Return the state once a pose has said where it was [m], at a time [s]; an older one is none.

    The first one, and one after a gap, is believed as it is; what pushes is kept.
    """
    if captured_at <= state.corrected_at:
        return state
    period = captured_at - state.corrected_at
    if period > _GAP_MAX:
        return AxisState(max(captured_at, state.at), place, 0.0, state.push, captured_at)
    period = min(max(period, _PERIOD_MIN), _PERIOD_MAX)
    age = max(0.0, state.at - captured_at)
    keep = exp(-min(POLE, POLE_TIMES_AGE / max(age, _PERIOD_MIN)) * period)
    off = place - (state.place - state.speed * age)
    push = state.push + (1.0 - keep) ** 3 / period**2 * off
    return AxisState(
        state.at,
        state.place + (1.0 - keep**3) * off,
        state.speed + 1.5 * (1.0 - keep) ** 2 * (1.0 + keep) / period * off,
        min(max(push, -PUSH_MAX), PUSH_MAX),
        captured_at,
    )
