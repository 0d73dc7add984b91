"""What a simulated autopilot tells, as messages by name."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, sin
from typing import Any

from housefly.twin.mavlink.vehicle import MavlinkVehicle
from housefly.wires.mavlink.dialect import dialect
from housefly.wires.mavlink.frames import across_attitude, across_body, across_world
from housefly.wires.mavlink.reports import SystemState

_QUADROTOR, _ARMED, _CUSTOM, _VERSION = 2, 128, 1, 3
_SENSORS = 0x0020_002F
"""Gyro, accelerometer, compass, pressure, vision, attitude estimate: present and healthy."""
_CAPABLE = 0b1110_1111_0010
_LATITUDE, _LONGITUDE = 45.0, 7.0
_METRES_PER_DEGREE = 111_320.0
_NO_HEADING = 65535


def heartbeat_of(vehicle: MavlinkVehicle) -> Any:
    """Return its sign of life: mode, and whether it is armed."""
    flies = vehicle.drone.onboard().flight.airborne
    state = SystemState.ACTIVE if vehicle.armed or flies else SystemState.STANDBY
    state = SystemState.CRITICAL if vehicle.is_failing else state
    base = _CUSTOM | (_ARMED if vehicle.armed else 0)
    return dialect().MAVLink_heartbeat_message(
        _QUADROTOR, vehicle.autopilot.number, base, vehicle.mode, int(state), _VERSION
    )


def attitude_of(vehicle: MavlinkVehicle) -> Any:
    """Return roll, pitch and heading, and how they change."""
    onboard = vehicle.onboard
    attitude = across_attitude((onboard.phi, onboard.theta, vehicle.heading))
    return dialect().MAVLink_attitude_message(
        _boot_ms(onboard.at), *attitude, *across_body(onboard.angular_rate)
    )


def landed_state_of(vehicle: MavlinkVehicle) -> Any:
    """Return whether it flies."""
    return dialect().MAVLink_extended_sys_state_message(0, int(vehicle.landed))


def system_of(vehicle: MavlinkVehicle) -> Any:
    """Return battery and sensors."""
    onboard = vehicle.onboard
    percent = max(0, min(100, round(100.0 * onboard.battery)))
    volts = max(0, min(65535, round(1000.0 * onboard.battery_voltage)))
    return dialect().MAVLink_sys_status_message(
        _SENSORS, _SENSORS, _SENSORS, 100, volts, -1, percent, 0, 0, 0, 0, 0, 0
    )


def local_position_of(vehicle: MavlinkVehicle) -> Any:
    """Return where it was told to be, and its own velocity."""
    onboard = vehicle.onboard
    forward, left, up = onboard.velocity
    c, s = cos(vehicle.heading), sin(vehicle.heading)
    velocity = across_world((c * forward - s * left, s * forward + c * left, up))
    place = across_world(vehicle.place or (0.0, 0.0, 0.0))
    return dialect().MAVLink_local_position_ned_message(_boot_ms(onboard.at), *place, *velocity)


def global_position_of(vehicle: MavlinkVehicle) -> Any:
    """Return the same on the globe, round the made-up origin."""
    x, y, z = vehicle.place or (0.0, 0.0, 0.0)
    latitude = _LATITUDE + y / _METRES_PER_DEGREE
    longitude = _LONGITUDE + x / (_METRES_PER_DEGREE * cos(0.7854))
    height = round(1000.0 * z)
    return dialect().MAVLink_global_position_int_message(
        _boot_ms(vehicle.drone.now),
        *(int(1e7 * latitude), int(1e7 * longitude), height, height),
        *(0, 0, 0, _NO_HEADING),
    )


def version_of(vehicle: MavlinkVehicle) -> Any:
    """Return who made it, and what it can."""
    nothing = [0] * 8
    return dialect().MAVLink_autopilot_version_message(
        _CAPABLE, 0x0401_0000, 0, 0, 0, nothing, nothing, nothing, 0, 0, 1
    )


def clock_question_of(vehicle: MavlinkVehicle) -> Any:
    """Return the question for a client's clock."""
    return dialect().MAVLink_timesync_message(0, int(1e9 * vehicle.drone.now))


TELLINGS: dict[int, Callable[[MavlinkVehicle], Any]] = {
    0: heartbeat_of,
    1: system_of,
    30: attitude_of,
    32: local_position_of,
    33: global_position_of,
    111: clock_question_of,
    148: version_of,
    245: landed_state_of,
}
"""By the number of the message."""
USUAL_RATES = {0: 1.0, 1: 1.0, 30: 4.0, 32: 4.0, 33: 4.0, 111: 1.0, 245: 2.0}
"""How often each is told where a client asked for nothing [Hz]."""


def _boot_ms(at: float) -> int:
    return round(1000.0 * at) % (1 << 32)
