"""Measures a flight as it goes: the truth against path, reference and estimate."""

from __future__ import annotations

from math import inf, isnan, nan, sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.lab.experiments.route import CURVE_TOLERANCE, HOLD, STEP, Route, off_line_near
from housefly.numeric import compiled
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.control.model import DroneState
from housefly.pilot.estimation.estimator_state import PoseEstimate

LAST = 2.0
"""Arrival and what still oscillates are judged over the last seconds [s]."""
FAR = 1.0
"""A drone that was further from its path than this has not flown stably [m]."""
LOST = 50.0
"""Further than this from its path, a drone is lost and its flight ends [m]."""
QUIET = 0.1
"""A drone whose place swings by more than this at the end has not flown stably [m]."""
PERIOD = 0.02
"""Time between two looks [s]; at least one tick."""

SCORE = np.dtype(
    [
        (name, "f8")
        for name in (
            "looks",
            "path_sum",
            "path_max",
            "looks_then",
            "path_sum_then",
            "path_max_then",
            "reference_sum",
            "entered",
            "overshoot",
            "height_error",
            "estimate_sum",
            "farthest",
            "ticks",
            "switches",
            "saturated",
            "levelled",
            "last_looks",
            "goal_sum",
            "goal_off",
            "x_sum",
            "x_min",
            "x_max",
            "y_sum",
            "y_min",
            "y_max",
        )
    ]
)
"""Sums and extremes; ``*_then`` as they were when the drone last came near its goal, ``last_*`` to
``y_max`` at the end.
"""
Score = NDArray[Any]
"""One record of dtype ``SCORE`` in an array."""


@compiled
def cleared(score: Any) -> None:
    """Start anew."""
    score.looks = score.path_sum = score.path_max = score.looks_then = score.path_sum_then = (
        score.path_max_then
    ) = 0.0
    score.reference_sum = score.overshoot = score.height_error = score.estimate_sum = (
        score.farthest
    ) = 0.0
    score.ticks = score.switches = score.saturated = score.levelled = 0.0
    score.last_looks = score.goal_sum = score.x_sum = score.y_sum = score.goal_off = 0.0
    score.x_min = score.y_min = inf
    score.x_max = score.y_max = -inf
    score.entered = nan


@compiled
def looked_at(
    score: Any,
    route: Route,
    body: DroneState,
    here: PoseEstimate,
    target: TrajectorySetpoint,
    eps3: float,
    now: float,
) -> bool:
    """Take one look at a drone on its task; return whether it is still where it can be measured."""
    behind = sqrt((body.x - target.x) ** 2 + (body.y - target.y) ** 2)
    reach = behind + 2.0 * CURVE_TOLERANCE
    off = off_line_near(route.line, route.marks, body.x, body.y, reach)
    if not off < LOST or not abs(body.z) < LOST:
        return False
    score.looks += 1.0
    score.path_sum += off * off
    score.path_max = max(score.path_max, off)
    score.reference_sum += (body.x - target.x) ** 2 + (body.y - target.y) ** 2
    score.height_error = max(score.height_error, abs(body.z - target.z))
    score.estimate_sum += (here.x - body.x) ** 2 + (here.y - body.y) ** 2 + (here.z - body.z) ** 2
    _near_goal(score, route, body, eps3, now)
    if now >= route.duration - LAST - 1e-9:
        _at_the_end(score, body)
    return True


@compiled
def summed_up(score: Any, route: Route, ended_at: float, outcome: Any) -> None:
    """Write what was measured into one row of the results."""
    arrived = not isnan(score.entered) and route.task != HOLD
    looks = score.looks_then if arrived else score.looks
    path_sum = score.path_sum_then if arrived else score.path_sum
    everything = max(score.looks, 1.0)
    ticks, last = max(score.ticks, 1.0), score.last_looks
    outcome.rms_error = sqrt(path_sum / max(looks, 1.0))
    outcome.max_error = score.path_max_then if arrived else score.path_max
    outcome.reference_rms = sqrt(score.reference_sum / everything)
    outcome.arrival_time = score.entered - route.settle
    outcome.arrival_error = score.goal_sum / last if last > 0.0 else score.goal_off
    outcome.overshoot = score.overshoot
    outcome.residual = _swing(score) if last > 0.0 else score.path_max
    outcome.switches_per_s = score.switches / max(ended_at - route.settle, 1e-9)
    outcome.height_error = score.height_error
    outcome.estimate_rms = sqrt(score.estimate_sum / everything)
    outcome.saturated = score.saturated / ticks
    outcome.levelled = score.levelled / ticks
    outcome.ended_at = ended_at
    to_the_end = ended_at >= route.duration - 1e-9
    outcome.stable = (
        1.0 if to_the_end and score.path_max <= FAR and outcome.residual < QUIET else 0.0
    )


@compiled
def _near_goal(score: Any, route: Route, body: DroneState, eps3: float, now: float) -> None:
    goal = len(route.line) - 1
    dx, dy = body.x - route.line[goal, 0], body.y - route.line[goal, 1]
    score.goal_off = sqrt(dx * dx + dy * dy)
    if score.goal_off >= eps3:
        score.entered = nan
    elif isnan(score.entered):
        score.entered = now
        score.looks_then, score.path_sum_then, score.path_max_then = (
            score.looks,
            score.path_sum,
            score.path_max,
        )
    # A fast drone may be near the goal of a step at no look; only a path can pass beyond it before.
    if score.looks_then > 0.0 or route.task == STEP:
        score.overshoot = max(score.overshoot, dx * route.last_x + dy * route.last_y)


@compiled
def _at_the_end(score: Any, body: DroneState) -> None:
    score.last_looks += 1.0
    score.goal_sum += score.goal_off
    score.x_sum += body.x
    score.y_sum += body.y
    score.x_min, score.x_max = min(score.x_min, body.x), max(score.x_max, body.x)
    score.y_min, score.y_max = min(score.y_min, body.y), max(score.y_max, body.y)


@compiled
def _swing(score: Any) -> float:
    """Return the largest distance from the mean place over the last seconds, per axis [m]."""
    x, y = score.x_sum / score.last_looks, score.y_sum / score.last_looks
    return float(max(max(score.x_max - x, x - score.x_min), max(score.y_max - y, y - score.y_min)))
