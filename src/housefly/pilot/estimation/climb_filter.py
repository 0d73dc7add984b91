"""The vertical filter between sightings: carried through the commands given since the last one."""

from __future__ import annotations

from typing import NamedTuple

from housefly.numeric import compiled
from housefly.pilot.estimation.climb_axis import (
    ClimbAxis,
    ClimbCovariance,
    ClimbModel,
    ClimbStep,
    climb_answer,
    climb_step,
    first_climb_covariance,
    predicted_climb,
    predicted_climb_covariance,
    updated_climb,
    updated_climb_covariance,
)
from housefly.pilot.estimation.delay_filter import (
    PREDICTION_STEP_MAX,
    SPAN_TOLERANCE,
    TIME_TOLERANCE,
    CommandHistory,
    DelayFilterState,
)
from housefly.pilot.estimation.height_yaw import EXTRAPOLATION_MAX


class ClimbState(NamedTuple):
    """Where the vertical filter stands.

    Attributes:
        axis, covariance: at the last sighting.
        at: when that was captured [s].
        step, length: of a whole tick [s] under our command, which most spans are; negative
            before it is known.
    """

    axis: ClimbAxis
    covariance: ClimbCovariance
    at: float
    step: ClimbStep
    length: float


NO_STEP = ClimbStep(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""Stands where the length of a tick is not known yet."""


@compiled
def climb_initialized(z: float, at: float, variance: float, lift: float = 0.0) -> ClimbState:
    """Return the state of a drone seen at rest at a height [m] and time [s], and its lift."""
    axis, covariance = ClimbAxis(z, 0.0, lift), first_climb_covariance(variance)
    return ClimbState(axis, covariance, at, NO_STEP, -1.0)


@compiled
def climb_tick_known(
    u: ClimbState, h: DelayFilterState, spans: CommandHistory, model: ClimbModel
) -> ClimbState:
    """Return the state with the step of a tick as long as the one that has just ended."""
    length = spans[(h.newest - 1) & (spans.size - 1)].seconds
    if h.newest <= h.span or abs(length - u.length) <= SPAN_TOLERANCE:
        return u
    return ClimbState(u.axis, u.covariance, u.at, climb_step(model, True, length), length)


@compiled
def climb_at(
    u: ClimbState,
    h: DelayFilterState,
    spans: CommandHistory,
    model: ClimbModel,
    delay: float,
    at: float,
) -> ClimbAxis:
    """Return the vertical axis at a time [s], carried on no further than height and yaw are."""
    return climb_carried(u, h, spans, model, delay, u.axis, u.at, at)


@compiled
def climb_carried(
    u: ClimbState,
    h: DelayFilterState,
    spans: CommandHistory,
    model: ClimbModel,
    delay: float,
    axis: ClimbAxis,
    then: float,
    at: float,
) -> ClimbAxis:
    """Return the vertical axis at a time [s] from what it is at an earlier one.

    Args:
        u: the state.
        h: of the delay filter.
        spans: the commands given.
        model: of the drone.
        delay: from command to first reaction [s].
        axis: what is known.
        then: when it is that [s], not before the last sighting.
        at: the time [s].
    """
    end = min(at, u.at + delay + EXTRAPOLATION_MAX)
    span, ring = h.span, spans.size - 1
    while then < end - TIME_TOLERANCE:
        row = spans[span & ring]
        until = end
        if span < h.newest:
            until = min(end, spans[(span + 1) & ring].sent + delay)
        dt = until - then
        if dt > TIME_TOLERANCE:
            step = _step_of(u, model, row.flown > 0, dt)
            axis = predicted_climb(axis, climb_answer(model, row.uz), step)
            then = until
        span += 1
    return axis


@compiled
def climb_and_covariance_at(
    u: ClimbState,
    h: DelayFilterState,
    spans: CommandHistory,
    model: ClimbModel,
    delay: float,
    at: float,
) -> tuple[ClimbAxis, ClimbCovariance]:
    """Return the vertical axis and its covariance at the time of a sighting [s]."""
    axis, p, then = u.axis, u.covariance, u.at
    span, ring = h.span, spans.size - 1
    while then < at - TIME_TOLERANCE:
        row = spans[span & ring]
        until = min(at, then + PREDICTION_STEP_MAX)
        if span < h.newest and spans[(span + 1) & ring].sent + delay <= until:
            until = max(then, spans[(span + 1) & ring].sent + delay)
            span += 1
        dt = until - then
        if dt > TIME_TOLERANCE:
            step = _step_of(u, model, row.flown > 0, dt)
            axis = predicted_climb(axis, climb_answer(model, row.uz), step)
            p = predicted_climb_covariance(p, step)
            then = until
    return axis, p


@compiled
def climb_updated(
    u: ClimbState, axis: ClimbAxis, p: ClimbCovariance, z: float, at: float, variance: float
) -> ClimbState:
    """Return the state after a height [m] of a variance [m^2] at a time [s]."""
    return ClimbState(
        updated_climb(axis, p, z, variance),
        updated_climb_covariance(p, variance),
        at,
        u.step,
        u.length,
    )


@compiled
def _step_of(u: ClimbState, model: ClimbModel, flown: bool, dt: float) -> ClimbStep:
    if flown and abs(dt - u.length) <= SPAN_TOLERANCE:
        return u.step
    return climb_step(model, flown, dt)
