"""Bringing a drone to rest when nobody else steers any more.

Pure. The velocity is the last one that tracking gave, carried on by the attitude that the drone
reports, or, where its reports stand still, by the one that it was asked for. Where tracking was not
believed it is the drone's own, and where that is none, the speed that its attitude must have given
it. The drone's own hover brakes as well, but gently, and only
where its flow camera sees enough: a drone whose speed is not believed sinks level in its place.
"""

from __future__ import annotations

from math import atan, cos, hypot, inf, isfinite, sin

from housefly.config.airframe import Airframe
from housefly.geometry import GRAVITY, Vec2, wrap_angle
from housefly.messages import DroneStatus, KnownMotion, Setpoint, Telemetry

_SPEED_AGE_MAX = 0.15
"""An older report says nothing about the present speed [s]."""
SINK_RATE = 0.3
"""How fast a drone sinks that cannot be left to its own hover [m/s]."""
ON_FLOOR, SINK_TIME_MAX = 0.12, 9.0
"""It is on the floor when its sonar says less than this [m], or after so long [s]."""
KNOWN_FOR = 12.0
"""The last velocity by tracking is carried on for so long [s]."""
FROZEN_AFTER = 0.1
"""Reports in flight that tell the same to the last bit for longer say nothing, where the drone's
own speed is not believed either [s]: then the drone leans as it was asked to, with delay and lag.
"""
_GAP_MAX = 0.3
"""After a longer gap between reports the speed from attitude starts anew [s]."""


class AttitudeSpeed:
    """The speed that the reported attitude must have given the drone, with linear drag.

    Args:
        airframe: of the drone.

    Attributes:
        velocity: forward and left [m/s].
        motion: what the pilot knew last.
        brake: how the drone is brought to rest.
    """

    def __init__(self, airframe: Airframe) -> None:
        self.brake, self._drag = airframe.brake, airframe.response.drag
        self.velocity: Vec2 = (0.0, 0.0)
        self.motion = KnownMotion()
        self._known_at = -inf
        self._last: Telemetry | None = None
        self._changed_at = inf
        self._asked: Vec2 = (0.0, 0.0)
        self._leans: Vec2 = (0.0, 0.0)

    def ask(self, setpoint: Setpoint) -> None:
        """Take in what the drone is told to do."""
        self._asked = setpoint.theta, setpoint.phi

    def attitude(self, report: Telemetry) -> Vec2:
        """Return how the drone leans [rad], theta and phi, by its report if that tells anything."""
        is_frozen = report.received_at - self._changed_at > FROZEN_AFTER
        says_nothing = is_frozen and not self.motion.hovers
        return self._leans if says_nothing else (report.theta, report.phi)

    def know(self, motion: KnownMotion, at: float) -> None:
        """Take in what the pilot knew at a time [s]."""
        self.motion = motion
        forward, left = motion.forward, motion.left
        if forward is None or left is None or not (isfinite(forward) and isfinite(left)):
            return
        self.velocity, self._known_at = (forward, left), at

    def _forget(self) -> None:
        self.velocity, self._known_at = (0.0, 0.0), -inf

    def is_known(self, now: float) -> bool:
        """Return whether the velocity is carried on from one that tracking gave."""
        return now - self._known_at < KNOWN_FOR

    def update(self, report: Telemetry) -> None:
        """Take in a report; one that was taken in before changes nothing."""
        last, self._last = self._last, report
        if last is None or _told(last) != _told(report):
            self._changed_at = report.received_at
        if last is None:
            return
        if report.status is not DroneStatus.FLYING:
            self._forget()
            return
        dt = report.received_at - last.received_at
        is_known = all(map(isfinite, (report.theta, report.phi, report.psi, last.psi)))
        if not (is_known and 0.0 <= dt <= _GAP_MAX):
            self._forget()
            return
        turned = wrap_angle(report.psi - last.psi)
        forward, left = self.velocity
        forward, left = (
            cos(turned) * forward + sin(turned) * left,
            cos(turned) * left - sin(turned) * forward,
        )
        self._lean(report, dt)
        level, (theta, phi) = self.motion, self._leans
        ahead = GRAVITY * (sin(theta) - sin(level.theta))
        aside = GRAVITY * (sin(level.phi) - sin(phi))
        self.velocity = (
            forward + dt * (ahead - self._drag * forward),
            left + dt * (aside - self._drag * left),
        )

    def _lean(self, report: Telemetry, dt: float) -> None:
        """Lean as is reported, or as is asked for where reports stand still."""
        theta, phi = self._leans
        share = min(dt / self.brake.attitude_lag, 1.0)
        asked_theta, asked_phi = self._asked
        self._leans = theta + share * (asked_theta - theta), phi + share * (asked_phi - phi)
        self._leans = self.attitude(report)


def braking_setpoint(
    now: float, report: Telemetry, speed: AttitudeSpeed, tilt_max: float
) -> Setpoint | None:
    """Return the tilt that brings a flying drone to rest, or None once it is, or nothing is known.

    Args:
        now: [s].
        report: the newest.
        speed: what is known of its speed.
        tilt_max: largest tilt [rad].

    A report with numbers that are none leaves it to the drone's own hover.
    """
    is_known = all(map(isfinite, (report.theta, report.phi)))
    if not is_known or now - report.received_at > _SPEED_AGE_MAX:
        return None
    forward, left = _velocity(now, report, speed)
    level = speed.motion
    theta, phi = speed.attitude(report)
    forward += speed.brake.lead * GRAVITY * (sin(theta) - sin(level.theta))
    left -= speed.brake.lead * GRAVITY * (sin(phi) - sin(level.phi))
    length = hypot(forward, left)
    if not isfinite(length) or length < speed.brake.rest_speed:
        return None
    gain = speed.brake.gain
    return Setpoint(
        theta=_tilt(-gain * forward, level.theta, tilt_max),
        phi=_tilt(gain * left, level.phi, tilt_max),
    )


def sinking_setpoint(
    now: float, report: Telemetry | None, speed: AttitudeSpeed, tilt_max: float
) -> Setpoint:
    """Return the setpoint of a drone that sinks as level as it stands still; arguments as above."""
    braked = None if report is None else braking_setpoint(now, report, speed, tilt_max)
    level = speed.motion
    theta = braked.theta if braked else _limited(level.theta, tilt_max)
    phi = braked.phi if braked else _limited(level.phi, tilt_max)
    return Setpoint(theta, phi, -SINK_RATE, 0.0)


def _told(report: Telemetry) -> tuple[float, ...]:
    return report.theta, report.phi, report.psi, *report.velocity


def _velocity(now: float, report: Telemetry, speed: AttitudeSpeed) -> Vec2:
    """Return forward and left [m/s] by who is believed most."""
    measured = report.velocity[:2]
    # a flow camera that sees nothing reports zeros to the last bit
    sees = speed.motion.hovers and any(measured)
    return speed.velocity if speed.is_known(now) or not sees else measured


def _tilt(acceleration: float, level: float, tilt_max: float) -> float:
    return _limited(level + atan(acceleration / GRAVITY), tilt_max)


def _limited(tilt: float, tilt_max: float) -> float:
    return max(-tilt_max, min(tilt_max, tilt if isfinite(tilt) else 0.0))
