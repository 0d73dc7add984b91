"""The computer of a simulated drone with Betaflight: sticks in, thrust and torques out.

As in the firmware: a switch arms it unless a flag forbids that; in ANGLE mode sticks ask for lean,
else for turn rates; throttle is thrust, and nothing holds a height. It knows nothing of take-offs
and landings: armed it counts as flying here.
"""

from __future__ import annotations

from dataclasses import replace
from math import acos, cos, radians

from housefly.config.drone import DroneConfig
from housefly.geometry import GRAVITY
from housefly.messages.stick import Stick
from housefly.twin.betaflight.failsafe import FcFailsafe, Phase
from housefly.twin.betaflight.receiver import Receiver
from housefly.twin.contracts import FlightState
from housefly.twin.quadrotor.firmware import Firmware
from housefly.twin.quadrotor.inner_loops import LoopReferences
from housefly.twin.simulated_body import CONTROL_PERIOD, MOTORS_OFF, SensorReading, Wrench
from housefly.wires.betaflight.arming import NOTHING, OF_THE_SWITCH, ArmingFlag
from housefly.wires.betaflight.settings import (
    FEATURE_RX_MSP,
    AxisRates,
    Box,
    FailsafeProcedure,
    FailsafeSettings,
    FcSettings,
    ModeRange,
    SilentChannel,
)
from housefly.wires.betaflight.sticks import (
    RadioSticks,
    flight_channels,
    radio_sticks_of,
    raw_channels,
    throttle_position,
    turn_rate,
)
from housefly.wires.betaflight.switches import Switches, boxes_at, switches_of

BOOT_GRACE_TIME = 5.0
"""After it was switched on it does not arm for so long [s] (powerOnArmingGraceTime)."""
SMALL_ANGLE = radians(25.0)
"""It does not arm leaning further (small_angle)."""
MOTOR_LAG = 0.033
"""Time constant of its motors [s] (uzh-rpg/agilicious, kingfisher)."""
_RATE_POLE, _ACCELERATION_MAX = 40.0, 300.0
_ORDER = (0, 1, 2, 3)
BOXES = (
    *(Box.ARM, Box.ANGLE, Box.HORIZON, Box.ALT_HOLD, Box.HEADFREE, Box.FAILSAFE, Box.CRASH_FLIP),
    *(Box.PREARM, Box.PARALYZE, Box.MSP_OVERRIDE),
)
"""Modes that it knows, in the order of its state."""
SINKING_THRUST = 0.97
"""Thrust over weight of an automatic landing: it ends at about 1 m/s."""
LANDING_TIME = 6.0
_HIGH = 1700, 2100


def usual_settings(hover: float) -> FcSettings:
    """Return how it is set when it is switched on: as docs/drones/betaflight.md asks.

    Args:
        hover: share of full thrust that carries it.
    """
    usual = FcSettings(
        boxes=BOXES,
        ranges=(
            ModeRange(Box.ARM, 0, *_HIGH),
            ModeRange(Box.ANGLE, 1, *_HIGH),
            ModeRange(Box.MSP_OVERRIDE, 2, *_HIGH),
        ),
        features=FEATURE_RX_MSP,
    )
    idle = usual.motor_idle
    throttle = ((SINKING_THRUST * hover) ** 0.5 - idle) / (1.0 - idle)
    silent = list(usual.silent)
    silent[3] = (SilentChannel.HOLD, usual.middle)
    failsafe = FailsafeSettings(
        landing_time=LANDING_TIME,
        throttle=throttle_position(throttle, usual),
        procedure=FailsafeProcedure.AUTO_LAND,
    )
    return replace(usual, silent=tuple(silent), failsafe=failsafe)


