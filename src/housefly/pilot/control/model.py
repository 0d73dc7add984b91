"""The reduced-order drone: what is left of it when its own computer flies the attitude.

Eqs. (8)-(9) for any heading, first-order attitude (22)-(23), plus what the paper leaves out: linear
drag, first-order climb and yaw rates. The command delay is the caller's (hand over commands late).
"""

from __future__ import annotations

from math import exp
from typing import NamedTuple

from housefly.numeric import compiled, wrapped
from housefly.pilot.control.laws import acceleration, saturated_jointly, tilt

HOVER_BRAKE = 1.5
"""How quickly the drone's own hover stops it, on top of drag [1/s]."""


class DroneState(NamedTuple):
    """The reduced-order drone: place [m], heading [rad], rates [m/s, rad/s], attitude [rad]."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    psi: float = 0.0
    vx: float = 0.0
    vy: float = 0.0
    vz: float = 0.0
    yaw_rate: float = 0.0
    theta: float = 0.0
    phi: float = 0.0


class Constants(NamedTuple):
    """Identified constants of one drone.

    Attributes:
        lag: lambda of eqs. (22)-(23) [1/s].
        gain: c / lambda.
        drag: linear drag over mass [1/s].
        climb_lag: pole of the climb rate response [1/s].
        yaw_lag: pole of the yaw rate response [1/s].
    """

    lag: float = 7.0
    gain: float = 1.0
    drag: float = 0.58
    climb_lag: float = 4.0
    yaw_lag: float = 6.0


@compiled
def lagged(value: float, target: float, pole: float, dt: float) -> float:
    """Return a first-order response after dt [s]: exact for a constant target."""
    return target + (value - target) * exp(-pole * dt)


class TimeStep(NamedTuple):
    """A step of fixed length, its decays worked out beforehand.

    Attributes:
        dt: length [s].
        attitude, climb, turn: what is left of a deviation of the attitude and the rates after it.
    """

    dt: float
    attitude: float
    climb: float
    turn: float


@compiled
def time_step(constants: Constants, dt: float) -> TimeStep:
    """Return a step of dt [s]; midpoint rule, so keep it below about 20 ms."""
    return TimeStep(
        dt, exp(-constants.lag * dt), exp(-constants.climb_lag * dt), exp(-constants.yaw_lag * dt)
    )


@compiled
def moved(
    body: DroneState,
    theta_des: float,
    phi_des: float,
    vz_des: float,
    yaw_rate_des: float,
    wind: tuple[float, float],
    constants: Constants,
    step: TimeStep,
) -> DroneState:
    """Return the drone after one step; arguments as in ``body_step``."""
    dt = step.dt
    theta_end, phi_end = constants.gain * theta_des, constants.gain * phi_des
    theta = theta_end + (body.theta - theta_end) * step.attitude
    phi = phi_end + (body.phi - phi_end) * step.attitude
    vz = vz_des + (body.vz - vz_des) * step.climb
    rate = yaw_rate_des + (body.yaw_rate - yaw_rate_des) * step.turn
    turn = 0.5 * dt * (body.yaw_rate + rate)
    middle = body.psi + 0.5 * turn
    ax, ay = acceleration(0.5 * (body.theta + theta), 0.5 * (body.phi + phi), middle)
    half = 0.5 * constants.drag * dt
    keep, share = (1.0 - half) / (1.0 + half), dt / (1.0 + half)
    vx = body.vx * keep + share * (ax + wind[0])
    vy = body.vy * keep + share * (ay + wind[1])
    x = body.x + 0.5 * dt * (body.vx + vx)
    y = body.y + 0.5 * dt * (body.vy + vy)
    z = body.z + 0.5 * dt * (body.vz + vz)
    return DroneState(x, y, z, wrapped(body.psi + turn), vx, vy, vz, rate, theta, phi)


@compiled
def between(
    before: DroneState, after: DroneState, dt: float, part: float
) -> tuple[float, float, float, float]:
    """Return place [m] and heading [rad] ``part`` [s] into a step of dt [s]."""
    share = 0.5 * part * part / dt
    x = before.x + part * before.vx + share * (after.vx - before.vx)
    y = before.y + part * before.vy + share * (after.vy - before.vy)
    z = before.z + part * before.vz + share * (after.vz - before.vz)
    return (
        x,
        y,
        z,
        wrapped(before.psi + part * before.yaw_rate + share * (after.yaw_rate - before.yaw_rate)),
    )


@compiled
def hover_tilt(body: DroneState, wind: tuple[float, float], tilt_max: float) -> tuple[float, float]:
    """Return pitch and roll [rad] of the drone's own hover: it brakes and leans against pushes."""
    theta, phi = tilt(
        -HOVER_BRAKE * body.vx - wind[0], -HOVER_BRAKE * body.vy - wind[1], body.psi, 1.0
    )
    return saturated_jointly(theta, phi, tilt_max)


@compiled
def drone_step(
    body: DroneState,
    theta_des: float,
    phi_des: float,
    vz_des: float,
    yaw_rate_des: float,
    wind: tuple[float, float],
    constants: Constants,
    dt: float,
) -> DroneState:
    """Return the drone after one short step.

    Args:
        body: state before.
        theta_des: commanded pitch [rad].
        phi_des: commanded roll [rad].
        vz_des: commanded climb rate [m/s].
        yaw_rate_des: commanded yaw rate [rad/s].
        wind: disturbing world acceleration [m/s^2].
        constants: the drone's constants.
        dt: step [s]; midpoint rule, so keep it below about 20 ms.
    """
    return moved(
        body, theta_des, phi_des, vz_des, yaw_rate_des, wind, constants, time_step(constants, dt)
    )
