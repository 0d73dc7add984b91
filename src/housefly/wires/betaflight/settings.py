"""How a flight controller is set: payloads that are read once, and back.

Source: betaflight/betaflight, src/main/msp/msp.c (MSP API 1.49). What older firmware leaves out at
the end keeps its default.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum

from housefly.errors import WireError
from housefly.wires.betaflight.commands import Msp
from housefly.wires.betaflight.payloads import Fields, packed

MODE_RANGES_MAX = 60
FEATURE_RX_MSP = 1 << 14
"""Bit of FEATURE_CONFIG: all channels come from MSP, no radio is needed."""
_STEP_MICROSECONDS, _STEP_BEGIN = 25, 900
_STEPS_MAX = 48


class Box(IntEnum):
    """Modes that a switch may turn on, by their permanent numbers (msp/msp_box.c)."""

    ARM = 0
    ANGLE = 1
    HORIZON = 2
    ALT_HOLD = 3
    HEADFREE = 6
    POS_HOLD = 11
    PASSTHRU = 12
    FAILSAFE = 27
    CRASH_FLIP = 35
    PREARM = 36
    PARALYZE = 45
    GPS_RESCUE = 46
    ACRO_TRAINER = 47
    LAUNCH_CONTROL = 49
    MSP_OVERRIDE = 50
    AUTOPILOT = 56


@dataclass(frozen=True, slots=True)
class ModeRange:
    """A mode is on while a switch stands between two positions.

    Attributes:
        box: permanent number of the mode.
        switch: 0 is the first channel behind the four sticks.
        low, high: from here on, and up to here, which is out [us].
    """

    box: int
    switch: int
    low: int
    high: int

    def holds(self, position: int) -> bool:
        """Return whether the mode is on at a position of the switch [us]."""
        return self.low <= position < self.high


class RatesType(IntEnum):
    """How three numbers become a curve from stick to turn rate."""

    BETAFLIGHT = 0
    RACEFLIGHT = 1
    KISS = 2
    ACTUAL = 3
    QUICK = 4


@dataclass(frozen=True, slots=True)
class AxisRates:
    """The three numbers of one axis, as they are set: 0 to 255."""

    rc_rate: int = 7
    rate: int = 67
    expo: int = 0


@dataclass(frozen=True, slots=True)
class RcTuning:
    """RC_TUNING.

    Attributes:
        kind: which curve.
        roll, pitch, yaw: its numbers.
        throttle_mid, throttle_expo, throttle_hover: bend of the throttle [%].
        throttle_limit: largest throttle [%]; 100 where it is not limited.
    """

    kind: RatesType = RatesType.ACTUAL
    roll: AxisRates = AxisRates()
    pitch: AxisRates = AxisRates()
    yaw: AxisRates = AxisRates()
    throttle_mid: int = 50
    throttle_expo: int = 0
    throttle_hover: int = 50
    throttle_limit: int = 100

    @property
    def throttle_is_straight(self) -> bool:
        """Whether throttle goes to the motors as it comes."""
        is_bent = self.throttle_expo or self.throttle_hover != self.throttle_mid
        return not is_bent and self.throttle_limit == 100


class FailsafeProcedure(IntEnum):
    """What it does once sticks have stayed away for long."""

    AUTO_LAND = 0
    DROP = 1
    GPS_RESCUE = 2


@dataclass(frozen=True, slots=True)
class FailsafeSettings:
    """FAILSAFE_CONFIG.

    Attributes:
        delay: silence that it bears [s].
        landing_time: how long an automatic landing may last [s].
        throttle: of an automatic landing [us].
        procedure: what it does then.
    """

    delay: float = 1.5
    landing_time: float = 60.0
    throttle: int = 1000
    procedure: FailsafeProcedure = FailsafeProcedure.DROP


class SilentChannel(IntEnum):
    """What a channel says from 0.3 s of silence on, until the failsafe."""

    AUTO = 0
    HOLD = 1
    SET = 2


@dataclass(frozen=True, slots=True)
class FcSettings:
    """Everything that is read before a flight; defaults are the firmware's own.

    Attributes:
        boxes: permanent numbers of the modes whose bits STATUS_EX tells, in its order.
        ranges: switches.
        tuning: curves.
        angle_limit: lean of full sticks in ANGLE mode [degree].
        deadband, yaw_deadband: around the middle [us].
        features: bits.
        order: which channel of SET_RAW_RC is roll, pitch, yaw and throttle.
        middle, throttle_low: middle of a stick, and what counts as no throttle [us].
        failsafe: what it does in silence.
        silent: of each channel, roll first, in silence: what, and which value [us].
        motor_idle: share of full throttle at which motors turn that are told nothing.
    """

    boxes: tuple[int, ...] = ()
    ranges: tuple[ModeRange, ...] = ()
    tuning: RcTuning = RcTuning()
    angle_limit: int = 60
    deadband: int = 0
    yaw_deadband: int = 0
    features: int = 0
    order: tuple[int, int, int, int] = (0, 1, 3, 2)
    middle: int = 1500
    throttle_low: int = 1050
    failsafe: FailsafeSettings = FailsafeSettings()
    silent: tuple[tuple[SilentChannel, int], ...] = field(
        default=((SilentChannel.AUTO, 1500),) * 4 + ((SilentChannel.HOLD, 1500),) * 14
    )
    motor_idle: float = 0.055

    @property
    def receiver_is_msp(self) -> bool:
        """Whether all channels come from MSP."""
        return bool(self.features & FEATURE_RX_MSP)


def read_mode_ranges(payload: bytes) -> tuple[ModeRange, ...]:
    """Return the switches of MODE_RANGES; empty ones are left out.

    Raises:
        WireError: half a range, too many, or one beyond the end of a switch.
    """
    fields = Fields(Msp.MODE_RANGES, payload)
    ranges: list[ModeRange] = []
    for number in range(MODE_RANGES_MAX):
        if not fields.left:
            break
        box = fields.unsigned(f"mode[{number}]", 1)
        switch = fields.unsigned(f"switch[{number}]", 1, 32)
        low, high = fields.several(f"range[{number}]", 1, 2, _STEPS_MAX)
        if low < high:
            ranges.append(ModeRange(box, switch, _microseconds(low), _microseconds(high)))
    return tuple(ranges)


def encode_mode_ranges(ranges: tuple[ModeRange, ...]) -> bytes:
    """Return MODE_RANGES with twenty ranges, empty ones behind."""
    rows = [
        ((one.box, 1), (one.switch, 1), (_steps(one.low), 1), (_steps(one.high), 1))
        for one in ranges
    ]
    rows += [((0, 1), (0, 1), (0, 1), (0, 1))] * (20 - len(rows))
    return packed(*(number for row in rows for number in row))


def _microseconds(step: int) -> int:
    return _STEP_BEGIN + _STEP_MICROSECONDS * step


def _steps(position: int) -> int:
    return (position - _STEP_BEGIN) // _STEP_MICROSECONDS


def read_tuning(payload: bytes) -> RcTuning:
    """Return the curves of RC_TUNING; raises WireError for a kind of rates that is none."""
    fields = Fields(Msp.RC_TUNING, payload)
    rc_rate, expo, roll, pitch, yaw = fields.several("roll rates", 1, 5)
    fields.skip("TPA", 1)
    middle, throttle_expo = fields.several("throttle curve [%]", 1, 2, 100)
    fields.skip("TPA breakpoint", 2)
    yaw_expo, yaw_rc_rate, pitch_rc_rate, pitch_expo = fields.several("rates", 1, 4)
    limit_kind, limit = 0, 100
    if fields.left >= 2:
        limit_kind = fields.unsigned("throttle limit kind", 1, 2)
        limit = fields.unsigned("throttle limit [%]", 1, 100)
    kind, hover = RatesType.BETAFLIGHT, middle
    if fields.left >= 7:
        fields.skip("rate limits", 6)
        kind = RatesType(fields.unsigned("rates kind", 1, max(RatesType)))
    if fields.left:
        hover = fields.unsigned("throttle hover [%]", 1, 100)
    return RcTuning(
        kind=kind,
        roll=AxisRates(rc_rate, roll, expo),
        pitch=AxisRates(pitch_rc_rate, pitch, pitch_expo),
        yaw=AxisRates(yaw_rc_rate, yaw, yaw_expo),
        throttle_mid=middle,
        throttle_expo=throttle_expo,
        throttle_hover=hover,
        throttle_limit=limit if limit_kind else 100,
    )


def encode_tuning(tuning: RcTuning) -> bytes:
    """Return RC_TUNING, as firmware of API 1.47 writes it."""
    roll, pitch, yaw = tuning.roll, tuning.pitch, tuning.yaw
    limits = tuning.throttle_limit < 100
    return packed(
        *((roll.rc_rate, 1), (roll.expo, 1), (roll.rate, 1), (pitch.rate, 1), (yaw.rate, 1)),
        *((0, 1), (tuning.throttle_mid, 1), (tuning.throttle_expo, 1), (0, 2), (yaw.expo, 1)),
        *((yaw.rc_rate, 1), (pitch.rc_rate, 1), (pitch.expo, 1), (int(limits), 1)),
        *((tuning.throttle_limit, 1), (1998, 2), (1998, 2), (1998, 2), (tuning.kind, 1)),
        (tuning.throttle_hover, 1),
    )


def read_receiver(payload: bytes) -> tuple[int, int]:
    """Return middle of a stick and highest position that counts as no throttle [us] (RX_CONFIG).

    Raises:
        WireError: too short, or no positions of a stick.
    """
    fields = Fields(Msp.RX_CONFIG, payload)
    fields.skip("provider, full", 3)
    middle = fields.unsigned("middle [us]", 2, 1700)
    return middle, fields.unsigned("throttle low [us]", 2, 1300)


def encode_receiver(middle: int, throttle_low: int) -> bytes:
    """Return RX_CONFIG as far as it is read."""
    return packed((0, 1), (1900, 2), (middle, 2), (throttle_low, 2), (0, 1), (885, 2), (2115, 2))


def read_order(payload: bytes) -> tuple[int, int, int, int]:
    """Return which channel is roll, pitch, yaw and throttle (RX_MAP).

    Raises:
        WireError: too short, or two sticks on one channel.
    """
    fields = Fields(Msp.RX_MAP, payload)
    roll, pitch, yaw, throttle = order = fields.several("channel", 1, 4, 7)
    if len(set(order)) < 4:
        raise WireError(f"RX_MAP says {order}; allowed: four channels that differ")
    return roll, pitch, yaw, throttle


def read_failsafe(payload: bytes) -> FailsafeSettings:
    """Return what it does in silence; raises WireError for a procedure that is none."""
    fields = Fields(Msp.FAILSAFE_CONFIG, payload)
    delay, landing = fields.several("delay [0.1 s], landing time [s]", 1, 2, 200)
    throttle = fields.unsigned("throttle [us]", 2, 2500)
    fields.skip("switch, throttle delay", 3)
    procedure = fields.unsigned("procedure", 1, max(FailsafeProcedure))
    return FailsafeSettings(delay / 10, float(landing), throttle, FailsafeProcedure(procedure))


def encode_failsafe(failsafe: FailsafeSettings) -> bytes:
    """Return FAILSAFE_CONFIG."""
    return packed(
        *((round(failsafe.delay * 10), 1), (round(failsafe.landing_time), 1)),
        *((failsafe.throttle, 2), (0, 1), (100, 2), (failsafe.procedure, 1)),
    )


def read_silent_channels(payload: bytes) -> tuple[tuple[SilentChannel, int], ...]:
    """Return what each channel says in silence (RXFAIL_CONFIG); raises WireError as above."""
    fields = Fields(Msp.RXFAIL_CONFIG, payload)
    found: list[tuple[SilentChannel, int]] = []
    while fields.left and len(found) < 18:
        kind = fields.unsigned(f"kind[{len(found)}]", 1, max(SilentChannel))
        found.append((SilentChannel(kind), fields.unsigned("value [us]", 2, 2500)))
    return tuple(found)


def encode_silent_channels(silent: tuple[tuple[SilentChannel, int], ...]) -> bytes:
    """Return RXFAIL_CONFIG."""
    return packed(*(number for kind, value in silent for number in ((int(kind), 1), (value, 2))))


def read_angle_limit(payload: bytes) -> int:
    """Return the lean of full sticks in ANGLE mode [degree] (PID_ADVANCED)."""
    fields = Fields(Msp.PID_ADVANCED, payload)
    fields.skip("others", 17)
    return fields.unsigned("angle limit [degree]", 1, 90)


def encode_angle_limit(angle_limit: int) -> bytes:
    """Return PID_ADVANCED as far as it is read."""
    return bytes(17) + packed((angle_limit, 1), (0, 8))


def read_motor_idle(payload: bytes) -> float:
    """Return the share of full throttle at which idle motors turn (ADVANCED_CONFIG)."""
    fields = Fields(Msp.ADVANCED_CONFIG, payload)
    fields.skip("others", 6)
    return fields.unsigned("motor idle [0.01 %]", 2, 2000) / 10000


def encode_motor_idle(share: float) -> bytes:
    """Return ADVANCED_CONFIG as far as it is read."""
    return bytes(6) + packed((round(share * 10000), 2), (0, 6))
