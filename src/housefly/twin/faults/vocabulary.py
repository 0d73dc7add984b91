"""The words for faults: PX4's eight kinds, and the components that can have them.

The kinds are those of PX4's failure injection, so that who knows it finds the same words here.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class FaultKind(Enum):
    """How something fails."""

    OK = "ok"
    OFF = "off"
    STUCK = "stuck"
    GARBAGE = "garbage"
    WRONG = "wrong"
    SLOW = "slow"
    DELAYED = "delayed"
    INTERMITTENT = "intermittent"


class FaultComponent(Enum):
    """What fails."""

    MOCAP = "mocap"
    TELEMETRY = "telemetry"
    COMMANDS = "commands"
    PILOT = "pilot"
    VIDEO = "video"
    LASER = "laser"
    DEPTH = "depth"
    DEVICES = "devices"
    BATTERY = "battery"
    MOTOR = "motor"
    SONAR = "sonar"
    FLOW = "flow"
    IMU = "imu"
    WIND = "wind"
    FAN = "fan"
    PAYLOAD = "payload"
    TETHER = "tether"
    PEOPLE = "people"
    OBSTACLES = "obstacles"


class Injection(Enum):
    """Where a fault can be made."""

    LOCKSTEP = "lock step"
    WIRES = "wires"
    PROCESS = "a process is killed"
    USER = "a user does it"


LOCKSTEP, WIRES = frozenset({Injection.LOCKSTEP}), frozenset({Injection.WIRES})


@dataclass(frozen=True, slots=True)
class FaultType:
    """One way in which a component can fail.

    Attributes:
        component, aspect, kind: what, which side of it ("" for all of it), and how.
        words: what the fault does.
        unit: of its magnitude; "" for a fault without one, "1" for a share.
        default, low, high: magnitude when none is given, and its range.
        where: where it can be made.
    """

    component: FaultComponent
    aspect: str
    kind: FaultKind
    words: str
    unit: str = ""
    default: float = 0.0
    low: float = 0.0
    high: float = 0.0
    where: frozenset[Injection] = frozenset({Injection.LOCKSTEP, Injection.WIRES})

    @property
    def name(self) -> str:
        """Return how it is written: ``mocap.yaw:wrong``."""
        part = f".{self.aspect}" if self.aspect else ""
        return f"{self.component.value}{part}:{self.kind.value}"
