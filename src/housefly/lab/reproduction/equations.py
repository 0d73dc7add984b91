"""What the paper's equations and conditions do when numbers are put in; no flight is needed for
these.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product
from math import cos, exp, pi, tan

import numpy as np

from housefly.config.site import Site
from housefly.geometry import GRAVITY, quaternion_from_euler, rotate
from housefly.lab.reproduction.routes import CELL
from housefly.pilot.behavior.acceptor import PAPER_EPSILONS, Condition, printed_conditions
from housefly.pilot.control.laws import acceleration, clipped_per_axis, demand, paper_tilt
from housefly.pilot.control.model import Body, Constants, body_step

MASS = 0.436
"""Of an AR.Drone 2.0 with its indoor hull [kg]; the printed (4) is wrong by an amount that depends
on it.
"""
TICK = 0.002
"""Step of the small simulations [s]."""
RISEN = 1.0 - exp(-1.0)
"""A first-order response has risen by this share after one time constant."""
LOOK = 6.0
"""How long a response is watched [s]: seven time constants of the slowest."""
TILTS = tuple(float(angle) for angle in np.linspace(-0.21, 0.21, 7))
PAPER_HEADINGS = (0.0, pi)
HEADINGS = tuple(float(psi) for psi in np.linspace(-pi, pi, 24, endpoint=False))
LITERAL_WEIGHT = (0.0, 0.0, -GRAVITY)
"""f_g of eq. (4) as printed."""
WEIGHT = (0.0, 0.0, MASS * GRAVITY)
"""f_g as it must be for (5)-(7)."""

Conditions = Callable[[float, float, float], int]
"""Condition bits for errors of height [m], yaw [rad] and place [m]."""


@dataclass(frozen=True, slots=True)
class Overlap:
    """How the conditions share the errors among them.

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


def examine(site: Site) -> Equations:
    """Return the numbers for a site's drone and gains."""
    drone = Constants(site.drone.attitude_lag, site.drone.attitude_gain, site.drone.drag)
    angle, speed = rises(drone)
    return Equations(
        newton_printed=newton(LITERAL_WEIGHT),
        newton_mended=newton(WEIGHT),
        planar_at_two=planar(PAPER_HEADINGS),
        planar_elsewhere=planar(HEADINGS),
        overlap=overlap(_printed),
        step_deviation=step_deviation(drone, site.control.alpha, site.control.beta),
        angle_rise=angle,
        speed_rise=speed,
    )


def newton(weight: tuple[float, float, float]) -> float:
    """Return the largest difference [m/s^2] between (5)-(7) and (4) with this f_g, thrust holding
    the height.
    """
    worst = 0.0
    for theta, phi, psi in product(TILTS, TILTS, HEADINGS):
        thrust = MASS * GRAVITY / (cos(theta) * cos(phi))
        lift = rotate(quaternion_from_euler(phi, theta, psi), (0.0, 0.0, thrust))
        by_4 = [(force - down) / MASS for force, down in zip(lift, weight, strict=True)]
        by_5_to_7 = (
            *acceleration(theta, phi, psi),
            cos(phi) * cos(theta) / MASS * thrust - GRAVITY,
        )
        worst = max(worst, *(abs(a - b) for a, b in zip(by_4, by_5_to_7, strict=True)))
    return worst


def planar(headings: Sequence[float]) -> float:
    """Return the largest difference [m/s^2] between (8)-(9) with the nearer sign and the dynamics
    at these headings.
    """
    worst = 0.0
    for theta, phi, psi in product(TILTS, TILTS, headings):
        sign = 1.0 if cos(psi) > 0.0 else -1.0
        by_8, by_9 = sign * GRAVITY * tan(theta), -sign * GRAVITY * tan(phi) / cos(theta)
        ax, ay = acceleration(theta, phi, psi)
        worst = max(worst, abs(ax - by_8), abs(ay - by_9))
    return worst


def overlap(conditions: Conditions) -> Overlap:
    """Return how these conditions overlap, for errors up to three times each epsilon and for errors
    equal to one.
    """
    errors = [
        sorted({*(float(e) for e in np.linspace(0.0, 3.0 * eps, 25)), eps})
        for eps in PAPER_EPSILONS
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


def _printed(height: float, yaw: float, place: float) -> int:
    return int(printed_conditions(height, yaw, place, *PAPER_EPSILONS))


def step_deviation(drone: Constants, alpha: float, beta: float) -> float:
    """Return how far [m] a step of one cell, flown by (20)-(21) without delay or noise, strays from
    x'' = -alpha x' - beta x.

    Drag and static gain are left out: only the attitude lag of eq. (22) stands between the two.
    """
    plain = Constants(drone.lag, 1.0, 0.0)
    body, x, v, worst = Body(), 0.0, 0.0, 0.0
    for _ in range(round(LOOK / TICK)):
        wanted = demand(CELL - body.x, -body.vx, 0.0, alpha, beta)
        theta, phi = clipped_per_axis(*paper_tilt(wanted, 0.0, 1.0, 1.0), 0.21)
        body = Body(*body_step(body, theta, phi, 0.0, 0.0, (0.0, 0.0), plain, TICK))
        a = demand(CELL - x, -v, 0.0, alpha, beta)
        x, v = x + TICK * v + 0.5 * TICK * TICK * a, v + TICK * a
        worst = max(worst, abs(body.x - x))
    return worst


def rises(drone: Constants) -> tuple[float, float]:
    """Return the time [s] in which angle and speed rise by 63 % of their final values under a
    steady tenth of theta_max.
    """
    asked, body = 0.021, Body()
    angles, speeds = [], []
    for _ in range(round(LOOK / max(drone.drag, 0.1) / TICK)):
        body = Body(*body_step(body, asked, 0.0, 0.0, 0.0, (0.0, 0.0), drone, TICK))
        angles.append(body.theta)
        speeds.append(body.vx)
    return _rise(angles), _rise(speeds)


def _rise(values: Sequence[float]) -> float:
    return TICK * float(np.argmax(np.asarray(values) >= RISEN * values[-1]))
