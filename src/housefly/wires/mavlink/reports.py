"""What a vehicle tells, checked: its messages to values."""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from math import isfinite
from typing import Any, TypeVar

from housefly.errors import WireError
from housefly.geometry import Vec3
from housefly.wires.mavlink.frames import across_attitude
from housefly.wires.mavlink.framing import finite

_ARMED, _CUSTOM_MODE = 128, 1
_Kind = TypeVar("_Kind", bound=IntEnum)


class Landed(IntEnum):
    """MAV_LANDED_STATE."""

    UNKNOWN = 0
    ON_GROUND = 1
    IN_AIR = 2
    TAKING_OFF = 3
    LANDING = 4


class SystemState(IntEnum):
    """MAV_STATE."""

    UNKNOWN = 0
    BOOT = 1
    CALIBRATING = 2
    STANDBY = 3
    ACTIVE = 4
    CRITICAL = 5
    EMERGENCY = 6
    POWEROFF = 7
    TERMINATED = 8


class Result(IntEnum):
    """MAV_RESULT."""

    ACCEPTED = 0
    TEMPORARILY_REJECTED = 1
    DENIED = 2
    UNSUPPORTED = 3
    FAILED = 4
    IN_PROGRESS = 5
    CANCELLED = 6


@dataclass(frozen=True, slots=True)
class Heartbeat:
    """HEARTBEAT of an autopilot.

    Attributes:
        autopilot: which (MAV_AUTOPILOT).
        mode: its custom mode.
        armed: whether its motors may turn.
        state: of the system.
    """

    autopilot: int
    mode: int
    armed: bool
    state: SystemState


@dataclass(frozen=True, slots=True)
class AttitudeReport:
    """ATTITUDE: roll, pitch and heading in our signs [rad], and the vehicle's clock [s]."""

    attitude: Vec3
    time: float


@dataclass(frozen=True, slots=True)
class LandedReport:
    """EXTENDED_SYS_STATE: whether it flies."""

    landed: Landed


@dataclass(frozen=True, slots=True)
class ChargeReport:
    """SYS_STATUS: charge 0 to 1, None where it is not measured."""

    charge: float | None


@dataclass(frozen=True, slots=True)
class Answer:
    """COMMAND_ACK: what became of a command."""

    command: int
    result: Result


@dataclass(frozen=True, slots=True)
class Said:
    """STATUSTEXT: a line for people, 0 the gravest; long ones come in numbered pieces."""

    severity: int
    text: str
    series: int = 0
    piece: int = 0


@dataclass(frozen=True, slots=True)
class ParameterReport:
    """PARAM_VALUE; a number that is not real has its value in the bits, or plainly."""

    name: str
    value: float
    by_bits: float


@dataclass(frozen=True, slots=True)
class OriginReport:
    """GPS_GLOBAL_ORIGIN: the map has an origin."""


@dataclass(frozen=True, slots=True)
class ClockQuestion:
    """TIMESYNC: the vehicle asks for our clock."""

    asked_ns: int


VehicleReport = (
    Heartbeat
    | AttitudeReport
    | LandedReport
    | ChargeReport
    | Answer
    | Said
    | ParameterReport
    | OriginReport
    | ClockQuestion
)


def report_in(message: Any) -> VehicleReport | None:
    """Return what a message tells, None for one that we do not read; raises WireError."""
    read = _READ.get(message.get_type())
    return read(message) if read else None


def _heartbeat(message: Any) -> Heartbeat | None:
    if message.autopilot == 8:  # a camera, or another ground station
        return None
    mode = message.custom_mode if message.base_mode & _CUSTOM_MODE else -1
    state = _member(message, "system_status", SystemState)
    return Heartbeat(message.autopilot, mode, bool(message.base_mode & _ARMED), state)


def _attitude(message: Any) -> AttitudeReport:
    roll, pitch, heading = finite(message, "roll", "pitch", "yaw")
    return AttitudeReport(across_attitude((roll, pitch, heading)), message.time_boot_ms / 1000.0)


def _landed(message: Any) -> LandedReport:
    return LandedReport(_member(message, "landed_state", Landed))


def _charge(message: Any) -> ChargeReport:
    percent = message.battery_remaining
    return ChargeReport(None if percent < 0 else min(percent, 100) / 100.0)


def _answer(message: Any) -> Answer:
    return Answer(message.command, _member(message, "result", Result))


def _said(message: Any) -> Said:
    text = "".join(mark for mark in _plain(message.text) if mark.isprintable())
    return Said(message.severity, text, message.id, message.chunk_seq)


def _parameter(message: Any) -> ParameterReport:
    value = message.param_value
    bits = struct.unpack("<i", struct.pack("<f", value))[0] if value == value else 0
    is_real = message.param_type in (9, 10)
    if is_real and not isfinite(value):
        raise WireError(f"PARAM_VALUE.param_value is {value}; allowed: a finite number")
    return ParameterReport(_plain(message.param_id), value, value if is_real else float(bits))


def _origin(message: Any) -> OriginReport:
    return OriginReport()


def _clock(message: Any) -> ClockQuestion | None:
    return ClockQuestion(message.ts1) if message.tc1 == 0 else None


_READ: dict[str, Callable[[Any], VehicleReport | None]] = {
    "HEARTBEAT": _heartbeat,
    "ATTITUDE": _attitude,
    "EXTENDED_SYS_STATE": _landed,
    "SYS_STATUS": _charge,
    "COMMAND_ACK": _answer,
    "STATUSTEXT": _said,
    "PARAM_VALUE": _parameter,
    "GPS_GLOBAL_ORIGIN": _origin,
    "TIMESYNC": _clock,
}


def _member(message: Any, field: str, kind: type[_Kind]) -> _Kind:
    number = getattr(message, field)
    try:
        return kind(number)
    except ValueError as error:
        allowed = f"0 to {max(kind)}"
        raise WireError(f"{message.get_type()}.{field} is {number}; allowed: {allowed}") from error


def _plain(text: str | bytes) -> str:
    whole = text.decode(errors="replace") if isinstance(text, bytes) else text
    return whole.partition("\0")[0]
