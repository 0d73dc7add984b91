"""One drone of the simulated room: firmware, sensors, battery, lights, and what befalls it."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

import numpy as np

from housefly.errors import WireError
from housefly.geometry import GRAVITY, Vec3, quaternion_from_euler, yaw_of
from housefly.messages import AnySetpoint, Pose
from housefly.messages.stick import Stick
from housefly.messages.words import Words
from housefly.twin.clearance import UNBOUNDED, Clearance
from housefly.twin.command_delay import simulated_command_delay
from housefly.twin.contact_log import Contact
from housefly.twin.contracts import FlightState, GroundTruth, OnboardLimits, OnboardState
from housefly.twin.disturbance import Disturbances, SensorCondition
from housefly.twin.disturbed_drone import DisturbedDrone
from housefly.twin.drone_body import DroneBody
from housefly.twin.drone_stands import DroneStand
from housefly.twin.encounters import Encounters
from housefly.twin.firmware.boarded import Board, BoardedFirmware
from housefly.twin.hands import Carry, CarryOrder, way_in_hands
from housefly.twin.quadrotor.battery import Battery, BatteryGauge
from housefly.twin.quadrotor.firmware import WATCHDOG_AFTER, Firmware
from housefly.twin.quadrotor.leds import Leds
from housefly.twin.quadrotor.motors import motor_duties
from housefly.twin.quadrotor.onboard_sensors import OnboardSensors
from housefly.twin.setpoint_firmware import firmware_of
from housefly.twin.simulated_body import CONTROL_PERIOD, MOTORS_OFF, Wrench
from housefly.twin.sonar_beam import SonarBeam

WORLD_ROUNDING = 1e-9
"""Times nearer to each other than this are one [s]."""
_LAID = 0.02
"""A drone that is let go so near to the floor is laid down [m]."""


class SimulatedDrone:
    """Implements ``twin.contracts.TwinDrone``; its world lets its time pass.

    Args:
        stand: its site, and its pad.
        body: what flies.
        sensing: noise of its sensors.
        clock: the world's time [s].

    Attributes:
        name: as the site has it.
        command_delay: from a command to obeying it [s].
        encounters: what it meets; None until the world is whole.
    """

    def __init__(
        self,
        stand: DroneStand,
        body: DroneBody,
        sensing: np.random.Generator,
        clock: Callable[[], float],
    ) -> None:
        site = stand.site
        self.name, self.command_delay = stand.name, simulated_command_delay(site)
        self.encounters: Encounters | None = None
        self._stand, self._rigid, self._clock = stand, body, clock
        self._weight = body.mechanics.mass * GRAVITY
        self._standing_height = body.mechanics.standing_height
        self._sensors = OnboardSensors(sensing, SonarBeam(body).height, self._standing_height)
        self._firmware, self._leds = firmware_of(stand.config), Leds()
        self.battery = Battery(site.twin.battery, stand.config.airframe.battery.endurance)
        self._gauge = BatteryGauge(self.battery)
        self._disturbed = DisturbedDrone(site, body, self.battery)
        self._delayed: deque[tuple[float, Callable[[], None]]] = deque()
        self._heard_at = self._began = self._at = 0.0
        self._carry: Carry | None = None
        self._carried_on: deque[CarryOrder] = deque()
        self._wrench: Wrench = MOTORS_OFF
        self._body = body.state()
        self._measured = self._sensors.read(self._body)
        self._onboard: OnboardState | None = None

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._clock()

    @property
    def firmware(self) -> Firmware:
        """Its own computer."""
        return self._firmware

    def set_stick(self, stick: Stick) -> None:
        """Pass on a movement command; it takes effect after the command delay."""
        self.later(lambda: self._firmware.set_stick(stick))

    def steer(self, asked: AnySetpoint) -> None:
        """Pass on a setpoint to a drone that takes no sticks; late as ``set_stick``."""
        self.later(lambda: self._firmware.steer(asked))

    def tell_pose(self, pose: Pose, captured_at: float) -> None:
        """Tell the drone where it was at a time [s]; late as ``set_stick``."""
        self.later(lambda: self._firmware.tell_pose(pose, self.now - captured_at))

    def keep_alive(self) -> None:
        """Any command arrived: feed the firmware's communication watchdogs."""
        self._heard_at = self.now

    def request_take_off(self) -> None:
        """REF bit 9 set."""
        self.later(self._firmware.request_take_off)

    def request_land(self) -> None:
        """REF bit 9 clear."""
        self.later(self._firmware.request_land)

    def toggle_emergency(self) -> None:
        """REF bit 8: cut the motors, or leave the emergency state."""
        self.later(self._firmware.toggle_emergency)

    def flat_trim(self) -> None:
        """Zero the attitude offsets; counts only when landed."""
        self.later(self._trim)

    def set_limits(self, limits: OnboardLimits) -> None:
        """Configuration changed the maxima."""
        self._firmware.limits = limits

    def play_leds(self, animation: int, frequency_hz: float, seconds: float) -> None:
        """Play an animation on the lights for some time [s]; 0 is for ever."""
        self._leds.play(animation, frequency_hz, seconds, self.now)

    def board(self, program: Board) -> None:
        """Let a stranger's firmware fly it from now on, and see the true state of its body."""
        self._firmware = BoardedFirmware(self._stand.config, program, self._rigid.state)

    @property
    def is_boarded(self) -> bool:
        """Whether a stranger's firmware flies it."""
        return isinstance(self._firmware, BoardedFirmware)

    @property
    def disturbances(self) -> Disturbances:
        """What disturbs the drone now."""
        return self._disturbed.by

    def disturb(self, disturbances: Disturbances) -> None:
        """Replace all disturbances, from the next control period on."""
        self._disturbed.by = disturbances
        self._onboard = None

    @property
    def contact_log(self) -> tuple[Contact, ...]:
        """What the drone touched so far, other than the floor, in order of time."""
        return self._met.contacts

    def clearance(self, within: Clearance = UNBOUNDED) -> Clearance:
        """Return how far the hull is now from what it can touch [m]; at most ``within``."""
        return self._met.clearance(self._at, within)

    def in_picture(self) -> dict[str, float]:
        """Return the share of the front camera's picture that each thing and person takes, 0 to 1.

        By name; true, cast by rays: for scores and tests.
        """
        return self._met.in_picture()

    def truth(self) -> GroundTruth:
        """Return the true state now."""
        body = self._body
        return GroundTruth(
            self._at,
            Pose(body.position, body.orientation),
            body.velocity,
            self._rigid.contacts(),
            self._leds.animation(self.now),
        )

    def onboard(self) -> OnboardState:
        """Return what the firmware believes now; it is put together once per control period."""
        is_silent = self.now - self._heard_at > WATCHDOG_AFTER
        known = self._onboard
        if known is None or known.com_watchdog is not is_silent:
            known = self._onboard = self._put_together(is_silent)
        return known

    def _put_together(self, is_silent: bool) -> OnboardState:
        """Return what the firmware believes, with or without its watchdog bit for silence."""
        firmware, measured = self._firmware, self._measured
        return OnboardState(
            at=self._at,
            flight=firmware.flight,
            battery=self._gauge.charge,
            battery_voltage=self._gauge.voltage,
            phi=measured.phi,
            theta=measured.theta,
            psi=measured.psi,
            height=measured.height,
            velocity=(measured.forward, measured.left, measured.climb),
            acceleration=measured.acceleration,
            angular_rate=measured.rate,
            motors=motor_duties(self._wrench, self._rigid.mechanics),
            low_battery=firmware.low_battery,
            com_watchdog=is_silent,
            com_lost=firmware.com_lost,
            angles_out_of_range=firmware.tilted,
            motors_problem=not firmware.powered,
            ultrasound_deaf=self.disturbances.sensors.sonar is SensorCondition.OFF,
        )

    def put(self, position: Vec3 | None = None, yaw: float | None = None) -> None:
        """Put the drone somewhere, at rest; by default on its pad."""
        home = (*self._stand.pad, self._standing_height)
        heading = self._stand.yaw if yaw is None else yaw
        self._rigid.place(position or home, quaternion_from_euler(0.0, 0.0, heading))
        self._body = self._rigid.state()

    def hover(self, position: Vec3, yaw: float) -> None:
        """Put the drone into the air, hovering [m], [rad]; commands under way are lost."""
        self._delayed.clear()
        self.put(position, yaw)
        self._firmware.begin_hovering(position[2])
        self._onboard = None

    def carry(self, *orders: CarryOrder) -> None:
        """Have somebody take the drone up and carry it from one place to the next.

        Held in the air it stays in their hands.

        Raises:
            WireError: its motors turn.
        """
        if self._motors_turn:
            raise WireError(Words("nobody takes hold of a drone whose propellers turn"))
        self._carried_on = deque(orders)
        self._carry_on(self.now)

    def put_back(self) -> None:
        """Have somebody carry the drone to its pad, over what stands in between.

        Raises:
            WireError: its motors turn.
        """
        here, pad = self._body.position, (*self._stand.pad, self._standing_height)
        self.carry(*way_in_hands(here, pad, self._stand.yaw))

    def charge(self) -> None:
        """Give it a full battery.

        Raises:
            WireError: its motors turn.
        """
        if self._motors_turn:
            raise WireError(Words("nobody charges a drone whose propellers turn"))
        self.battery.charge = 1.0

    @property
    def _motors_turn(self) -> bool:
        return self._wrench.thrust > 0.0

    def _carry_on(self, now: float) -> None:
        """Begin the next part of the way in somebody's hands [s]."""
        order, body = self._carried_on.popleft(), self._rigid.state()
        self._carry = Carry(order, body.position, yaw_of(body.orientation), now)

    @property
    def is_carried(self) -> bool:
        """Whether the drone is on its way in somebody's hands."""
        carry = self._carry
        return carry is not None and (bool(self._carried_on) or not carry.is_over(self.now))

    def decide(self, began: float) -> None:
        """Hear, sense, and let the firmware decide, at the beginning of a control period [s]."""
        self._began = began
        while self._delayed and self._delayed[0][0] <= began + WORLD_ROUNDING:
            self._delayed.popleft()[1]()
        self._measured = self._disturbed.sense(self._sensors.read(self._body), self._motors_turn)
        self._wrench = self._firmware.step(
            self._measured, self._gauge.voltage, began - self._heard_at
        )

    def push(self) -> None:
        """Push the body for the control period, as the firmware decided."""
        self._disturbed.push(self._wrench, self._body)

    def push_again(self) -> None:
        """Push the body anew within the control period, where a stranger's firmware flies it."""
        if isinstance(self._firmware, BoardedFirmware):
            self._wrench = self._firmware.step_again()
            self._disturbed.push_again(self._wrench, self._rigid.state())

    def arrive(self, at: float) -> None:
        """Take in where the body is at the end of the control period [s]."""
        if self._carry is not None:
            self._follow_hands(self._carry, self._began + CONTROL_PERIOD)
        self.battery.drain(CONTROL_PERIOD, self._wrench.thrust / self._weight)
        self._gauge.read(self._disturbed.by)
        self._onboard = None
        self._body, self._at = self._rigid.state(), at

    def look(self) -> None:
        """Note what it touched in the control period."""
        self._met.look(self._at, self._rigid.before, self._motors_turn)

    @property
    def _met(self) -> Encounters:
        assert self.encounters is not None
        return self.encounters

    def later(self, call: Callable[[], None]) -> None:
        """Let a command take effect after the command delay."""
        self._delayed.append((self.now + self.command_delay, call))

    def _trim(self) -> None:
        if self._firmware.flight is FlightState.LANDED:
            self._sensors.flat_trim()

    def _follow_hands(self, carry: Carry, now: float) -> None:
        """Move the drone with the hands that carry it; laid down, or started, it is let go."""
        position, yaw, velocity, turn_rate = carry.at(now)
        self._rigid.place(
            position, quaternion_from_euler(0.0, 0.0, yaw), velocity, (0.0, 0.0, turn_rate)
        )
        is_laid = carry.is_over(now) and position[2] <= self._standing_height + _LAID
        if self._motors_turn or (is_laid and not self._carried_on):
            self._carry = None
            self._carried_on.clear()
        elif self._carried_on and carry.is_over(now):
            self._carry_on(now)
