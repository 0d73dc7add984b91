"""A simulated drone that takes our commands as they are, and reports as its model measures.

For lock step, and for the servers of drones that speak a wire of their own.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import inf, isfinite

from housefly.config.airframe import Ability, Airframe, airframe_named
from housefly.messages import (
    Action,
    Command,
    DroneFault,
    DroneStatus,
    Pose,
    Setpoint,
    Telemetry,
)
from housefly.messages.stick import Maxima, Stick, stick_from_setpoint
from housefly.twin.contracts import FlightState, OnboardLimits, OnboardState, TwinDrone

FLIGHT_STATUS: dict[FlightState, DroneStatus] = {
    FlightState.LANDED: DroneStatus.LANDED,
    FlightState.TAKING_OFF: DroneStatus.TAKING_OFF,
    FlightState.FLYING: DroneStatus.FLYING,
    FlightState.HOVERING: DroneStatus.FLYING,
    FlightState.LANDING: DroneStatus.LANDING,
    FlightState.EMERGENCY: DroneStatus.EMERGENCY,
}

_FAULTS: tuple[tuple[DroneFault, Callable[[OnboardState], bool]], ...] = (
    (DroneFault.MOTORS_PROBLEM, lambda onboard: onboard.motors_problem),
    (DroneFault.BATTERY_LOW, lambda onboard: onboard.low_battery),
    (DroneFault.TILTED_TOO_FAR, lambda onboard: onboard.angles_out_of_range),
    (DroneFault.COMMANDS_LOST, lambda onboard: onboard.com_lost),
    (DroneFault.ULTRASOUND_DEAF, lambda onboard: onboard.ultrasound_deaf),
)


class PlainDrone:
    """One drone without bytes.

    Args:
        drone: what flies.
        model: its model; gives what it measures, and how long a silence it bears.
    """

    def __init__(self, drone: TwinDrone, model: str) -> None:
        self._drone, self._airframe = drone, airframe_named(model)
        limits = within(
            OnboardLimits(silence=self._airframe.capabilities.silence.after), self._airframe
        )
        drone.set_limits(limits)
        self._obedience = Obedience(Maxima(limits.tilt, limits.climb, limits.yaw_rate))

    @property
    def airframe(self) -> Airframe:
        """Of its model."""
        return self._airframe

    def obey(self, command: Command) -> None:
        """Obey a command, and count it as a sign of life."""
        self._drone.keep_alive()
        self._obedience.obey(self._drone, command)

    def tell_pose(self, pose: Pose, age: float) -> None:
        """Tell the drone where it was so long ago [s]."""
        self._drone.tell_pose(pose, self._drone.now - age)

    def report(self) -> Telemetry:
        """Return what it reports now; its time is the drone's own [s]."""
        return as_measured(telemetry_of(self._drone.onboard()), self._airframe.lacks)


def within(limits: OnboardLimits, airframe: Airframe) -> OnboardLimits:
    """Return limits with no more in them than a model can do."""
    response = airframe.response
    return replace(
        limits,
        climb=min(limits.climb, response.climb_max or inf),
        yaw_rate=min(limits.yaw_rate, response.turn_max or inf),
    )


class Obedience:
    """Lets a drone obey commands; cutting the motors and ending an emergency are one button.

    Args:
        maxima: what a full stick means to it.
    """

    def __init__(self, maxima: Maxima) -> None:
        self._maxima, self._was_pressed = maxima, False

    def obey(self, drone: TwinDrone, command: Command) -> None:
        """Obey one command."""
        is_pressed = command.action in (Action.CUT, Action.RESET)
        if is_pressed and not self._was_pressed:
            drone.toggle_emergency()
        self._was_pressed = is_pressed
        match command.action, command.asked:
            case Action.TAKE_OFF, _:
                drone.request_take_off()
            case ((Action.LAND | Action.IDLE), _):
                drone.request_land()
            case Action.HOVER, _:
                drone.set_stick(Stick())
            case Action.FLY, Setpoint() as tilted:
                drone.set_stick(stick_from_setpoint(tilted, self._maxima))
            case Action.FLY, asked:
                drone.steer(asked)


def telemetry_of(onboard: OnboardState, received_at: float | None = None) -> Telemetry:
    """Return a report of the drone as the driver would understand it.

    Args:
        onboard: what it reports.
        received_at: when the report arrives [s]; at once where it is not given.
    """
    forward, left, _ = onboard.velocity
    return Telemetry(
        received_at=onboard.at if received_at is None else received_at,
        status=FLIGHT_STATUS[onboard.flight],
        battery=_in_percent(onboard.battery),
        phi=onboard.phi,
        theta=onboard.theta,
        psi=onboard.psi,
        height=onboard.height,
        velocity=(forward, left, 0.0),
        faults=tuple(fault for fault, applies in _FAULTS if applies(onboard)),
        acceleration=onboard.acceleration,
        drone_time=onboard.at,
        hears_us=not (onboard.com_watchdog or onboard.com_lost),
    )


def as_measured(report: Telemetry, lacks: frozenset[Ability]) -> Telemetry:
    """Return a report without what the drone does not measure."""
    if not lacks & {Ability.ATTITUDE, Ability.HEIGHT, Ability.VELOCITY}:
        return report
    if Ability.ATTITUDE in lacks:
        report = replace(report, phi=0.0, theta=0.0, psi=0.0, acceleration=None)
    if Ability.HEIGHT in lacks:
        report = replace(report, height=0.0)
    return replace(report, velocity=(0.0, 0.0, 0.0)) if Ability.VELOCITY in lacks else report


def _in_percent(charge: float) -> float:
    return round(charge * 100) / 100 if isfinite(charge) else charge
