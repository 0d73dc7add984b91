"""The state of mode default's filter where it was last measured, and the way that leads from there to when a command will act.

A measurement tells where the drone *was*. The commands given since then, and those that it has not yet felt, say how it goes on.
The time between two looks at the clock is a *span*: one command, in force one delay later. Every span keeps the state at its
beginning, so a look at any later time costs one step, and only a measurement makes the way anew.
"""

from __future__ import annotations

from math import ceil
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.estimation.lagged_axis import (
    Axis,
    AxisModel,
    Spread,
    Transition,
    corrected,
    narrowed,
    predicted,
    spread_out,
    transition,
)
from housefly.numeric import compiled

LONGEST_STEP = 0.02
"""Longest step of the prediction [s]; the midpoint rule is good to 1e-4 m there."""
NO_TIME = 1e-9
"""Times nearer to each other than this are the same [s]: sums of ticks and delays differ in their last bits."""

SPAN = np.dtype(
    [("sent", "f8"), ("seconds", "f8"), ("pieces", "i8"), ("flown", "i8"), ("ux", "f8"), ("uy", "f8")]
    + [(name, "f8") for name in Transition._fields]
    + [(f"{axis}_{name}", "f8") for axis in "xy" for name in Axis._fields]
)
"""One span: when its command was sent, how long it lasts, the command, one of its equal steps, the state where it begins."""
Spans = NDArray[Any]
"""Ring of spans, its length a power of two."""


class Horizon(NamedTuple):
    """Where the filter stands.

    Attributes:
        at: time of the last measurement taken in [s].
        span: number of the span in which it lies.
        newest: number of the span that has not ended.
        x, y: state at ``at``.
        spread: its covariance.
    """

    at: float
    span: int
    newest: int
    x: Axis
    y: Axis
    spread: Spread


class Reached(NamedTuple):
    """The state carried to one time, and the span in which that lies."""

    span: int
    x: Axis
    y: Axis
    spread: Spread


@compiled
def opened(spans: Spans, now: float, first: Spread) -> Horizon:
    """Return the beginning: nothing was seen, and nothing is commanded from now [s] on."""
    nowhere = Axis(0.0, 0.0, 0.0, 0.0)
    spans[0].sent = now
    spans[0].flown = 0
    _place(spans[0], nowhere, nowhere)
    return Horizon(now, 0, 0, nowhere, nowhere, first)


@compiled
def begun(h: Horizon, spans: Spans, model: AxisModel, delay: float, at: float, x: float, y: float, first: Spread) -> Horizon:
    """Return the horizon of a drone first seen at rest at (x, y) [m] at a time [s]."""
    span = _span_at(h, spans, delay, at)
    made = Horizon(at, span, h.newest, Axis(x, 0.0, 0.0, 0.0), Axis(y, 0.0, 0.0, 0.0), first)
    _lay(made, spans, model, delay)
    return made


@compiled
def commanded(h: Horizon, spans: Spans, ux: float, uy: float, flown: bool) -> None:
    """Put the newest span under a command: world acceleration [m/s^2]; not flown means that the drone flies itself."""
    row = spans[h.newest & (spans.size - 1)]
    row.flown = 1 if flown else 0
    row.ux = ux if flown else 0.0
    row.uy = uy if flown else 0.0


@compiled
def advanced(h: Horizon, spans: Spans, model: AxisModel, delay: float, now: float) -> Horizon:
    """Return the horizon with the newest span ended now [s] and the next one begun under the same command."""
    ring = spans.size - 1
    row, following = spans[h.newest & ring], spans[(h.newest + 1) & ring]
    if now - row.sent <= NO_TIME:
        return h
    if h.newest - h.span >= ring - 1:
        h = settled(h, spans, model, delay, spans[(h.span + 1) & ring].sent + delay)
    _measure(row, spans[(h.newest - 1) & ring], model, now)
    following.sent, following.flown, following.ux, following.uy = now, row.flown, row.ux, row.uy
    x, y = _leaving(h, spans, model, delay, h.newest)
    _place(following, x, y)
    newest = h.newest + 1
    span = newest if h.span == h.newest and h.at >= now + delay - NO_TIME else h.span
    return Horizon(h.at, span, newest, h.x, h.y, h.spread)


@compiled
def looked(h: Horizon, spans: Spans, model: AxisModel, delay: float, at: float) -> tuple[Axis, Axis]:
    """Return both axes at a time [s] not before the last measurement."""
    span = _span_at(h, spans, delay, at)
    row = spans[span & (spans.size - 1)]
    x, y, start = h.x, h.y, h.at
    if span > h.span:
        x, y, start = _axis_x(row), _axis_y(row), row.sent + delay
    return _carried(x, y, row, model, at - start)


@compiled
def reached(h: Horizon, spans: Spans, model: AxisModel, delay: float, at: float) -> Reached:
    """Return both axes and their covariance at a time [s], carried from the last measurement."""
    ring = spans.size - 1
    p, start, span = h.spread, h.at, h.span
    while span < h.newest and spans[(span + 1) & ring].sent + delay <= at + NO_TIME:
        row, end = spans[span & ring], spans[(span + 1) & ring].sent + delay
        if span > h.span:
            step = _step(row)
            for _ in range(row.pieces):
                p = spread_out(p, step)
        else:
            p = _spread_carried(p, row, model, end - start)
        start = end
        span += 1
    row = spans[span & ring]
    x, y = (h.x, h.y) if span == h.span else (_axis_x(row), _axis_y(row))
    if at - start <= NO_TIME:
        return Reached(span, x, y, p)
    pieces = ceil((at - start) / LONGEST_STEP - NO_TIME)
    step = transition(model, row.flown > 0, (at - start) / pieces)
    for _ in range(pieces):
        x, y, p = predicted(x, row.ux, step), predicted(y, row.uy, step), spread_out(p, step)
    return Reached(span, x, y, p)


