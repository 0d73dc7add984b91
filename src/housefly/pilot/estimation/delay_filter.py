"""Mode default's filter: the state at the last measurement, and the way from there to later.

A measurement tells where the drone *was*. The commands given since then, and those that it has not
yet felt, say how it goes on. The time between two looks at the clock is a *span*: one command, in
force one delay later. Every span keeps the state at its beginning, so a look at any later time
costs one step, and only a measurement makes the way anew.
"""

from __future__ import annotations

from math import ceil
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.numeric import compiled
from housefly.pilot.estimation.lagged_axis import (
    AxisCovariance,
    AxisModel,
    AxisState,
    Transition,
    predicted_axis,
    predicted_covariance,
    transition,
    updated_axis,
    updated_covariance,
)

PREDICTION_STEP_MAX = 0.02
"""Longest step of the prediction [s]; the midpoint rule is good to 1e-4 m there."""
TIME_TOLERANCE = 1e-9
"""Times nearer to each other than this are the same [s]: sums of ticks and delays differ in their
last bits.
"""
SPAN_TOLERANCE = 1e-12
"""Spans whose lengths differ by no more than this share one step [s]."""

COMMAND_SPAN = np.dtype(
    [
        ("sent", "f8"),
        ("seconds", "f8"),
        ("pieces", "i8"),
        ("flown", "i8"),
        ("ux", "f8"),
        ("uy", "f8"),
        ("uz", "f8"),
    ]
    + [(name, "f8") for name in Transition._fields]
    + [(f"{axis}_{name}", "f8") for axis in "xy" for name in AxisState._fields]
)
"""One span: when its command was sent, how long it lasts, the command (accelerations in the plane,
climb rate), one of its equal steps, the state where it begins.
"""
CommandHistory = NDArray[Any]
"""Ring of spans, its length a power of two."""


class DelayFilterState(NamedTuple):
    """Where the filter stands.

    Attributes:
        at: time of the last measurement taken in [s]; the span in which it lies is cut so that it
            begins there.
        span: number of that span.
        newest: number of the span that has not ended.
        covariance: covariance at ``at``; the state is kept with the span.
    """

    at: float
    span: int
    newest: int
    covariance: AxisCovariance


