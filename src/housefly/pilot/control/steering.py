"""From reference and estimate to angles and rates, compiled: one function a mode."""

from __future__ import annotations

from math import inf, sqrt
from typing import NamedTuple

from housefly.geometry import Vec2
from housefly.numeric import clipped, compiled
from housefly.pilot.behavior.acceptor import AcceptorState
from housefly.pilot.control.laws import (
    climb_rate,
    clipped_per_axis,
    compensated_climb_rate,
    demand,
    paper_tilt,
    saturated_jointly,
    tilt,
    yaw_rate,
)
from housefly.pilot.estimation.estimator_state import ControlState


class ControlReference(NamedTuple):
    """Where the drone should be.

    Attributes:
        position, velocity, acceleration: of the reference in the plane [m, m/s, m/s^2].
        height: [m].
        yaw: [rad].
        climb: climb rate to ask for where the height is right [m/s].
        turn: yaw rate to ask for where the heading is right [rad/s].
        lead: how long after a command the tilt is reached [s]; meanwhile the drone turns.
    """

    position: Vec2
    velocity: Vec2
    acceleration: Vec2
    height: float
    yaw: float
    climb: float = 0.0
    turn: float = 0.0
    lead: float = 0.0


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
        lag: lambda, for the feed-forward of a trajectory [1/s].
        climb_lag: pole of the climb rate response [1/s].
        inverts_climb: whether that pole and the lift are inverted; else the height is flown by
            eq. (17) alone.
        sink_gain: what the drone makes of a commanded sinking, over what was commanded.
        feed_forward: share of the reference's velocity and acceleration that is led with.
        climb_command_max: largest climb rate to ask for where lag and lift are inverted [m/s].
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
    lag: float = inf
    climb_lag: float = inf
    inverts_climb: bool = False
    sink_gain: float = 1.0
    feed_forward: float = 1.0
    climb_command_max: float = inf


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


BETA_MIN = 1e-6
"""A smaller stiffness is none [1/s^2]; campaigns fly negative ones."""
AT_REST = ControlOutput(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""Nothing is asked."""


@compiled
def control_output(aim: ControlReference, where: ControlState, gains: Gains) -> ControlOutput:
    """Return what mode default asks: all four axes at once, in every state of the acceptor.

    The reference is looked up where it will be when the command acts; drag and disturbance are
    cancelled.
    """
    ax, ay = _wanted(aim, where, gains, 0), _wanted(aim, where, gains, 1)
    climb, turn = _climb(aim, where, gains), _turn(aim, where, gains)
    theta, phi = tilt(ax, ay, where.yaw + aim.lead * turn, gains.gain)
    wish = sqrt(theta * theta + phi * phi)
    theta, phi = saturated_jointly(theta, phi, gains.tilt_max)
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
    softer = min(1.0, where.bandwidth / sqrt(max(gains.beta, BETA_MIN)))
    velocity = gains.feed_forward * aim.velocity[axis]
    led = gains.feed_forward * aim.acceleration[axis]
    delay = gains.delay + where.delay_change
    return demand(
        aim.position[axis] + delay * velocity - where.position[axis],
        velocity - where.velocity[axis],
        led + gains.drag * velocity - where.disturbance[axis],
        gains.alpha * softer,
        gains.beta * softer * softer,
    )


@compiled
def _climb(aim: ControlReference, where: ControlState, gains: Gains) -> float:
    wanted = climb_rate(aim.height, where.height, gains.height, aim.climb, gains.climb_max)
    if not gains.inverts_climb:
        return wanted
    asked = compensated_climb_rate(wanted, where.climb, where.lift, gains.height, gains.climb_lag)
    asked = clipped(asked, gains.climb_command_max)
    return asked if asked >= 0.0 else asked / gains.sink_gain


@compiled
def _turn(aim: ControlReference, where: ControlState, gains: Gains) -> float:
    if gains.wraps:
        return yaw_rate(aim.yaw, where.yaw, gains.yaw, aim.turn, gains.turn_max)
    return clipped(gains.yaw * (aim.yaw - where.yaw), gains.turn_max)