@compiled
def measured(
    h: Horizon, spans: Spans, model: AxisModel, delay: float, at: float, there: Reached, x: float, y: float, variance: float
) -> Horizon:
    """Return the horizon after a measurement (x, y) [m] of a variance [m^2] at the time ``at`` [s] that was reached."""
    p = there.spread
    made = Horizon(
        at,
        there.span,
        h.newest,
        corrected(there.x, p, x, variance),
        corrected(there.y, p, y, variance),
        narrowed(p, variance),
    )
    _lay(made, spans, model, delay)
    return made


@compiled
def settled(h: Horizon, spans: Spans, model: AxisModel, delay: float, at: float) -> Horizon:
    """Return the horizon standing at a later time [s], before which nothing can be measured any more."""
    if at <= h.at:
        return h
    there = reached(h, spans, model, delay, at)
    return Horizon(at, there.span, h.newest, there.x, there.y, there.spread)


@compiled
def _lay(h: Horizon, spans: Spans, model: AxisModel, delay: float) -> None:
    """Write the state at the beginning of every span after the measurement."""
    if h.span == h.newest:
        return
    ring = spans.size - 1
    x, y = _leaving(h, spans, model, delay, h.span)
    _place(spans[(h.span + 1) & ring], x, y)
    for span in range(h.span + 1, h.newest):
        row = spans[span & ring]
        step = _step(row)
        for _ in range(row.pieces):
            x, y = predicted(x, row.ux, step), predicted(y, row.uy, step)
        _place(spans[(span + 1) & ring], x, y)


@compiled
def _leaving(h: Horizon, spans: Spans, model: AxisModel, delay: float, span: int) -> tuple[Axis, Axis]:
    """Return both axes at the end of a span that has ended."""
    row = spans[span & (spans.size - 1)]
    if span == h.span:
        return _carried(h.x, h.y, row, model, row.sent + row.seconds + delay - h.at)
    x, y, step = _axis_x(row), _axis_y(row), _step(row)
    for _ in range(row.pieces):
        x, y = predicted(x, row.ux, step), predicted(y, row.uy, step)
    return x, y


@compiled
def _span_at(h: Horizon, spans: Spans, delay: float, at: float) -> int:
    """Return the number of the span whose command acts at a time [s]; the oldest kept when it is before all."""
    ring = spans.size - 1
    span = h.newest
    while span > h.span and spans[span & ring].sent + delay > at + NO_TIME:
        span -= 1
    return span


@compiled
def _measure(row: Any, before: Any, model: AxisModel, now: float) -> None:
    """Give a span that ends now [s] its length and its step; spans of one length share the work."""
    seconds = now - row.sent
    if abs(seconds - before.seconds) <= 1e-12 and before.flown == row.flown and before.pieces > 0:
        row.pieces = before.pieces
        _keep(row, _step(before))
    else:
        row.pieces = ceil(seconds / LONGEST_STEP - NO_TIME)
        _keep(row, transition(model, row.flown > 0, seconds / row.pieces))
    row.seconds = seconds


@compiled
def _carried(x: Axis, y: Axis, row: Any, model: AxisModel, seconds: float) -> tuple[Axis, Axis]:
    if seconds <= NO_TIME:
        return x, y
    pieces = ceil(seconds / LONGEST_STEP - NO_TIME)
    step = transition(model, row.flown > 0, seconds / pieces)
    for _ in range(pieces):
        x, y = predicted(x, row.ux, step), predicted(y, row.uy, step)
    return x, y


@compiled
def _spread_carried(p: Spread, row: Any, model: AxisModel, seconds: float) -> Spread:
    if seconds <= NO_TIME:
        return p
    pieces = ceil(seconds / LONGEST_STEP - NO_TIME)
    step = transition(model, row.flown > 0, seconds / pieces)
    for _ in range(pieces):
        p = spread_out(p, step)
    return p


@compiled
def _axis_x(row: Any) -> Axis:
    return Axis(row.x_x, row.x_v, row.x_a, row.x_d)


@compiled
def _axis_y(row: Any) -> Axis:
    return Axis(row.y_x, row.y_v, row.y_a, row.y_d)


@compiled
def _place(row: Any, x: Axis, y: Axis) -> None:
    row.x_x, row.x_v, row.x_a, row.x_d = x
    row.y_x, row.y_v, row.y_a, row.y_d = y


@compiled
def _step(row: Any) -> Transition:
    return Transition(row.xv, row.xa, row.xd, row.vv, row.va, row.vd, row.aa, row.xu, row.vu, row.au, row.noise_aa, row.noise_dd)


@compiled
def _keep(row: Any, step: Transition) -> None:
    row.xv, row.xa, row.xd, row.vv, row.va, row.vd = step.xv, step.xa, step.xd, step.vv, step.va, step.vd
    row.aa, row.xu, row.vu, row.au, row.noise_aa, row.noise_dd = step.aa, step.xu, step.vu, step.au, step.noise_aa, step.noise_dd
