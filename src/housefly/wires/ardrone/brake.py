"""Bringing a drone to rest by its own report, when nobody else steers any more.

Pure. The drone's own hover brakes as well, but gently, and only where its flow camera sees enough:
a drone that reports no speed at all is braked by the speed that its attitude must have given it.
"""

from __future__ import annotations

from math import atan, cos, hypot, isfinite, sin

from housefly.geometry import GRAVITY, Vec2, wrap_angle
from housefly.messages import DroneStatus, Setpoint, Telemetry

BRAKE_GAIN = 4.0
"""Deceleration per speed [1/s]: twice that of the drone's own hover, and still well damped."""
BRAKE_LEAD = 0.2
"""The present attitude goes on accelerating for about this long: delay and attitude lag [s]."""
BRAKE_TIME_MAX = 0.8
"""Longest time before the drone's own hover takes over [s]."""
AT_REST_SPEED = 0.12
"""Slower than this, lead included, the drone's own hover holds better [m/s]."""
_SPEED_AGE_MAX = 0.15
"""An older report says nothing about the present speed [s]."""
_DRAG = 0.58
"""Linear drag over mass of the AR.Drone 2.0 [1/s]."""
_GAP_MAX = 0.3
"""After a longer gap between reports the speed from attitude starts anew [s]."""


class AttitudeSpeed:
    """The speed that the reported attitude must have given the drone, with linear drag.

    Attributes:
        velocity: forward and left [m/s].
    """

    def __init__(self) -> None:
        self.velocity: Vec2 = (0.0, 0.0)
        self._last: Telemetry | None = None

    def update(self, report: Telemetry) -> None:
        """Take in a report; one that was taken in before changes nothing."""
        last, self._last = self._last, report
        if last is None or report.status is not DroneStatus.FLYING:
            self.velocity = (0.0, 0.0)
            return
        dt = report.received_at - last.received_at
        is_known = all(map(isfinite, (report.theta, report.phi, report.psi, last.psi)))
        if not (is_known and 0.0 <= dt <= _GAP_MAX):
            self.velocity = (0.0, 0.0)
            return
        turned = wrap_angle(report.psi - last.psi)
        forward, left = self.velocity
        forward, left = (
            cos(turned) * forward + sin(turned) * left,
            cos(turned) * left - sin(turned) * forward,
        )
        self.velocity = (
            forward + dt * (GRAVITY * sin(report.theta) - _DRAG * forward),
            left + dt * (-GRAVITY * sin(report.phi) - _DRAG * left),
        )


def braking_setpoint(
    now: float, report: Telemetry, by_attitude: Vec2, tilt_max: float
) -> Setpoint | None:
    """Return the tilt that brings a flying drone to rest, or None when its own hover does.

    Args:
        now: [s].
        report: the newest.
        by_attitude: speed forward and left [m/s] where the report has none (``AttitudeSpeed``).
        tilt_max: largest tilt [rad].

    A report with numbers that are none leaves it to the drone's own hover.
    """
    is_known = all(map(isfinite, (report.theta, report.phi)))
    if not is_known or now - report.received_at > _SPEED_AGE_MAX:
        return None
    measured = report.velocity[:2]
    # a flow camera that sees nothing reports zeros to the last bit
    forward, left = measured if any(measured) else by_attitude
    forward += BRAKE_LEAD * GRAVITY * sin(report.theta)
    left -= BRAKE_LEAD * GRAVITY * sin(report.phi)
    speed = hypot(forward, left)
    if not isfinite(speed) or speed < AT_REST_SPEED:
        return None
    return Setpoint(theta=_tilt(-forward, tilt_max), phi=_tilt(left, tilt_max))


def _tilt(speed: float, tilt_max: float) -> float:
    return max(-tilt_max, min(tilt_max, atan(BRAKE_GAIN * speed / GRAVITY)))
