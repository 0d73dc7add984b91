"""Which of the eight words a component does not have, and why."""

from __future__ import annotations

from collections.abc import Mapping

from housefly.twin.faults.fault_types import FAULT_TYPES
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind

_C, _K = FaultComponent, FaultKind
_MOVING = "a load or a wind has no stream of values that could fail so; times start and end it"
_PRESENT = "what stands or walks there is no stream of values; times start and end it"
_INSIDE = "inside the drone it has no wire; what becomes of its values is a fault of the telemetry"
_REPORTED = "the charge comes with the reports: a fault of the telemetry"
_THRUST = "a motor has no stream of values: its thrust is less (`wrong`) or none (`off`)"

_MOTOR_WORDS = (_K.STUCK, _K.GARBAGE, _K.SLOW, _K.DELAYED, _K.INTERMITTENT)
_LATE_WORDS = (_K.SLOW, _K.DELAYED, _K.INTERMITTENT)
_ALL_BUT_WRONG = (_K.OFF, _K.STUCK, _K.GARBAGE, *_LATE_WORDS)

LEFT_OUT: Mapping[FaultComponent, Mapping[FaultKind, str]] = {
    _C.PILOT: {
        _K.WRONG: (
            "a sensible command that is not the pilot's cannot be told from one of the pilot;"
            " tracking that lies makes the pilot itself command what is wrong"
        )
    },
    _C.BATTERY: dict.fromkeys((_K.OFF, *_LATE_WORDS), _REPORTED),
    _C.MOTOR: dict.fromkeys(_MOTOR_WORDS, _THRUST),
    _C.SONAR: dict.fromkeys(_LATE_WORDS, _INSIDE),
    _C.FLOW: dict.fromkeys(_LATE_WORDS, _INSIDE),
    _C.IMU: dict.fromkeys((_K.OFF, *_LATE_WORDS), _INSIDE),
    _C.WIND: dict.fromkeys(_ALL_BUT_WRONG, _MOVING),
    _C.FAN: dict.fromkeys(_ALL_BUT_WRONG, _MOVING),
    _C.PAYLOAD: dict.fromkeys(_ALL_BUT_WRONG, _MOVING),
    _C.TETHER: dict.fromkeys(_ALL_BUT_WRONG, _MOVING),
    _C.PEOPLE: dict.fromkeys(_ALL_BUT_WRONG, _PRESENT),
    _C.OBSTACLES: dict.fromkeys(_ALL_BUT_WRONG, _PRESENT),
}
"""The reason for each word that a component does not have; ``ok`` all of them have."""


def fault_words(component: FaultComponent) -> tuple[FaultKind, ...]:
    """Return the words that a component has, in PX4's order; ``ok`` is the absence of all."""
    own = {known.kind for known in FAULT_TYPES if known.component is component}
    return tuple(kind for kind in FaultKind if kind is FaultKind.OK or kind in own)
