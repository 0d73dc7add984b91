"""From reference and estimate to what the inner loops are asked: one function a mode."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.config import Site
from housefly.control.laws import climb_rate, clipped_per_axis, demand, paper_tilt, saturated_jointly, tilt, yaw_rate
from housefly.geometry import Vec2
from housefly.messages import Action, Behavior, Command, Setpoint


@dataclass(frozen=True, slots=True)
class Aim:
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


@dataclass(frozen=True, slots=True)
class Where:
    """Where the drone is.

    Attributes:
        position, velocity: in the plane, at the moment when a command given now acts [m, m/s].
        disturbance: steady push to be cancelled [m/s^2].
        height: [m].
        yaw: [rad].
    """

    position: Vec2
    velocity: Vec2
    disturbance: Vec2
    height: float
    yaw: float


class Autopilot:
    """The control laws with one site's gains and limits."""

    def __init__(self, site: Site) -> None:
        self._gains = site.control
        self._limits = site.limits
        self._drone = site.drone

    def default(self, aim: Aim, where: Where) -> Command:
        """Return the command of mode default: all four axes at once, in every state of the acceptor.

        The reference is looked up where it will be when the command acts; drag and disturbance are cancelled.
        """
        ahead = self._drone.command_delay
        ax, ay = (
            demand(
                aim.position[i] + ahead * aim.velocity[i] - where.position[i],
                aim.velocity[i] - where.velocity[i],
                aim.acceleration[i] + self._drone.drag * aim.velocity[i] - where.disturbance[i],
                self._gains.alpha,
                self._gains.beta,
            )
            for i in (0, 1)
        )
        theta, phi = tilt(ax, ay, where.yaw, self._drone.attitude_gain)
        theta, phi = saturated_jointly(theta, phi, self._limits.tilt_max)
        return Command(Action.FLY, Setpoint(theta, phi, self._climb(aim, where), self._turn(aim, where)))

    def paper(self, behavior: Behavior, aim: Aim, where: Where) -> Command:
        """Return the command of mode paper: only the active behavior's axis is commanded, the others are level or still."""
        if behavior is Behavior.HOVER:
            return Command(Action.HOVER)
        if behavior is Behavior.ALTITUDE_CONTROL:
            return Command(Action.FLY, Setpoint(vz=self._climb(aim, where)))
        if behavior is Behavior.YAW_CONTROL:
            return Command(Action.FLY, Setpoint(yaw_rate=self._turn(aim, where)))
        ax, ay = (
            demand(aim.position[i] - where.position[i], -where.velocity[i], 0.0, self._gains.alpha, self._gains.beta)
            for i in (0, 1)
        )
        facing = 1.0 if abs(aim.yaw) < 1.0 else -1.0
        theta, phi = clipped_per_axis(*paper_tilt(ax, ay, facing, self._drone.attitude_gain), self._limits.tilt_max)
        return Command(Action.FLY, Setpoint(theta, phi))

    def _climb(self, aim: Aim, where: Where) -> float:
        return climb_rate(aim.height, where.height, self._gains.height_gain, self._limits.vertical_speed_max)

    def _turn(self, aim: Aim, where: Where) -> float:
        return yaw_rate(aim.yaw, where.yaw, self._gains.yaw_gain, self._limits.yaw_rate_max)
