"""The paper's equations and conditions evaluated with numbers; no flight is needed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product
from math import cos, exp, pi, tan

import numpy as np

from housefly.config.site import Site
from housefly.geometry import GRAVITY, Vec3, quaternion_from_euler, rotate
from housefly.lab.reproduction.routes import PAPER_CELL
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES, Condition, printed_conditions
from housefly.pilot.control.laws import acceleration, clipped_per_axis, demand, paper_tilt
from housefly.pilot.control.model import Constants, DroneState, drone_step

_MASS = 0.436
"""Mass of an AR.Drone 2.0 with its indoor hull [kg]; the error of (4) as printed depends on it."""
_TICK = 0.002
"""Step of the small simulations [s]."""
_RISEN = 1.0 - exp(-1.0)
"""A first-order response has risen by this share after one time constant."""
_DURATION = 6.0
"""Duration of a simulated response [s]: seven of the slowest time constants."""
_TILTS = tuple(float(angle) for angle in np.linspace(-0.21, 0.21, 7))
PAPER_HEADINGS = (0.0, pi)
HEADINGS = tuple(float(psi) for psi in np.linspace(-pi, pi, 24, endpoint=False))
LITERAL_WEIGHT = (0.0, 0.0, -GRAVITY)
"""f_g of eq. (4) as printed."""
WEIGHT = (0.0, 0.0, _MASS * GRAVITY)
"""f_g as it must be for (5)-(7)."""

Conditions = Callable[[float, float, float], int]
"""Condition bits for errors of height [m], yaw [rad] and place [m]."""


@dataclass(frozen=True, slots=True)
class Overlap:
    """How the conditions divide the errors among them.

    Attributes:
        inputs: combinations of errors tried, those that equal an epsilon among them.
        q2_with_q1: how many make q2 hold together with q1.
        several: how many make more than one condition hold.
        none: how many make none hold.
    """

    inputs: int
    q2_with_q1: int
    several: int
    none: int


@dataclass(frozen=True, slots=True)
class Equations:
    """Numbers about the equations.

    Attributes:
        newton_printed: largest difference between (5)-(7) and (4) as printed [m/s^2].
        newton_mended: the same with the weight as a force [m/s^2].
        planar_at_two: largest difference between (8)-(9) and the dynamics at the headings 0 and pi
            [m/s^2].
        planar_elsewhere: the same at 24 headings all round [m/s^2].
        overlap: of the printed conditions.
        step_deviation: how far a step of one cell strays from the second-order system that (13)
            promises [m].
        angle_rise: time constant of the answer of the angle to a steady command [s].
        speed_rise: the same of the speed [s].
    """

    newton_printed: float
    newton_mended: float
    planar_at_two: float
    planar_elsewhere: float
    overlap: Overlap
    step_deviation: float
    angle_rise: float
    speed_rise: float


def _printed(height: float, yaw: float, place: float) -> int:
    return int(printed_conditions(height, yaw, place, *PAPER_TOLERANCES[:3]))


def evaluate_equations(
    site: Site,
    weight: Vec3 = LITERAL_WEIGHT,
    headings: Sequence[float] = HEADINGS,
    conditions: Conditions = _printed,
) -> Equations:
    """Return the numbers for a site's drone and gains.

    Args:
        site: whose drone and gains.
        weight: f_g of eq. (4) that stands for the printed one.
        headings: at which (8)-(9) are compared with the dynamics [rad].
        conditions: those that stand for the printed ones.
    """
    drone = Constants(site.drone.attitude_lag, site.drone.attitude_gain, site.drone.drag)
    angle, speed = _rises(drone)
    return Equations(
        newton_printed=_newton(weight),
        newton_mended=_newton(WEIGHT),
        planar_at_two=_planar(PAPER_HEADINGS),
        planar_elsewhere=_planar(headings),
        overlap=_overlap(conditions),
        step_deviation=_step_deviation(drone, site.control.alpha, site.control.beta),
        angle_rise=angle,
        speed_rise=speed,
    )


def _newton(weight: Vec3) -> float:
    """Return the largest difference [m/s^2] between (5)-(7) and (4) with this f_g.

    The thrust holds the height.
    """
    worst = 0.0
    for theta, phi, psi in product(_TILTS, _TILTS, HEADINGS):
        thrust = _MASS * GRAVITY / (cos(theta) * cos(phi))
        lift = rotate(quaternion_from_euler(phi, theta, psi), (0.0, 0.0, thrust))
        by_4 = [(force - down) / _MASS for force, down in zip(lift, weight, strict=True)]
        by_5_to_7 = (
            *acceleration(theta, phi, psi),
            cos(phi) * cos(theta) / _MASS * thrust - GRAVITY,
        )
        worst = max(worst, *(abs(a - b) for a, b in zip(by_4, by_5_to_7, strict=True)))
    return worst


def _planar(headings: Sequence[float]) -> float:
    """Return the largest difference [m/s^2] between (8)-(9) and the dynamics at these headings.

    (8)-(9) are taken with the sign of the closer heading.
    """
    worst = 0.0
    for theta, phi, psi in product(_TILTS, _TILTS, headings):
        sign = 1.0 if cos(psi) > 0.0 else -1.0
        by_8, by_9 = sign * GRAVITY * tan(theta), -sign * GRAVITY * tan(phi) / cos(theta)
        ax, ay = acceleration(theta, phi, psi)
        worst = max(worst, abs(ax - by_8), abs(ay - by_9))
    return worst


def _overlap(conditions: Conditions) -> Overlap:
    """Return how these conditions overlap, for errors up to three times each epsilon.

    Errors equal to an epsilon are among them.
    """
    errors = [
        sorted({*(float(e) for e in np.linspace(0.0, 3.0 * eps, 25)), eps})
        for eps in PAPER_TOLERANCES[:3]
    ]
    held = [conditions(*error) for error in product(*errors)]
    counts = [bin(bits).count("1") for bits in held]
    both = Condition.Q1 | Condition.Q2
    return Overlap(
        inputs=len(held),
        q2_with_q1=sum(bits & both == both for bits in held),
        several=sum(count > 1 for count in counts),
        none=counts.count(0),
    )


def _step_deviation(drone: Constants, alpha: float, beta: float) -> float:
    """Return how far [m] a step of one cell deviates from x'' = -alpha x' - beta x.

    The step is flown by (20)-(21) without delay, noise, drag or static gain, so only the attitude
    lag of eq. (22) stands between the two.
    """
    plain = Constants(drone.lag, 1.0, 0.0)
    body, x, v, worst = DroneState(), 0.0, 0.0, 0.0
    for _ in range(round(_DURATION / _TICK)):
        wanted = demand(PAPER_CELL - body.x, -body.vx, 0.0, alpha, beta)
        theta, phi = clipped_per_axis(*paper_tilt(wanted, 0.0, 1.0, 1.0), 0.21)
        body = DroneState(*drone_step(body, theta, phi, 0.0, 0.0, (0.0, 0.0), plain, _TICK))
        a = demand(PAPER_CELL - x, -v, 0.0, alpha, beta)
        x, v = x + _TICK * v + 0.5 * _TICK * _TICK * a, v + _TICK * a
        worst = max(worst, abs(body.x - x))
    return worst


def _rises(drone: Constants) -> tuple[float, float]:
    """Return the rise times [s] of angle and speed to 63 % under a tenth of theta_max."""
    asked, body = 0.021, DroneState()
    angles, speeds = [], []
    for _ in range(round(_DURATION / max(drone.drag, 0.1) / _TICK)):
        body = DroneState(*drone_step(body, asked, 0.0, 0.0, 0.0, (0.0, 0.0), drone, _TICK))
        angles.append(body.theta)
        speeds.append(body.vx)
    return _rise(angles), _rise(speeds)


def _rise(values: Sequence[float]) -> float:
    return _TICK * float(np.argmax(np.asarray(values) >= _RISEN * values[-1]))