class BetaflightFirmware(Firmware):
    """One flight controller; call ``step`` once every ``CONTROL_PERIOD``.

    Args:
        drone: its site's row.

    Attributes:
        receiver: the sticks that it flies by.
        failsafe: what it does without them.
        is_armed: whether its motors turn.
        blocked: what keeps it from arming.
        now: since it was switched on [s]; that was a while ago.
    """

    def __init__(self, drone: DroneConfig) -> None:
        super().__init__(drone)
        body = drone.airframe.body
        self._full = body.thrust_max or 4.0 * body.mass * GRAVITY
        self._inertia = body.inertia_tilt or 0.0, body.inertia_turn or 0.0
        self.receiver = Receiver(usual_settings(body.mass * GRAVITY / self._full))
        self.is_armed, self.blocked, self.now = False, ArmingFlag.RX_FAILSAFE, BOOT_GRACE_TIME
        self.failsafe = FcFailsafe(self.now)
        self._thrust = 0.0
        self._was_switched_off = False

    @property
    def settings(self) -> FcSettings:
        """How it is set; may be replaced."""
        return self.receiver.settings

    @settings.setter
    def settings(self, settings: FcSettings) -> None:
        self.receiver.settings = settings

    @property
    def on(self) -> frozenset[int]:
        """Modes that its switches turn on."""
        return boxes_at(self.settings.ranges, self.receiver.channels[len(_ORDER) :])

    @property
    def boxes(self) -> tuple[int, ...]:
        """Modes whose bits its state tells, in order; MSP OVERRIDE only where a mask is set."""
        has_mask = self.receiver.override_mask != 0
        return tuple(box for box in self.settings.boxes if has_mask or box != Box.MSP_OVERRIDE)

    @property
    def box_bits(self) -> int:
        """Which of these are active."""
        active = self.on - {Box.ARM} | ({Box.ARM} if self.is_armed else set())
        return sum(1 << number for number, box in enumerate(self.boxes) if box in active)

    def hear(self, channels: tuple[int, ...]) -> None:
        """Take in SET_RAW_RC."""
        self.receiver.hear(channels, self.now)

    def set_stick(self, stick: Stick) -> None:
        """Ignore it: only channels are heard."""

    def request_take_off(self) -> None:
        """Ignore it: nothing takes off here by itself."""

    def request_land(self) -> None:
        """Ignore it, too."""

    def toggle_emergency(self) -> None:
        """Ignore it: the arm switch cuts the motors."""

    def begin_hovering(self, height: float) -> None:
        """Be armed and carried from now on: for a flight that begins in the air."""
        self._thrust = self._mass * GRAVITY
        share, idle = self._thrust / self._full, self.settings.motor_idle
        sticks = RadioSticks(throttle=(share**0.5 - idle) / (1.0 - idle))
        switches = switches_of(self.settings.ranges)
        assert isinstance(switches, Switches)
        flight = flight_channels(sticks, self.settings)
        self.hear(raw_channels(flight, switches.armed, self.settings))
        self.is_armed = self.failsafe.is_up = True
        self.flight = FlightState.FLYING

    def step(self, measured: SensorReading, voltage: float, silence: float) -> Wrench:
        """Run one control period; arguments as there, but the silence is the receiver's own."""
        self.now += CONTROL_PERIOD
        self._voltage = voltage
        self.receiver.update(self.now)
        self.com_lost = self.receiver.is_lost(self.now)
        lean = acos(max(-1.0, min(1.0, cos(measured.phi) * cos(measured.theta))))
        sticks = self._sticks()
        self.failsafe.update(
            self.now,
            self.receiver.silence(self.now),
            self.settings.failsafe,
            is_lost=self.com_lost,
            is_armed=self.is_armed,
            throttle_is_low=sticks.throttle is None,
        )
        self._arm(sticks, is_level=lean < SMALL_ANGLE)
        self.flight = FlightState.FLYING if self.is_armed else FlightState.LANDED
        if not self.is_armed:
            self._thrust = 0.0
            return MOTORS_OFF
        return self._flown(sticks, measured)

    def _sticks(self) -> RadioSticks:
        """Return what it flies by: sticks, or those of its automatic landing."""
        fc = self.settings
        roll, pitch, yaw, throttle = self.receiver.channels[: len(_ORDER)]
        if self.failsafe.phase is Phase.LANDING:
            roll = pitch = yaw = fc.middle
            throttle = fc.failsafe.throttle
        return radio_sticks_of((roll, pitch, yaw, throttle), fc)

    def _arm(self, sticks: RadioSticks, *, is_level: bool) -> None:
        """Arm and disarm as the switch says, unless something forbids it."""
        is_on = Box.ARM in self.on
        if self.failsafe.phase is Phase.STOPPED or (self.is_armed and not is_on):
            self.is_armed = False
        causes = (
            (self.failsafe.phase is Phase.STOPPED, ArmingFlag.FAILSAFE),
            (not self.failsafe.is_up or self.com_lost, ArmingFlag.RX_FAILSAFE),
            (Box.FAILSAFE in self.on, ArmingFlag.BOX_FAILSAFE),
            (sticks.throttle is not None, ArmingFlag.THROTTLE),
            (not is_level, ArmingFlag.ANGLE),
            (self.now < BOOT_GRACE_TIME, ArmingFlag.BOOT_GRACE_TIME),
            (Box.PARALYZE in self.on, ArmingFlag.PARALYZE),
            (self._lacks_prearm, ArmingFlag.NO_PREARM),
        )
        found = ArmingFlag(sum(flag for is_set, flag in causes if is_set))
        if self.is_armed:
            self.blocked = NOTHING
            return
        if not is_on:
            self._was_switched_off, self.blocked = True, found
            return
        kept = self.blocked & OF_THE_SWITCH
        if found or kept or not self._was_switched_off:
            self.blocked = found | ArmingFlag.ARM_SWITCH
            return
        self.is_armed, self.blocked = True, NOTHING

    @property
    def _lacks_prearm(self) -> bool:
        has_switch = any(one.box == Box.PREARM for one in self.settings.ranges)
        return has_switch and Box.PREARM not in self.on

    def _flown(self, sticks: RadioSticks, measured: SensorReading) -> Wrench:
        idle = self.settings.motor_idle
        share = (idle + (1.0 - idle) * (sticks.throttle or 0.0)) ** 2
        self._thrust += CONTROL_PERIOD / MOTOR_LAG * (share * self._full - self._thrust)
        levels = Box.ANGLE in self.on or self.failsafe.phase is Phase.LANDING
        wrench = self._levelled(sticks, measured) if levels else self._turned(measured)
        return wrench._replace(thrust=self._thrust)

    def _levelled(self, sticks: RadioSticks, measured: SensorReading) -> Wrench:
        """Return the torques of ANGLE mode."""
        references = LoopReferences(sticks.phi, sticks.theta, 0.0, sticks.yaw_rate)
        return self._loops.wrench(references, measured)

    def _turned(self, measured: SensorReading) -> Wrench:
        """Return the torques that follow sticks as turn rates."""
        fc, (roll, pitch, yaw) = self.settings, self.receiver.channels[:3]
        tuning = fc.tuning
        tilt, turn = self._inertia

        def torque(stick: int, axis: AxisRates, rate: float, inertia: float) -> float:
            wanted = radians(turn_rate(tuning.kind, axis, (stick - fc.middle) / 500.0))
            push = _RATE_POLE * (wanted - rate)
            return inertia * max(-_ACCELERATION_MAX, min(_ACCELERATION_MAX, push))

        p, q, r = measured.rate
        return Wrench(
            thrust=0.0,
            roll=torque(roll, tuning.roll, p, tilt),
            pitch=torque(pitch, tuning.pitch, q, tilt),
            yaw=-torque(yaw, tuning.yaw, -r, turn),
        )
