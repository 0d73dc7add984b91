"""What was commanded lately, and the filter's state rolled forward through it.

A measurement tells where the drone *was*. Commands given since then, and those that it has not yet felt, say how it went on.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.estimation.lagged_axis import Axis, AxisModel, Spread, predicted, spread_out
from housefly.numeric import compiled

ROWS = 1024
"""Commands kept: more than two seconds at the fastest loop rate, twice over so that the oldest half can be dropped in one go."""
LONGEST_STEP = 0.02
"""Longest step of the prediction [s]; the midpoint rule is good to 1e-4 m there."""

Table = NDArray[np.float64]


@compiled
def row_in_force(table: Table, count: int, delay: float, at: float) -> int:
    """Return the row of the command that acts on the drone at a time [s]; -1 before the first.

    Args:
        table: rows of time [s], commanded world acceleration x, y [m/s^2], flown (1 or 0).
        count: rows in use.
        delay: from command to first reaction [s].
        at: time [s].
    """
    row = count - 1
    while row >= 0 and table[row, 0] + delay > at:
        row -= 1
    return row


@compiled
def rolled(
    x: Axis, y: Axis, p: Spread, start: float, end: float, table: Table, count: int, delay: float, model: AxisModel
) -> tuple[Axis, Axis, Spread]:
    """Return both axes and their covariance at ``end`` [s], having been at ``start`` [s], through the commands between."""
    row = row_in_force(table, count, delay, start)
    at = start
    while at < end:
        until = min(end, at + LONGEST_STEP)
        if row + 1 < count:
            until = min(until, table[row + 1, 0] + delay)
        flown = row >= 0 and table[row, 3] > 0.5
        ux = table[row, 1] if flown else 0.0
        uy = table[row, 2] if flown else 0.0
        dt = until - at
        x = predicted(x, ux, flown, model, dt)
        y = predicted(y, uy, flown, model, dt)
        p = spread_out(p, flown, model, dt)
        at = until
        if row + 1 < count and table[row + 1, 0] + delay <= at:
            row += 1
    return x, y, p


class CommandHistory:
    """The last commands by the time they were sent."""

    def __init__(self, delay: float) -> None:
        self.delay = delay
        self.count = 0
        self.table: Table = np.zeros((ROWS, 4))

    def add(self, at: float, ax: float, ay: float, flown: bool) -> None:
        """Note a command: world acceleration [m/s^2] asked at a time [s]; not flown means that the drone flies itself."""
        if self.count and at <= self.table[self.count - 1, 0]:
            self.count -= 1
        if self.count == ROWS:
            half = ROWS // 2
            self.table[:half] = self.table[half:]
            self.count = half
        self.table[self.count] = (at, ax, ay, 1.0 if flown else 0.0)
        self.count += 1

    def roll(self, x: Axis, y: Axis, p: Spread, start: float, end: float, model: AxisModel) -> tuple[Axis, Axis, Spread]:
        """Return the filter's state carried from ``start`` to ``end`` [s]."""
        result: Any = rolled(x, y, p, start, end, self.table, self.count, self.delay, model)
        return Axis(*result[0]), Axis(*result[1]), Spread(*result[2])
