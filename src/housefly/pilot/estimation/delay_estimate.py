"""How long after a command the drone reacts, found while it flies, compiled.

The prediction depends on the command delay tau; its sensitivity psi = d(x, v, a, d)/d tau obeys the
same dynamics, driven by the changes of the command, and the Kalman gain shrinks it like the state.
One Gauss-Newton step a sighting then minimizes the sum of the squared innovations over their
variance, as large as they are seen to be (recursive prediction error method). What is found is the
delay by the stamps of tracking: a camera that stamps late by e shows as e more. Derivation:
``docs/flight.md``.
"""

from __future__ import annotations

from math import isfinite, sqrt
from typing import NamedTuple

from housefly.numeric import clipped, compiled
from housefly.pilot.estimation.delay_filter import (
    AxesAt,
    CommandHistory,
    DelayFilterState,
    span_transition,
)
from housefly.pilot.estimation.lagged_axis import (
    AxisCovariance,
    AxisModel,
    AxisState,
    predicted_axis,
)

DELAY_MEMORY = 20.0
"""What was learned of the delay is forgotten within this [s]."""
DELAY_CHANGE_MAX = 0.15
"""The delay is believed to be no farther than this from what the site says [s]."""
DELAY_STEP_MAX = 0.001
"""No more than this is learned from one sighting [s]; less than a command lasts."""
NIS_MIN = 0.02
"""Innovations are believed to be no smaller than this, over what the filter expects."""


class DelayEstimate(NamedTuple):
    """What is known of the command delay.

    Attributes:
        delay: [s].
        information: inverse of its variance [1/s^2].
        x, y: sensitivity of both axes to it at the last sighting, per second of delay.
    """

    delay: float
    information: float
    x: AxisState
    y: AxisState


UNMOVED = AxisState(0.0, 0.0, 0.0, 0.0)
"""Sensitivity of a drone that no command has moved."""


@compiled
def delay_known(delay: float, deviation: float) -> DelayEstimate:
    """Return the knowledge beforehand: a delay and its one-sigma error [s]; 0 knows it."""
    information = 1.0 / (deviation * deviation) if deviation > 0.0 else 0.0
    return DelayEstimate(delay, information, UNMOVED, UNMOVED)


@compiled
def delay_deviation(e: DelayEstimate) -> float:
    """Return the one-sigma error of the delay [s]; 0 where it is taken as known."""
    return 1.0 / sqrt(e.information) if e.information > 0.0 else 0.0


@compiled
def sensitivity_at(
    e: DelayEstimate, h: DelayFilterState, spans: CommandHistory, model: AxisModel, there: AxesAt
) -> tuple[AxisState, AxisState]:
    """Return the sensitivity of both axes where the state was carried to, for a sighting that is
    not taken in yet.
    """
    x, y, ring = e.x, e.y, spans.size - 1
    for span in range(h.span, there.span):
        row, following = spans[span & ring], spans[(span + 1) & ring]
        step = span_transition(row)
        for _ in range(row.pieces):
            x, y = predicted_axis(x, 0.0, step), predicted_axis(y, 0.0, step)
        kick = -model.lag * model.gain
        if row.flown > 0 and following.flown > 0:
            x = AxisState(x.x, x.v, x.a + kick * (following.ux - row.ux), x.d)
            y = AxisState(y.x, y.v, y.a + kick * (following.uy - row.uy), y.d)
        else:
            x, y = UNMOVED, UNMOVED
    for _ in range(there.pieces):
        x, y = predicted_axis(x, 0.0, there.step), predicted_axis(y, 0.0, there.step)
    return x, y


@compiled
def delay_learned(
    e: DelayEstimate,
    x: AxisState,
    y: AxisState,
    p: AxisCovariance,
    dx: float,
    dy: float,
    variance: float,
    nis: float,
    dt: float,
    nominal: float,
    deviation: float,
) -> DelayEstimate:
    """Return the knowledge after a sighting.

    Args:
        e: before.
        x: sensitivity of x at the sighting.
        y: of y.
        p: covariance there.
        dx: innovation along x [m].
        dy: along y [m].
        variance: of the sighting [m^2].
        nis: normalized innovation squared of late: how large innovations are, over what the
            filter expects; not a number where unknown.
        dt: since the sighting before [s].
        nominal: delay of the site [s].
        deviation: its one-sigma error [s].
    """
    total, first = p.xx + variance, 1.0 / (deviation * deviation)
    seen = total * max(nis, NIS_MIN) if isfinite(nis) else total
    kept = max(1.0 - dt / DELAY_MEMORY, 0.0) * (e.information - first)
    information = first + kept + (x.x * x.x + y.x * y.x) / seen
    change = clipped((x.x * dx + y.x * dy) / (seen * information), DELAY_STEP_MAX)
    low, high = max(0.0, nominal - DELAY_CHANGE_MAX), nominal + DELAY_CHANGE_MAX
    delay = min(max(e.delay + change, low), high)
    return DelayEstimate(delay, information, _corrected(x, p, total), _corrected(y, p, total))


@compiled
def _corrected(s: AxisState, p: AxisCovariance, total: float) -> AxisState:
    """Return a sensitivity after the Kalman gain has worked on the state: (I - K C) s."""
    share = s.x / total
    return AxisState(s.x - p.xx * share, s.v - p.xv * share, s.a - p.xa * share, s.d - p.xd * share)
