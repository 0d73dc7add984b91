"""The AT commands as values; ``at`` writes and reads them.

Facts: Parrot ARDroneLib SDK 2.0.1, at_msgs.h.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum, IntFlag


class RefBits(IntFlag):
    """The two bits of REF that mean something; no bit set means land."""

    LAND = 0
    EMERGENCY = 1 << 8
    TAKE_OFF = 1 << 9


class PcmdFlag(IntFlag):
    """Mode bits of PCMD; none set means hover, whatever the sticks say."""

    HOVER = 0
    PROGRESSIVE = 1
    COMBINED_YAW = 2
    ABSOLUTE = 4


class ControlMode(IntEnum):
    """Modes of CTRL that AR.Drone 2 clients use."""

    SEND_CONFIG = 4
    CLEAR_ACK = 5
    SEND_CUSTOM_CONFIGS = 6


@dataclass(frozen=True, slots=True)
class Ref:
    """Take-off, landing and the emergency toggle."""

    bits: RefBits = RefBits.LAND


@dataclass(frozen=True, slots=True)
class Pcmd:
    """Move; fractions -1..1 of the configured maxima in native signs.

    Positive roll flies right, positive pitch flies backward, positive gaz climbs, positive yaw
    turns clockwise. The parser does not clamp.
    """

    flags: PcmdFlag = PcmdFlag.HOVER
    roll: float = 0.0
    pitch: float = 0.0
    gaz: float = 0.0
    yaw: float = 0.0


@dataclass(frozen=True, slots=True)
class PcmdMag:
    """PCMD with the client's own heading and its accuracy, both -1..1."""

    flags: PcmdFlag = PcmdFlag.HOVER
    roll: float = 0.0
    pitch: float = 0.0
    gaz: float = 0.0
    yaw: float = 0.0
    psi: float = 0.0
    psi_accuracy: float = 0.0


@dataclass(frozen=True, slots=True)
class FlatTrim:
    """Take the present attitude as level; only on level ground."""


@dataclass(frozen=True, slots=True)
class Calibrate:
    """Calibrate a device in flight; 0 is the magnetometer."""

    device: int = 0


@dataclass(frozen=True, slots=True)
class Config:
    """Set one configuration key, ``section:name``."""

    key: str
    value: str


@dataclass(frozen=True, slots=True)
class ConfigIds:
    """Name session, user and application (8 hex digits each) that the next CONFIG belongs to."""

    session: str
    user: str
    application: str


@dataclass(frozen=True, slots=True)
class Control:
    """Ask for the configuration or clear the acknowledge bit; see ControlMode."""

    mode: int
    size: int = 0


@dataclass(frozen=True, slots=True)
class ComWatchdog:
    """Reset the communication watchdog."""


@dataclass(frozen=True, slots=True)
class Led:
    """Blink; the old form of the key ``leds:leds_anim``."""

    animation: int
    frequency_hz: float
    seconds: int


@dataclass(frozen=True, slots=True)
class Animation:
    """Flight animation; the old form of the key ``control:flight_anim``."""

    animation: int
    milliseconds: int


@dataclass(frozen=True, slots=True)
class Pmode:
    """Start-up mode that Parrot's client sends; meaning not published."""

    mode: int = 2


@dataclass(frozen=True, slots=True)
class Misc:
    """Start-up numbers that Parrot's client sends; meaning not published."""

    first: int = 2
    second: int = 20
    third: int = 2000
    fourth: int = 3000


@dataclass(frozen=True, slots=True)
class Other:
    """A command that we know by name only, with its arguments as written."""

    name: str
    arguments: tuple[str, ...] = ()


AtCommand = (
    Ref
    | Pcmd
    | PcmdMag
    | FlatTrim
    | Calibrate
    | Config
    | ConfigIds
    | Control
    | ComWatchdog
    | Led
    | Animation
    | Pmode
    | Misc
    | Other
)
