"""What one flight controller is asked, and everything that it has told, as one report. Pure.

Half of the hundred commands that it takes in a second are sticks.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import inf

from housefly.bus.rate import Frequency
from housefly.messages import DroneFault, DroneStatus, Telemetry
from housefly.messages.words import Words
from housefly.wires.betaflight import reports, settings
from housefly.wires.betaflight.arming import OF_THE_SWITCH, ArmingFlag
from housefly.wires.betaflight.commands import VARIANT, Msp
from housefly.wires.betaflight.framing import MspDirection, MspFrame
from housefly.wires.betaflight.payloads import Fields
from housefly.wires.betaflight.settings import Box, FcSettings

STATUS_AGE_MAX = 0.5
"""Without its state for longer nobody knows whether its motors turn [s]."""
_LOW = 0.2
"""A charge below this is told as low, whatever the controller calls low."""
_SILENT = ArmingFlag.FAILSAFE | ArmingFlag.RX_FAILSAFE
QUESTIONS = (
    *(Msp.STATUS_EX, Msp.BATTERY_STATE),
    *(Msp.FC_VARIANT, Msp.FC_VERSION, Msp.BOXIDS, Msp.MODE_RANGES, Msp.FEATURE_CONFIG),
    *(Msp.RX_CONFIG, Msp.RX_MAP, Msp.RC_TUNING, Msp.RC_DEADBAND, Msp.PID_ADVANCED),
    *(Msp.ADVANCED_CONFIG, Msp.FAILSAFE_CONFIG, Msp.RXFAIL_CONFIG),
)
"""What is asked before a flight, in order; all of it has to be told."""

PERIODS = {Msp.ATTITUDE: 0.04, Msp.STATUS_EX: 0.06, Msp.RC: 0.2, Msp.BATTERY_STATE: 1.0}
"""How often each is asked [s]: its state so often that bad luck on a link that loses a fifth both
ways does not hide it for ``STATUS_AGE_MAX``.
"""
AGAIN_AFTER = 0.2
"""A question that was not answered is asked again [s]."""
LOOK_AGAIN = 0.5
"""While it stands, one of its settings is looked at anew this often [s]."""


class Questions:
    """Knows what was asked, and when."""

    def __init__(self) -> None:
        self._asked_at: dict[Msp, float] = {}
        self._looked_at, self._looked = -inf, 0

    def missing(self, told: frozenset[int], now: float) -> Msp | None:
        """Return the next question of those that are asked before a flight; None while all are out.

        Args:
            told: what was answered.
            now: [s].
        """
        left = [one for one in QUESTIONS if one not in told]
        if not left:
            return None
        next_one = min(left, key=lambda one: self._asked_at.get(one, -inf))
        if now - self._asked_at.get(next_one, -inf) < AGAIN_AFTER:
            return None
        return self._ask(next_one, now)

    def due(self, now: float, *, stands: bool) -> Msp | None:
        """Return what is due now [s], the most overdue first; None for nothing.

        Args:
            now: [s].
            stands: whether its motors are off: then its settings are looked at, too.
        """
        waits = {one: (now - self._asked_at.get(one, -inf)) / PERIODS[one] for one in PERIODS}
        first = max(waits, key=lambda one: waits[one])
        if waits[first] >= 1.0 - 1e-6:
            return self._ask(first, now)
        if stands and now - self._looked_at >= LOOK_AGAIN:
            self._looked_at, self._looked = now, (self._looked + 1) % len(QUESTIONS)
            return QUESTIONS[self._looked]
        return None

    def _ask(self, question: Msp, now: float) -> Msp:
        self._asked_at[question] = now
        return question


class Controller:
    """What one controller told.

    Attributes:
        settings: how it is set, as far as it was told.
        told: which questions it has answered.
        variant: what it calls itself; b"" before it did.
        firmware: its version; "" before it was told.
        status: its newest state.
        broken: answers that could not be read.
    """

    def __init__(self) -> None:
        self.settings, self.told = FcSettings(), frozenset[int]()
        self.variant, self.firmware = b"", ""
        self.status = reports.FcStatus()
        self.broken = 0
        self.channels: tuple[int, ...] = ()
        self._attitude: reports.FcAttitude | None = None
        self._battery: reports.FcBattery | None = None
        self._attitude_at = self._status_at = -inf
        self._attitudes = Frequency()

    def forget(self) -> None:
        """It was switched off and on, or is another: what it told counts no more."""
        self.__init__()  # type: ignore[misc]

    def hear(self, frame: MspFrame, now: float) -> bool:
        """Take in an answer that came now [s]; return whether it told how it leans.

        Raises:
            WireError: one that cannot be read.
        """
        if frame.direction is not MspDirection.ANSWER:
            return False
        read = _READERS.get(frame.command)
        if read is not None:
            read(self, frame.payload)
        elif frame.command == Msp.STATUS_EX:
            self.status, self._status_at = reports.read_status(frame.payload), now
        elif frame.command == Msp.RC:
            self.channels = reports.read_channels(Msp.RC, frame.payload)
        elif frame.command == Msp.BATTERY_STATE:
            self._battery = reports.read_battery(frame.payload)
        elif frame.command == Msp.ATTITUDE:
            self._attitude, self._attitude_at = reports.read_attitude(frame.payload), now
            self._attitudes.add(now)
        self.told |= {frame.command}
        return frame.command == Msp.ATTITUDE

    def _set(self, **known: object) -> None:
        self.settings = replace(self.settings, **known)  # type: ignore[arg-type]

    @property
    def is_known(self) -> bool:
        """Whether everything was told that is asked before a flight."""
        return self.told.issuperset(QUESTIONS)

    def is_on(self, box: Box) -> bool:
        """Return whether a mode is active, by its own word."""
        boxes = self.settings.boxes
        return box in boxes and bool(self.status.boxes >> boxes.index(box) & 1)

    def is_heard(self, now: float) -> bool:
        """Return whether its state is known now [s]."""
        return now - self._status_at < STATUS_AGE_MAX

    @property
    def is_armed(self) -> bool:
        """Whether its motors turn, by its newest word."""
        return self.is_on(Box.ARM)

    @property
    def hears_us(self) -> bool:
        """Whether sticks reach it."""
        return not self.status.arming & _SILENT

    @property
    def blocked(self) -> ArmingFlag:
        """What keeps it from arming, but for the switch itself."""
        return self.status.arming & ~OF_THE_SWITCH

    @property
    def lean(self) -> tuple[float, float]:
        """Phi and theta [rad]; level before they were told."""
        attitude = self._attitude
        return (0.0, 0.0) if attitude is None else (attitude.phi, attitude.theta)

    def rate_hz(self, now: float) -> float:
        """Return how often it told how it leans in the second before now [s]."""
        return self._attitudes.rate_hz(now)

    def report(
        self, status: DroneStatus, *, configured: bool, notes: tuple[Words, ...]
    ) -> Telemetry | None:
        """Return the newest report, None before it told how it leans.

        Args:
            status: what it is about.
            configured: whether it may take off with us.
            notes: what is not as it should be.
        """
        attitude, battery = self._attitude, self._battery
        if attitude is None:
            return None
        charge = 0.0 if battery is None else battery.charge
        is_low = battery is not None and (battery.is_low or charge < _LOW)
        crash = self.status.arming & ArmingFlag.CRASH_DETECTED
        faults = (
            *((DroneFault.BATTERY_LOW,) if is_low else ()),
            *((DroneFault.MOTORS_CUT_OUT,) if crash else ()),
        )
        return Telemetry(
            received_at=self._attitude_at,
            status=status,
            battery=charge,
            phi=attitude.phi,
            theta=attitude.theta,
            psi=attitude.psi,
            faults=faults,
            configured=configured,
            notes=notes,
            hears_us=self.hears_us,
        )


def _read_variant(controller: Controller, payload: bytes) -> None:
    controller.variant = payload[: len(VARIANT)]


def _read_firmware(controller: Controller, payload: bytes) -> None:
    controller.firmware = reports.read_firmware(payload)


def _read_receiver(controller: Controller, payload: bytes) -> None:
    middle, throttle_low = settings.read_receiver(payload)
    controller._set(middle=middle, throttle_low=throttle_low)


def _read_deadband(controller: Controller, payload: bytes) -> None:
    deadband, yaw = Fields(Msp.RC_DEADBAND, payload).several("deadband [us]", 1, 2, 100)
    controller._set(deadband=deadband, yaw_deadband=yaw)


_READERS: dict[int, Callable[[Controller, bytes], None]] = {
    Msp.FC_VARIANT: _read_variant,
    Msp.FC_VERSION: _read_firmware,
    Msp.BOXIDS: lambda one, data: one._set(boxes=tuple(data)),
    Msp.MODE_RANGES: lambda one, data: one._set(ranges=settings.read_mode_ranges(data)),
    Msp.FEATURE_CONFIG: lambda one, data: one._set(
        features=Fields(Msp.FEATURE_CONFIG, data).unsigned("features", 4)
    ),
    Msp.RX_CONFIG: _read_receiver,
    Msp.RX_MAP: lambda one, data: one._set(order=settings.read_order(data)),
    Msp.RC_TUNING: lambda one, data: one._set(tuning=settings.read_tuning(data)),
    Msp.RC_DEADBAND: _read_deadband,
    Msp.PID_ADVANCED: lambda one, data: one._set(angle_limit=settings.read_angle_limit(data)),
    Msp.ADVANCED_CONFIG: lambda one, data: one._set(motor_idle=settings.read_motor_idle(data)),
    Msp.FAILSAFE_CONFIG: lambda one, data: one._set(failsafe=settings.read_failsafe(data)),
    Msp.RXFAIL_CONFIG: lambda one, data: one._set(silent=settings.read_silent_channels(data)),
}
"""What each answer says of how it is set."""
