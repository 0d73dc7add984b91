"""The simulated drone of an experiment: late commands, gusts, and its own hover."""

from __future__ import annotations

from math import ceil, cos, exp, floor, sin, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.lab.experiments.random import RandomState, normal
from housefly.lab.experiments.tracking_noise import Camera, Frames, Stream, exposed
from housefly.numeric import compiled
from housefly.pilot.control.forms import FormCode
from housefly.pilot.control.laws import acceleration, saturated_jointly, tilt
from housefly.pilot.control.model import (
    Constants,
    DroneState,
    TimeStep,
    hover_tilt,
    moved,
    time_step,
)
from housefly.pilot.estimation.delay_filter import TIME_TOLERANCE

LONGEST_STEP = 0.0125
"""Longest step of the dynamics [s]."""
GUST_TIME = 1.0
"""Correlation time of gusts [s]."""
_ASKED = ("theta", "phi", "vz", "yaw_rate", "forward", "left", "x", "y", "z")
ORDER = np.dtype([("flying", "i8")] + [(name, "f8") for name in _ASKED])
"""What left the pilot's gate, by tilt or in another form; not flying is the drone's own hover."""
ORDER_RING_SIZE = 128
"""Orders kept: more than half a second at 200 Hz."""
Orders = NDArray[Any]
"""Ring of ``ORDERS`` orders."""


class SampledDrone(NamedTuple):
    """One drone between two ticks of the pilot.

    An order acts a whole number of ticks after it was sent and then some: so every tick has an
        early part under the older order
    and a late part under the newer one.

    Attributes:
        constants: of the drone.
        lag_ticks: whole ticks of the command delay.
        early, late: step of each part.
        early_steps, late_steps: how many.
        tilt_max: of its own hover [rad].
        wind_x, wind_y: steady push [m/s^2].
        climb_beside: climb rate at rest beside the commanded one, by a steady push upwards [m/s].
        sink_gain: what it makes of a commanded sinking, over what was commanded.
        gust: one sigma of the push that changes [m/s^2].
        gust_kept: share of it that is left after a tick.
        form: a ``FormCode``.
        pull: pole of its velocity response, or damping of that to places [1/s].
        stiffness: of the response to places [1/s^2].
    """

    constants: Constants
    lag_ticks: int
    early: TimeStep
    late: TimeStep
    early_steps: int
    late_steps: int
    tilt_max: float
    wind_x: float
    wind_y: float
    climb_beside: float
    sink_gain: float
    gust: float
    gust_kept: float
    form: int
    pull: float
    stiffness: float


@compiled
def sampled_drone(case: Any) -> SampledDrone:
    """Return the drone of one case."""
    tick = 1.0 / case.rate_hz
    constants = Constants(case.lag, case.gain, case.drag, case.climb_lag, case.yaw_lag)
    lag_ticks = floor(case.delay / tick + TIME_TOLERANCE)
    early = max(case.delay - lag_ticks * tick, 0.0)
    early = 0.0 if early < TIME_TOLERANCE else early
    late = tick - early
    early_steps, late_steps = ceil(early / LONGEST_STEP), ceil(late / LONGEST_STEP)
    return SampledDrone(
        constants,
        lag_ticks,
        time_step(constants, early / max(early_steps, 1)),
        time_step(constants, late / late_steps),
        early_steps,
        late_steps,
        case.tilt_max,
        case.wind_x,
        case.wind_y,
        case.lift / case.climb_lag,
        case.sink_gain,
        case.gust,
        exp(-tick / GUST_TIME),
        case.form,
        case.pull,
        case.stiffness,
    )


@compiled
def gusted(
    gust: tuple[float, float], air: SampledDrone, random: RandomState
) -> tuple[float, float]:
    """Return the push of the gusts one tick later [m/s^2]."""
    if air.gust <= 0.0:
        return gust
    fresh = air.gust * sqrt(1.0 - air.gust_kept * air.gust_kept)
    return air.gust_kept * gust[0] + fresh * normal(random), air.gust_kept * gust[
        1
    ] + fresh * normal(random)


@compiled
def carried_on(
    body: DroneState,
    stream: Stream,
    tick: int,
    now: float,
    air: SampledDrone,
    gust: tuple[float, float],
    orders: Orders,
    camera: Camera,
    frames: Frames,
    random: RandomState,
) -> tuple[DroneState, Stream]:
    """Return drone and tracking stream one tick of the pilot later."""
    wind = (air.wind_x + gust[0], air.wind_y + gust[1])
    for n in range(air.early_steps + air.late_steps):
        is_early = n < air.early_steps
        step = air.early if is_early else air.late
        sent = tick - air.lag_ticks - (1 if is_early else 0)
        before = body
        body = _pushed(body, sent, orders, wind, air, step)
        stream = exposed(stream, camera, frames, random, before, body, now, step.dt)
        now += step.dt
    return body, stream


@compiled
def _pushed(
    body: DroneState,
    sent: int,
    orders: Orders,
    wind: tuple[float, float],
    air: SampledDrone,
    step: TimeStep,
) -> DroneState:
    order = orders[sent & (orders.size - 1)]
    if sent >= 0 and order.flying > 0:
        vz = order.vz if order.vz >= 0.0 else air.sink_gain * order.vz
        vz += air.climb_beside
        theta, phi = order.theta, order.phi
        if air.form != FormCode.TILT_AND_CLIMB.value:
            theta, phi = _leaning(body, order, air)
        if air.form == FormCode.POSITION.value:
            vz = air.stiffness / air.constants.climb_lag * (order.z - body.z) + air.climb_beside
        return moved(body, theta, phi, vz, order.yaw_rate, wind, air.constants, step)
    theta, phi = hover_tilt(body, wind, air.tilt_max)
    return moved(body, theta, phi, air.climb_beside, 0.0, wind, air.constants, step)


@compiled
def _leaning(body: DroneState, order: Any, air: SampledDrone) -> tuple[float, float]:
    """Return pitch and roll [rad] of a drone that flies velocities, or to places, by itself.

    As ``twin.setpoint_firmware``: behind its lag it accelerates by push - pull v.
    """
    c, s = cos(body.psi), sin(body.psi)
    push_x = air.pull * (c * order.forward - s * order.left)
    push_y = air.pull * (s * order.forward + c * order.left)
    if air.form == FormCode.POSITION.value:
        push_x, push_y = air.stiffness * (order.x - body.x), air.stiffness * (order.y - body.y)
    has_x, has_y = acceleration(body.theta, body.phi, body.psi)
    held, lead = air.pull - air.constants.drag, air.pull / air.constants.lag
    theta, phi = tilt(
        push_x - held * body.vx - lead * has_x,
        push_y - held * body.vy - lead * has_y,
        body.psi,
        1.0,
    )
    return saturated_jointly(theta, phi, air.tilt_max)
