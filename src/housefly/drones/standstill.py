"""How a drone whose pilot is silent is brought to rest and down, by the form of its setpoints.

Tilt is leant against the speed that is known (``brake``). A drone that flies velocities is asked
for none, one that flies to places for the last that it was asked for: it comes to rest by itself.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Protocol

from housefly.drones.brake import SINK_RATE, AttitudeSpeed, braking_setpoint, sinking_setpoint
from housefly.messages import (
    AnySetpoint,
    PositionSetpoint,
    SetpointForm,
    Telemetry,
    VelocitySetpoint,
)


class Standstill(Protocol):
    """Setpoints of a drone that nobody steers."""

    def ask(self, asked: AnySetpoint) -> None:
        """Take in what the pilot asked for."""
        ...

    def braking(self, now: float, report: Telemetry, tilt_max: float) -> AnySetpoint | None:
        """Return what brings a flying drone to rest, or None once it is, or nothing is known.

        Args:
            now: [s].
            report: the newest.
            tilt_max: largest tilt [rad].
        """
        ...

    def sinking(
        self, now: float, sunk_for: float, report: Telemetry | None, tilt_max: float
    ) -> AnySetpoint | None:
        """Return what lets it sink in its place, or None where only its own landing is left.

        Args:
            now: [s].
            sunk_for: how long it has sunk already [s].
            report: the newest, if there is one.
            tilt_max: largest tilt [rad].
        """
        ...


@dataclass(frozen=True, slots=True)
class TiltStandstill:
    """Leans against the speed that is known."""

    speed: AttitudeSpeed

    def ask(self, asked: AnySetpoint) -> None:
        """Nothing is kept: the speed is asked for it."""

    def braking(self, now: float, report: Telemetry, tilt_max: float) -> AnySetpoint | None:
        """Return the tilt against the present speed."""
        return braking_setpoint(now, report, self.speed, tilt_max)

    def sinking(
        self, now: float, sunk_for: float, report: Telemetry | None, tilt_max: float
    ) -> AnySetpoint | None:
        """Return the tilt against the present speed, and a slow descent."""
        return sinking_setpoint(now, report, self.speed, tilt_max)


@dataclass(frozen=True, slots=True)
class VelocityStandstill:
    """Asks for no velocity."""

    def ask(self, asked: AnySetpoint) -> None:
        """Nothing is kept."""

    def braking(self, now: float, report: Telemetry, tilt_max: float) -> AnySetpoint | None:
        """Return a velocity of zero."""
        return VelocitySetpoint()

    def sinking(
        self, now: float, sunk_for: float, report: Telemetry | None, tilt_max: float
    ) -> AnySetpoint | None:
        """Return a slow descent."""
        return VelocitySetpoint(vz=-SINK_RATE)


class PositionStandstill:
    """Asks for the last place again: it was near, and inside the room."""

    def __init__(self) -> None:
        self._place: PositionSetpoint | None = None

    def ask(self, asked: AnySetpoint) -> None:
        """Keep the place."""
        if isinstance(asked, PositionSetpoint):
            self._place = replace(asked, yaw_rate=0.0)

    def braking(self, now: float, report: Telemetry, tilt_max: float) -> AnySetpoint | None:
        """Return the last place."""
        return self._place

    def sinking(
        self, now: float, sunk_for: float, report: Telemetry | None, tilt_max: float
    ) -> AnySetpoint | None:
        """Return the last place, lower and lower."""
        place = self._place
        return None if place is None else replace(place, z=place.z - SINK_RATE * sunk_for)


def standstill_of(form: SetpointForm, speed: AttitudeSpeed) -> Standstill:
    """Return how a drone of a form is brought to rest; its speed counts where it leans."""
    if form is SetpointForm.VELOCITY:
        return VelocityStandstill()
    if form is SetpointForm.POSITION:
        return PositionStandstill()
    return TiltStandstill(speed)
