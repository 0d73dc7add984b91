"""What the tests of the height share: both filters of a drone that is given climb rates."""

from __future__ import annotations

import numpy as np

from housefly.pilot.estimation.climb_axis import ClimbAxis, ClimbModel, climb_step, predicted_climb
from housefly.pilot.estimation.climb_filter import (
    ClimbState,
    climb_and_covariance_at,
    climb_at,
    climb_initialized,
    climb_updated,
)
from housefly.pilot.estimation.delay_filter import (
    COMMAND_SPAN,
    CommandHistory,
    axes_and_covariance_at,
    command_recorded,
    delay_filter_advanced,
    delay_filter_created,
    delay_filter_initialized,
    delay_filter_updated,
)
from housefly.pilot.estimation.lagged_axis import AxisModel, initial_covariance

CLIMB_MODEL = ClimbModel(pole=1.4, sink_gain=2.0, noise=0.1, wander=0.5)
PLANE = AxisModel(7.0, 1.0, 0.58, 2.0, 0.4, 0.2)
FIRST = initial_covariance(9e-6, 0.4)
R = 9e-6


class ClimbBench:
    """Both filters of a drone first seen at 1 m, and what was commanded."""

    def __init__(self, delay: float) -> None:
        self.spans: CommandHistory = np.zeros(256, COMMAND_SPAN)
        self.delay = delay
        created = delay_filter_created(self.spans, 0.0, FIRST)
        self.h = delay_filter_initialized(created, self.spans, PLANE, delay, 0.0, 0.0, 0.0, FIRST)
        self.climb: ClimbState = climb_initialized(1.0, 0.0, R)
        self.given: list[tuple[float, float, bool]] = []

    def give(self, at: float, vz: float, flown: bool = True) -> None:
        self.h = delay_filter_advanced(self.h, self.spans, PLANE, self.delay, at)
        command_recorded(self.h, self.spans, 0.0, 0.0, flown, vz)
        self.given.append((at, vz, flown))

    def see(self, at: float, z: float) -> None:
        axis, p = climb_and_covariance_at(
            self.climb, self.h, self.spans, CLIMB_MODEL, self.delay, at
        )
        there = axes_and_covariance_at(self.h, self.spans, PLANE, self.delay, at)
        self.climb = climb_updated(self.climb, axis, p, z, at, R)
        self.h = delay_filter_updated(self.h, self.spans, PLANE, self.delay, at, there, 0.0, 0.0, R)

    def look(self, at: float) -> ClimbAxis:
        return climb_at(self.climb, self.h, self.spans, CLIMB_MODEL, self.delay, at)

    def by_hand(self, start: float, end: float, axis: ClimbAxis) -> ClimbAxis:
        """The same way in tiny steps through a list of commands."""
        piece = 0.0005
        for n in range(round((end - start) / piece)):
            at = start + (n + 0.5) * piece
            acting = [one for one in self.given if one[0] + self.delay <= at]
            _, vz, flown = acting[-1] if acting else (0.0, 0.0, False)
            u = vz if vz >= 0.0 else 2.0 * vz
            axis = predicted_climb(axis, u, climb_step(CLIMB_MODEL, flown, piece))
        return axis