NO_WAY = Transition(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""Stands where a span is at its beginning."""


class AxesAt(NamedTuple):
    """The state carried to one time, and the span in which that lies.

    Attributes:
        span: its number.
        x, y: both axes.
        covariance: of each.
        pieces, step: the way into the span, in equal steps; none at its beginning.
    """

    span: int
    x: AxisState
    y: AxisState
    covariance: AxisCovariance
    pieces: int
    step: Transition


@compiled
def delay_filter_created(
    spans: CommandHistory, now: float, first: AxisCovariance
) -> DelayFilterState:
    """Return the beginning: nothing was seen, and nothing is commanded from now [s] on."""
    nowhere = AxisState(0.0, 0.0, 0.0, 0.0)
    row = spans[0]
    row.sent, row.flown, row.ux, row.uy, row.uz = now, 0, 0.0, 0.0, 0.0
    _set_axes(row, nowhere, nowhere)
    return DelayFilterState(at=now, span=0, newest=0, covariance=first)


@compiled
def delay_filter_initialized(
    h: DelayFilterState,
    spans: CommandHistory,
    model: AxisModel,
    delay: float,
    at: float,
    x: float,
    y: float,
    first: AxisCovariance,
) -> DelayFilterState:
    """Return the state of a drone first seen at rest at (x, y) [m] at a time [s]."""
    there = AxesAt(
        span_index(h, spans, delay, at),
        AxisState(x, 0.0, 0.0, 0.0),
        AxisState(y, 0.0, 0.0, 0.0),
        first,
        0,
        NO_WAY,
    )
    made = _span_split(h, spans, model, delay, at, there)
    _repropagate(made, spans)
    return made


@compiled
def command_recorded(
    h: DelayFilterState,
    spans: CommandHistory,
    ux: float,
    uy: float,
    flown: bool,
    uz: float = 0.0,
) -> None:
    """Put the newest span under a world acceleration [m/s^2] and a climb rate [m/s], or the
    drone's own hover.
    """
    row = spans[h.newest & (spans.size - 1)]
    row.flown = 1 if flown else 0
    row.ux = ux if flown else 0.0
    row.uy = uy if flown else 0.0
    row.uz = uz if flown else 0.0


@compiled
def delay_filter_advanced(
    h: DelayFilterState, spans: CommandHistory, model: AxisModel, delay: float, now: float
) -> DelayFilterState:
    """Return the state with the newest span ended now [s] and the next one begun."""
    ring = spans.size - 1
    row, following = spans[h.newest & ring], spans[(h.newest + 1) & ring]
    if now - row.sent <= TIME_TOLERANCE:
        return h
    if h.newest - h.span >= ring - 1:
        h = history_trimmed(h, spans, model, delay, spans[(h.span + 1) & ring].sent + delay)
    _end_span(row, spans[(h.newest - 1) & ring], model, now)
    following.sent, following.flown = now, row.flown
    following.ux, following.uy, following.uz = row.ux, row.uy, row.uz
    _propagate_span(row, following)
    return DelayFilterState(at=h.at, span=h.span, newest=h.newest + 1, covariance=h.covariance)


@compiled
def axes_at(
    h: DelayFilterState, spans: CommandHistory, model: AxisModel, delay: float, at: float
) -> tuple[AxisState, AxisState]:
    """Return both axes at a time [s] not before the last measurement."""
    row = spans[span_index(h, spans, delay, at) & (spans.size - 1)]
    x, y, seconds = _axis_x(row), _axis_y(row), at - row.sent - delay
    if seconds <= TIME_TOLERANCE:
        return x, y
    pieces = step_count(seconds)
    step = transition(model, row.flown > 0, seconds / pieces)
    for _ in range(pieces):
        x, y = predicted_axis(x, row.ux, step), predicted_axis(y, row.uy, step)
    return x, y


@compiled
def axes_and_covariance_at(
    h: DelayFilterState, spans: CommandHistory, model: AxisModel, delay: float, at: float
) -> AxesAt:
    """Return both axes and their covariance at a time [s] not before the last measurement."""
    ring = spans.size - 1
    p, span = h.covariance, h.span
    while span < h.newest and spans[(span + 1) & ring].sent + delay <= at + TIME_TOLERANCE:
        row = spans[span & ring]
        step = span_transition(row)
        for _ in range(row.pieces):
            p = predicted_covariance(p, step)
        span += 1
    row = spans[span & ring]
    x, y, seconds = _axis_x(row), _axis_y(row), at - row.sent - delay
    if seconds <= TIME_TOLERANCE:
        return AxesAt(span, x, y, p, 0, NO_WAY)
    pieces = step_count(seconds)
    step = transition(model, row.flown > 0, seconds / pieces)
    for _ in range(pieces):
        x, y, p = (
            predicted_axis(x, row.ux, step),
            predicted_axis(y, row.uy, step),
            predicted_covariance(p, step),
        )
    return AxesAt(span, x, y, p, pieces, step)


@compiled
def delay_filter_updated(
    h: DelayFilterState,
    spans: CommandHistory,
    model: AxisModel,
    delay: float,
    at: float,
    there: AxesAt,
    x: float,
    y: float,
    variance: float,
) -> DelayFilterState:
    """Return the state after a measurement (x, y) [m] of a variance [m^2] at a time [s].

    The delay may be another than that by which the state was carried here.
    """
    p = there.covariance
    known = AxesAt(
        span_index(h, spans, delay, at),
        updated_axis(there.x, p, x, variance),
        updated_axis(there.y, p, y, variance),
        updated_covariance(p, variance),
        0,
        NO_WAY,
    )
    made = _span_split(h, spans, model, delay, at, known)
    _repropagate(made, spans)
    return made


@compiled
def history_trimmed(
    h: DelayFilterState, spans: CommandHistory, model: AxisModel, delay: float, at: float
) -> DelayFilterState:
    """Return the state carried to a time [s] before which nothing can be measured any more."""
    if at <= h.at:
        return h
    return _span_split(
        h, spans, model, delay, at, axes_and_covariance_at(h, spans, model, delay, at)
    )


@compiled
def _span_split(
    h: DelayFilterState,
    spans: CommandHistory,
    model: AxisModel,
    delay: float,
    at: float,
    there: AxesAt,
) -> DelayFilterState:
    """Cut the span that was reached so that it begins at a time [s] with a known state."""
    ring = spans.size - 1
    row = spans[there.span & ring]
    row.sent = at - delay
    _set_axes(row, there.x, there.y)
    if there.span < h.newest:
        _end_span(row, row, model, spans[(there.span + 1) & ring].sent)
    return DelayFilterState(at=at, span=there.span, newest=h.newest, covariance=there.covariance)


@compiled
def _repropagate(h: DelayFilterState, spans: CommandHistory) -> None:
    """Carry the state from the measurement on to the beginning of every later span."""
    ring = spans.size - 1
    for span in range(h.span, h.newest):
        _propagate_span(spans[span & ring], spans[(span + 1) & ring])


@compiled
def _propagate_span(row: Any, following: Any) -> None:
    """Carry the state through a span that has ended to the beginning of the next."""
    x, y, step = _axis_x(row), _axis_y(row), span_transition(row)
    for _ in range(row.pieces):
        x, y = predicted_axis(x, row.ux, step), predicted_axis(y, row.uy, step)
    _set_axes(following, x, y)


@compiled
def _end_span(row: Any, like: Any, model: AxisModel, now: float) -> None:
    """End a span now [s] and give it its step; one that is as long as another takes that one's."""
    seconds = now - row.sent
    if (
        abs(seconds - like.seconds) <= SPAN_TOLERANCE
        and like.flown == row.flown
        and like.pieces > 0
    ):
        row.pieces = like.pieces
        _set_transition(row, span_transition(like))
    else:
        row.pieces = max(step_count(seconds), 1)
        _set_transition(row, transition(model, row.flown > 0, seconds / row.pieces))
    row.seconds = seconds


@compiled
def step_count(seconds: float) -> int:
    """Return in how many equal steps a time [s] is gone through."""
    return ceil(seconds / PREDICTION_STEP_MAX - TIME_TOLERANCE)


@compiled
def span_index(h: DelayFilterState, spans: CommandHistory, delay: float, at: float) -> int:
    """Return the number of the span whose command acts at a time [s]."""
    ring = spans.size - 1
    span = h.newest
    while span > h.span and spans[span & ring].sent + delay > at + TIME_TOLERANCE:
        span -= 1
    return span


@compiled
def _axis_x(row: Any) -> AxisState:
    return AxisState(row.x_x, row.x_v, row.x_a, row.x_d)


@compiled
def _axis_y(row: Any) -> AxisState:
    return AxisState(row.y_x, row.y_v, row.y_a, row.y_d)


@compiled
def _set_axes(row: Any, x: AxisState, y: AxisState) -> None:
    row.x_x, row.x_v, row.x_a, row.x_d = x
    row.y_x, row.y_v, row.y_a, row.y_d = y


@compiled
def span_transition(row: Any) -> Transition:
    """Return one of the equal steps of a span that has ended."""
    return Transition(
        row.xv,
        row.xa,
        row.xd,
        row.vv,
        row.va,
        row.vd,
        row.aa,
        row.xu,
        row.vu,
        row.au,
        row.noise_aa,
        row.noise_dd,
    )


@compiled
def _set_transition(row: Any, step: Transition) -> None:
    row.xv, row.xa, row.xd, row.vv, row.va, row.vd = (
        step.xv,
        step.xa,
        step.xd,
        step.vv,
        step.va,
        step.vd,
    )
    row.aa, row.xu, row.vu, row.au, row.noise_aa, row.noise_dd = (
        step.aa,
        step.xu,
        step.vu,
        step.au,
        step.noise_aa,
        step.noise_dd,
    )
