"""The one place where a Tello's signs and units are converted to ours and back.

Its angles are nose up, right side down and clockwise, its sticks right, ahead, up and clockwise.
Ours are forward, left, up (REP-103), radians and metres.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import degrees, isfinite, radians

from housefly.config.airframe import ResponseConstants
from housefly.geometry import wrap_angle
from housefly.messages import DroneFault, DroneStatus, Telemetry, VelocitySetpoint
from housefly.wires.tello.lines import STICK_MAX, Sticks
from housefly.wires.tello.state import TOF_MAX, TelloState

LOW_BATTERY = 10
"""Charge below which it complains, and takes off no more [%]."""
_TOF_MIN = 10
"""Nearer than this it says this [cm]."""


@dataclass(frozen=True, slots=True)
class FullSticks:
    """What full sticks mean: level speed and climb rate [m/s], yaw rate [rad/s]."""

    speed: float
    climb: float
    turn: float


def full_sticks_of(response: ResponseConstants) -> FullSticks:
    """Return what full sticks mean to a drone that is steered by velocity."""
    speed, climb, turn = response.speed_max, response.climb_max, response.turn_max
    assert speed is not None and climb is not None and turn is not None
    return FullSticks(speed, climb, turn)


def sticks_of(asked: VelocitySetpoint, full: FullSticks) -> Sticks:
    """Return the sticks of a velocity, each cut to the full one, or centred if not finite."""
    return Sticks(
        right=_stick(-asked.left, full.speed),
        ahead=_stick(asked.forward, full.speed),
        up=_stick(asked.vz, full.climb),
        clockwise=_stick(-asked.yaw_rate, full.turn),
    )


def velocity_of(sticks: Sticks, full: FullSticks) -> VelocitySetpoint:
    """Return the velocity that sticks ask for."""
    return VelocitySetpoint(
        forward=sticks.ahead / STICK_MAX * full.speed,
        left=-sticks.right / STICK_MAX * full.speed,
        vz=sticks.up / STICK_MAX * full.climb,
        yaw_rate=-sticks.clockwise / STICK_MAX * full.turn,
    )


def telemetry_of_state(state: TelloState, status: DroneStatus, received_at: float) -> Telemetry:
    """Return our telemetry of a state; what the drone is doing it does not say itself.

    Its distance of what is below is its height; where nothing comes back, its height over the
    take-off.
    """
    centimetres = state.tof if state.tof < TOF_MAX else max(0, state.h)
    return Telemetry(
        received_at=received_at,
        status=status,
        battery=state.bat / 100.0,
        phi=radians(state.roll),
        theta=-radians(state.pitch),
        psi=wrap_angle(-radians(state.yaw)),
        height=centimetres / 100.0,
        faults=(DroneFault.BATTERY_LOW,) if state.bat < LOW_BATTERY else (),
    )


def native_state(report: Telemetry, motor_time: float, climb: float) -> TelloState:
    """Return the state of a drone whose report is given in our signs; the twin's side.

    Args:
        report: as the drone measures it.
        motor_time: how long its motors have turned [s].
        climb: [m/s].
    """
    height = round(100.0 * report.height)
    return TelloState(
        pitch=-round(degrees(report.theta)),
        roll=round(degrees(report.phi)),
        yaw=-round(degrees(report.psi)),
        tof=max(_TOF_MIN, height),
        h=10 * round(height / 10.0),
        bat=max(0, min(100, round(100.0 * report.battery))),
        time=int(motor_time),
        templ=60,
        temph=62,
        vgz=-round(10.0 * climb),
    )


def _stick(value: float, full: float) -> int:
    if not isfinite(value):
        return 0
    return max(-STICK_MAX, min(STICK_MAX, round(STICK_MAX * value / full)))
