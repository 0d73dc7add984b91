"""What a ground station asks of a vehicle, as messages."""

from __future__ import annotations

from enum import IntEnum
from math import nan
from typing import Any

from housefly.wires.mavlink.dialect import dialect

GROUND_SYSTEM, GROUND_COMPONENT = 255, 190
"""Who we are: ArduPilot counts the heartbeats of ground station 255."""
_GROUND_STATION, _NO_AUTOPILOT, _ACTIVE, _VERSION = 6, 8, 4, 3
_FORCE = 21196.0
"""Cuts the motors in the air, too."""
_CUSTOM_MODE = 1.0
Target = tuple[int, int]
"""System and component."""


class CommandId(IntEnum):
    """Commands of COMMAND_LONG by their number."""

    LAND = 21
    TAKE_OFF = 22
    SET_MODE = 176
    ARM = 400
    REQUEST = 512
    SET_RATE = 511


class MessageId(IntEnum):
    """Messages that a ground station asks for, by their number."""

    HEARTBEAT = 0
    SYS_STATUS = 1
    ATTITUDE = 30
    GPS_GLOBAL_ORIGIN = 49
    LOCAL_POSITION_NED = 32
    EXTENDED_SYS_STATE = 245


def heartbeat() -> Any:
    """Return a ground station's sign of life."""
    return dialect().MAVLink_heartbeat_message(
        _GROUND_STATION, _NO_AUTOPILOT, 0, 0, _ACTIVE, _VERSION
    )


def command(target: Target, number: CommandId, *parameters: float) -> Any:
    """Return a command with up to seven parameters; those left out are zero."""
    filled = (*parameters, *(0.0 for _ in range(7 - len(parameters))))
    return dialect().MAVLink_command_long_message(*target, int(number), 0, *filled)


def arming(target: Target, arms: bool, by_force: bool = False) -> Any:
    """Return the order to arm or disarm, by force in the air, too."""
    return command(target, CommandId.ARM, float(arms), _FORCE if by_force else 0.0)


def mode_order(target: Target, main: int, sub: int = 0) -> Any:
    """Return the order to change the flight mode."""
    return command(target, CommandId.SET_MODE, _CUSTOM_MODE, float(main), float(sub))


def take_off_order(target: Target, height: float | None) -> Any:
    """Return the order to take off to a height [m], where it takes one; it keeps its heading."""
    altitude = nan if height is None else height
    return command(target, CommandId.TAKE_OFF, 0.0, 0.0, 0.0, nan, nan, nan, altitude)


def rate_order(target: Target, message: MessageId, rate_hz: float) -> Any:
    """Return the order to send a message so often [Hz]."""
    return command(target, CommandId.SET_RATE, float(message), 1e6 / rate_hz)


def message_request(target: Target, message: MessageId) -> Any:
    """Return the order to send a message once."""
    return command(target, CommandId.REQUEST, float(message))


def parameter_request(target: Target, name: str) -> Any:
    """Return the question for a parameter."""
    return dialect().MAVLink_param_request_read_message(*target, name.encode(), -1)


def origin_order(system: int, latitude: float, longitude: float, time: float) -> Any:
    """Return the order to take a place as the origin of the map; degrees, height zero [s]."""
    return dialect().MAVLink_set_gps_global_origin_message(
        system, int(1e7 * latitude), int(1e7 * longitude), 0, int(1e6 * time)
    )


def clock_answer(asked_ns: int, now: float) -> Any:
    """Return the answer to a vehicle that compares its clock with ours [s]."""
    return dialect().MAVLink_timesync_message(int(1e9 * now), asked_ns)
