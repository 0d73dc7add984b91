"""From reference and estimate to angles and rates, compiled: one function a mode."""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from housefly.geometry import Vec2
from housefly.numeric import clipped, compiled
from housefly.pilot.behavior.acceptor import AcceptorState
from housefly.pilot.control.laws import (
    climb_rate,
    clipped_per_axis,
    demand,
    paper_tilt,
    saturated_jointly,
    tilt,
    yaw_rate,
)
from housefly.pilot.estimation.estimator import ControlState


class ControlReference(NamedTuple):
    """Where the drone should be.

    Attributes:
        position, velocity, acceleration: of the reference in the plane [m, m/s, m/s^2].
        height: [m].
        yaw: [rad].
    """

    position: Vec2
    velocity: Vec2
    acceleration: Vec2
    height: float
    yaw: float


class Gains(NamedTuple):
    """What the laws need of a site.

    Attributes:
        alpha, beta: of eqs. (20)-(21) [1/s, 1/s^2].
        height, yaw: K2 and K1 [1/s].
        tilt_max, climb_max, turn_max: limits [rad, m/s, rad/s].
        gain: c / lambda of the drone.
        drag: linear drag over mass [1/s].
        delay: from command to first reaction [s].
        wraps: whether the heading error is wrapped; without, as the paper prints it.
    """

    alpha: float
    beta: float
    height: float
    yaw: float
    tilt_max: float
    climb_max: float
    turn_max: float
    gain: float
    drag: float
    delay: float
    wraps: bool = True


class ControlOutput(NamedTuple):
    """What the inner loops are asked.

    Attributes:
        theta, phi: pitch and roll [rad].
        vz, yaw_rate: [m/s, rad/s].
        wish: how far the law would have tilted without its limit [rad].
        ax, ay: acceleration that the law demands in the plane, before any limit [m/s^2].
    """

    theta: float
    phi: float
    vz: float
    yaw_rate: float
    wish: float
    ax: float
    ay: float


AT_REST = ControlOutput(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""Nothing is asked."""


@compiled
def control_output(aim: ControlReference, where: ControlState, gains: Gains) -> ControlOutput:
    """Return what mode default asks: all four axes at once, in every state of the acceptor.

    The reference is looked up where it will be when the command acts; drag and disturbance are
    cancelled.
    """
    ax, ay = _wanted(aim, where, gains, 0), _wanted(aim, where, gains, 1)
    theta, phi = tilt(ax, ay, where.yaw, gains.gain)
    wish = sqrt(theta * theta + phi * phi)
    theta, phi = saturated_jointly(theta, phi, gains.tilt_max)
    climb, turn = _climb(aim, where, gains), _turn(aim, where, gains)
    return ControlOutput(theta, phi, climb, turn, wish, ax, ay)


@compiled
def paper_control_output(
    state: int, aim: ControlReference, where: ControlState, gains: Gains
) -> ControlOutput:
    """Return what mode paper asks in a state of the acceptor: its own axis only."""
    if state == AcceptorState.ALTITUDE_CONTROL:
        return ControlOutput(0.0, 0.0, _climb(aim, where, gains), 0.0, 0.0, 0.0, 0.0)
    if state == AcceptorState.YAW_CONTROL:
        return ControlOutput(0.0, 0.0, 0.0, _turn(aim, where, gains), 0.0, 0.0, 0.0)
    if state != AcceptorState.PATH_TRACKING:
        return AT_REST
    ax = demand(
        aim.position[0] - where.position[0], -where.velocity[0], 0.0, gains.alpha, gains.beta
    )
    ay = demand(
        aim.position[1] - where.position[1], -where.velocity[1], 0.0, gains.alpha, gains.beta
    )
    facing = 1.0 if abs(aim.yaw) < 1.0 else -1.0
    theta, phi = paper_tilt(ax, ay, facing, gains.gain)
    wish = max(abs(theta), abs(phi))
    theta, phi = clipped_per_axis(theta, phi, gains.tilt_max)
    return ControlOutput(theta, phi, 0.0, 0.0, wish, ax, ay)


@compiled
def _wanted(aim: ControlReference, where: ControlState, gains: Gains, axis: int) -> float:
    return demand(
        aim.position[axis] + gains.delay * aim.velocity[axis] - where.position[axis],
        aim.velocity[axis] - where.velocity[axis],
        aim.acceleration[axis] + gains.drag * aim.velocity[axis] - where.disturbance[axis],
        gains.alpha,
        gains.beta,
    )


@compiled
def _climb(aim: ControlReference, where: ControlState, gains: Gains) -> float:
    return climb_rate(aim.height, where.height, gains.height, gains.climb_max)


@compiled
def _turn(aim: ControlReference, where: ControlState, gains: Gains) -> float:
    if gains.wraps:
        return yaw_rate(aim.yaw, where.yaw, gains.yaw, gains.turn_max)
    return clipped(gains.yaw * (aim.yaw - where.yaw), gains.turn_max)
