"""The reduced-order drone: what is left of it when its own computer flies the attitude.

Eqs. (8)-(9) for any heading, first-order attitude (22)-(23), plus what the paper leaves out: linear drag, first-order climb and
yaw rates. The command delay is the caller's (hand over commands late).
"""

from __future__ import annotations

from math import exp
from typing import NamedTuple

from housefly.control.laws import acceleration
from housefly.numeric import compiled, wrapped


class Body(NamedTuple):
    """State of the reduced-order drone: world position [m], heading [rad], rates [m/s, rad/s], attitude [rad]."""

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


@compiled
def body_step(
    body: Body,
    theta_des: float,
    phi_des: float,
    vz_des: float,
    yaw_rate_des: float,
    wind: tuple[float, float],
    constants: Constants,
    dt: float,
) -> Body:
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
    theta = lagged(body.theta, constants.gain * theta_des, constants.lag, dt)
    phi = lagged(body.phi, constants.gain * phi_des, constants.lag, dt)
    vz = lagged(body.vz, vz_des, constants.climb_lag, dt)
    rate = lagged(body.yaw_rate, yaw_rate_des, constants.yaw_lag, dt)
    turn = 0.5 * dt * (body.yaw_rate + rate)
    middle = body.psi + 0.5 * turn
    ax, ay = acceleration(0.5 * (body.theta + theta), 0.5 * (body.phi + phi), middle)
    half = 0.5 * constants.drag * dt
    vx = (body.vx * (1.0 - half) + dt * (ax + wind[0])) / (1.0 + half)
    vy = (body.vy * (1.0 - half) + dt * (ay + wind[1])) / (1.0 + half)
    x = body.x + 0.5 * dt * (body.vx + vx)
    y = body.y + 0.5 * dt * (body.vy + vy)
    z = body.z + 0.5 * dt * (body.vz + vz)
    return Body(x, y, z, wrapped(body.psi + turn), vx, vy, vz, rate, theta, phi)
