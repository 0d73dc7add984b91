"""How fast to fly a curve: as fast as its limits allow, and no jolts.

First the time-optimal profile with bounded acceleration: the limits swept backward for braking and
forward for speeding up. Then its motion is averaged over a short time, which makes the acceleration
continuous: the jerk is at most the change of acceleration over that time.
"""

from __future__ import annotations

from math import sqrt
from typing import Any

import numpy as np

from housefly.numeric import FloatArray, compiled, compiled_with_arrays
from housefly.pilot.planning.trajectory.speed_limits import MotionLimits

_SWEEPS = 2
"""Speed and what is left to brake with depend on each other: so often both are worked out."""


@compiled
def _left_over(speed: float, flat_bend: float, drag: float, acceleration: float) -> float:
    """Return what a bend at a speed leaves of the acceleration along the curve [m/s^2]."""
    aside = flat_bend * speed * speed
    return sqrt(max(acceleration * acceleration - aside * aside, 0.0))


@compiled_with_arrays
def swept(
    marks: FloatArray,
    fastest: FloatArray,
    bend: FloatArray,
    steep: FloatArray,
    limits: MotionLimits,
    start_speed: float,
) -> FloatArray:
    """Return the highest speed at each sample that bounded acceleration allows [m/s], shape (n,).

    Args:
        marks: arc length of the samples [m].
        fastest: highest speed at each [m/s].
        bend: horizontal curvature at each [1/m].
        steep: share of the way that goes up or down at each.
        limits: of the drone.
        start_speed: at the first sample [m/s]; higher than what comes out when it cannot stop in
            time.
    """
    n = marks.size
    speed = fastest.copy()
    speed[n - 1] = 0.0
    for i in range(n - 2, -1, -1):
        step = marks[i + 1] - marks[i]
        trial = speed[i + 1]
        for _ in range(_SWEEPS):
            left = _left_over(trial, bend[i], limits.drag, limits.acceleration)
            brake = min(left, limits.vertical_acceleration / max(steep[i], 1e-9))
            trial = min(speed[i], sqrt(speed[i + 1] * speed[i + 1] + 2.0 * brake * step))
        speed[i] = trial
    speed[0] = min(speed[0], start_speed)
    for i in range(n - 1):
        step = marks[i + 1] - marks[i]
        left = _left_over(speed[i], bend[i], limits.drag, limits.acceleration)
        push = max(left - limits.drag * speed[i], 0.0)
        push = min(push, limits.vertical_acceleration / max(steep[i], 1e-9))
        speed[i + 1] = min(speed[i + 1], sqrt(speed[i] * speed[i] + 2.0 * push * step))
    return speed


@compiled_with_arrays
def timed(marks: FloatArray, speed: FloatArray, wait: float) -> FloatArray:
    """Return when each sample is reached with a speed profile [s], shape (n,).

    Where two marks are the same it waits for a time [s].
    """
    times = np.zeros(marks.size)
    for i in range(marks.size - 1):
        mean = max(0.5 * (speed[i] + speed[i + 1]), 1e-6)
        step = marks[i + 1] - marks[i]
        times[i + 1] = times[i] + (step / mean if step > 0.0 else wait)
    return times


@compiled_with_arrays
def averaged(
    times: FloatArray,
    marks: FloatArray,
    speed: FloatArray,
    window: float,
    start: Any,
    tick: float,
) -> FloatArray:
    """Return arc length [m], speed [m/s] and acceleration [m/s^2] of the averaged motion.

    Args:
        times: when each sample is reached [s].
        marks: arc length of each [m].
        speed: at each [m/s].
        window: time that is averaged over [s].
        start: speed and acceleration at the start [m/s, m/s^2].
        tick: time between two rows [s].

    Returns:
        Shape (m, 3); the last row stands at the end.
    """
    n = times.size
    area = np.zeros(n)
    for i in range(n - 1):
        dt = times[i + 1] - times[i]
        a = (speed[i + 1] - speed[i]) / max(dt, 1e-12)
        area[i + 1] = area[i] + marks[i] * dt + 0.5 * speed[i] * dt * dt + a * dt**3 / 6.0
    count = int(np.ceil((times[n - 1] + window) / tick)) + 1
    rows = np.empty((count, 3))
    late, early = 0, 0
    for k in range(count):
        t = k * tick
        late, a1, s1, v1 = _motion_at(t, late, times, marks, speed, area, start)
        early, a0, s0, v0 = _motion_at(t - window, early, times, marks, speed, area, start)
        rows[k, 0] = (a1 - a0) / window
        rows[k, 1] = (s1 - s0) / window
        rows[k, 2] = (v1 - v0) / window
    rows[count - 1, 0], rows[count - 1, 1], rows[count - 1, 2] = marks[n - 1], 0.0, 0.0
    return rows


@compiled
def _motion_at(
    t: float, at: int, times: Any, marks: Any, speed: Any, area: Any, start: Any
) -> tuple[int, float, float, float]:
    """Return index, integral of the arc length, arc length and speed of the motion at a time [s].

    Before its start it goes on backward with the acceleration at the start; after its end it
    stands.
    """
    n = times.size
    if t < 0.0:
        a, v, s = start[1], speed[0], marks[0]
        return at, s * t + 0.5 * v * t * t + a * t**3 / 6.0, s + v * t + 0.5 * a * t * t, v + a * t
    if t >= times[n - 1]:
        return at, area[n - 1] + marks[n - 1] * (t - times[n - 1]), marks[n - 1], 0.0
    while at < n - 2 and times[at + 1] <= t:
        at += 1
    dt, whole = t - times[at], times[at + 1] - times[at]
    a = (speed[at + 1] - speed[at]) / max(whole, 1e-12)
    v, s = speed[at], marks[at]
    return (
        at,
        area[at] + s * dt + 0.5 * v * dt * dt + a * dt**3 / 6.0,
        s + v * dt + 0.5 * a * dt * dt,
        v + a * dt,
    )
