"""What a Betaflight tells of itself: state, attitude, battery, channels. Payloads and back."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from math import degrees, pi, radians

from housefly.errors import WireError
from housefly.geometry import wrap_angle
from housefly.wires.betaflight.arming import NOTHING, ArmingFlag, flags_of
from housefly.wires.betaflight.commands import Msp
from housefly.wires.betaflight.payloads import Fields, packed

CHANNEL_MAX = 2500
"""No channel is longer [us]."""
CHANNELS_MAX = 18
_CELL_VOLTS = (3.3, 3.5, 3.68, 3.8, 3.95, 4.2)
_CELL_CHARGE = (0.0, 0.1, 0.3, 0.5, 0.75, 1.0)
"""Charge by the voltage of a cell at rest: the curve of any lithium polymer battery, in short."""


@dataclass(frozen=True, slots=True)
class FcStatus:
    """STATUS_EX.

    Attributes:
        boxes: bit n says that the n-th of BOXIDS is active.
        arming: what keeps it from arming.
        load: of its processor [%].
    """

    boxes: int = 0
    arming: ArmingFlag = NOTHING
    load: int = 0


@dataclass(frozen=True, slots=True)
class FcAttitude:
    """ATTITUDE, in our signs [rad]: its heading counts clockwise from where it was switched on."""

    phi: float
    theta: float
    psi: float


@dataclass(frozen=True, slots=True)
class FcBattery:
    """BATTERY_STATE.

    Attributes:
        cells: 0 where it found none.
        voltage: [V].
        is_low: it warns, or worse.
    """

    cells: int
    voltage: float
    is_low: bool = False

    @property
    def charge(self) -> float:
        """Charge by the voltage of a cell, 0 to 1; 0 where there is no battery."""
        return charge_of(self.voltage / self.cells) if self.cells else 0.0


def charge_of(cell_voltage: float) -> float:
    """Return the charge of a cell by its voltage [V], 0 to 1."""
    return _interpolated(cell_voltage, _CELL_VOLTS, _CELL_CHARGE)


def cell_voltage_of(charge: float) -> float:
    """Return the voltage of a cell [V] by its charge, 0 to 1."""
    return _interpolated(charge, _CELL_CHARGE, _CELL_VOLTS)


def _interpolated(x: float, xs: tuple[float, ...], ys: tuple[float, ...]) -> float:
    if not xs[0] < x < xs[-1]:
        return ys[0] if x <= xs[0] else ys[-1]
    knot = bisect_right(xs, x) - 1
    share = (x - xs[knot]) / (xs[knot + 1] - xs[knot])
    return ys[knot] + share * (ys[knot + 1] - ys[knot])


def read_status(payload: bytes) -> FcStatus:
    """Return the state in STATUS_EX.

    Raises:
        WireError: it is too short, or counts more boxes or flags than there can be.
    """
    fields = Fields(Msp.STATUS_EX, payload)
    fields.skip("cycle time, errors, sensors", 6)
    boxes = fields.unsigned("boxes", 4)
    fields.skip("profile", 1)
    load = fields.unsigned("load", 2)
    fields.skip("profiles", 2)
    more = fields.unsigned("more boxes", 1) & 0x0F
    boxes |= fields.unsigned("boxes", more) << 32
    count = fields.unsigned("arming flag count", 1, 32)
    return FcStatus(boxes, flags_of(fields.unsigned("arming flags", 4), count), load)


def encode_status(status: FcStatus) -> bytes:
    """Return STATUS_EX, as firmware of API 1.46 writes it."""
    low, high = status.boxes & 0xFFFFFFFF, status.boxes >> 32
    more = (high.bit_length() + 7) // 8
    return packed(
        *((125, 2), (0, 2), (0b100001, 2), (low, 4), (0, 1), (status.load, 2), (4, 1), (0, 1)),
        *((more, 1), (high, more), (30, 1), (int(status.arming), 4), (0, 1), (40, 2), (4, 1)),
    )


def read_attitude(payload: bytes) -> FcAttitude:
    """Return how it leans and where it heads; raises WireError for angles that are none."""
    fields = Fields(Msp.ATTITUDE, payload)
    roll = fields.signed("roll [0.1 degree]", 2, 1800)
    pitch = fields.signed("pitch [0.1 degree]", 2, 900)
    yaw = fields.signed("yaw [degree]", 2, 360)
    return FcAttitude(radians(roll / 10), radians(pitch / 10), wrap_angle(-radians(yaw)))


def encode_attitude(attitude: FcAttitude) -> bytes:
    """Return ATTITUDE: tenths of a degree, and whole degrees of heading."""
    return packed(
        (round(degrees(attitude.phi) * 10), 2),
        (round(degrees(attitude.theta) * 10), 2),
        (round(degrees(-attitude.psi % (2.0 * pi))), 2),
    )


def read_battery(payload: bytes) -> FcBattery:
    """Return its battery; raises WireError for one that cannot be."""
    fields = Fields(Msp.BATTERY_STATE, payload)
    cells = fields.unsigned("cells", 1, 16)
    fields.skip("capacity, voltage, used, current", 7)
    state = fields.unsigned("state", 1, 4)
    voltage = fields.unsigned("voltage [0.01 V]", 2, 7000) / 100
    return FcBattery(cells, voltage, state in (1, 2))


def encode_battery(battery: FcBattery) -> bytes:
    """Return BATTERY_STATE."""
    hundredths = round(battery.voltage * 100)
    return packed(
        *((battery.cells, 1), (1300, 2), (min(hundredths // 10, 255), 1), (0, 2), (0, 2)),
        *((1 if battery.is_low else 0, 1), (hundredths, 2)),
    )


def read_channels(command: Msp, payload: bytes) -> tuple[int, ...]:
    """Return the channels [us] of RC, or of SET_RAW_RC.

    Raises:
        WireError: too many, half a channel, or one that cannot be.
    """
    count, rest = divmod(len(payload), 2)
    if rest or count > CHANNELS_MAX:
        raise WireError(
            f"{command.name} has {len(payload)} bytes; allowed: 2 for each of {CHANNELS_MAX}"
            " channels at most"
        )
    return Fields(command, payload).several("channel [us]", 2, count, CHANNEL_MAX)


def encode_channels(channels: tuple[int, ...]) -> bytes:
    """Return channels [us] as RC and SET_RAW_RC carry them; raises WireError as above."""
    if len(channels) > CHANNELS_MAX or not all(0 <= one <= CHANNEL_MAX for one in channels):
        raise WireError(
            f"channels {channels}; allowed: {CHANNELS_MAX} at most, 0 to {CHANNEL_MAX} us"
        )
    return packed(*((one, 2) for one in channels))


def read_firmware(payload: bytes) -> str:
    """Return the version in FC_VERSION; newer firmware counts years since 2000, and names it."""
    fields = Fields(Msp.FC_VERSION, payload)
    year, month, patch = fields.several("number", 1, 3)
    if fields.left:
        length = fields.unsigned("name length", 1, fields.left - 1)
        name = payload[4 : 4 + length].decode("ascii", "replace")
        if name.isprintable() and name:
            return name
    return f"{year}.{month}.{patch}"
