"""Flies the drone by its own motion: the law for a place that flow and gyros tell."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.geometry import Vec2, Vec3
from housefly.messages.steering import Setpoint
from housefly.pilot.control.laws import saturated_jointly, tilt

STIFFNESS, DAMPING = 1.0, 2.0
"""Of the place [1/s^2, 1/s]: flow, command and tilt are a third of a second late together."""
INTEGRAL = 0.4
"""Of the place [1/s^3]: draughts, and an attitude that is off."""
NEAR = 0.25
"""Farther off than this nothing more is learned of them [m]."""
PUSH_MAX = 0.8
"""No steady push counts as more than this [m/s^2]."""
TILT_MAX = 0.12
"""It leans no more than this [rad]."""
CLIMB_GAIN, CLIMB_MAX = 0.8, 0.3
"""Of the height [1/s], and the fastest climb [m/s]."""
CLIMB_MIN = 0.02
"""A drone told to climb at less keeps its height above whatever its sonar meets [m/s]."""
_STEP_MAX = 0.1


@dataclass(frozen=True, slots=True)
class FlowHold:
    """What is learned of a steady push while a place is held.

    Attributes:
        now: of the last step [s].
        push: acceleration that holds against it [m/s^2].
    """

    now: float
    push: Vec2 = (0.0, 0.0)

    def pushed(self, error: Vec2, now: float) -> FlowHold:
        """Return what is learned after another look at how far off the place is [m], now [s]."""
        dt = min(max(now - self.now, 0.0), _STEP_MAX)
        x, y = (
            min(max(push + INTEGRAL * dt * min(max(off, -NEAR), NEAR), -PUSH_MAX), PUSH_MAX)
            for push, off in zip(self.push, error, strict=True)
        )
        return FlowHold(now, (x, y))

    def setpoint(
        self,
        error: Vec2,
        error_rate: Vec2,
        lead: Vec2,
        climb: float,
        yaw: float,
        gain: float,
        tilt_max: float,
    ) -> Setpoint:
        """Return what to ask of the inner loops.

        Args:
            error: place wanted, minus the drone's own [m].
            error_rate: the same of the velocity [m/s].
            lead: acceleration against what holds back a drone at the wanted velocity [m/s^2].
            climb: to ask for [m/s].
            yaw: heading [rad].
            gain: c / lambda of the drone.
            tilt_max: limit of the command [rad].
        """
        ax, ay = (
            STIFFNESS * off + DAMPING * rate + ahead + push
            for off, rate, ahead, push in zip(error, error_rate, lead, self.push, strict=True)
        )
        theta, phi = saturated_jointly(*tilt(ax, ay, yaw, gain), min(TILT_MAX, tilt_max))
        return Setpoint(theta, phi, climb, 0.0)


def climb_to(height: float, position: Vec3, may_sink: bool) -> float:
    """Return the climb rate for a height [m/s]; never zero, at which its sonar would lead.

    Args:
        height: wanted [m].
        position: of the drone [m].
        may_sink: nothing stands below.
    """
    off = height - position[2]
    climb = min(max(CLIMB_GAIN * off, -CLIMB_MAX), CLIMB_MAX)
    if abs(climb) < CLIMB_MIN or (climb < 0.0 and not may_sink):
        return CLIMB_MIN if off > 0.0 else -CLIMB_MIN
    return climb
