"""The computer of a simulated Crazyflie: setpoints in, thrust and torques out.

Cascade, limits and priorities as in the firmware (position_controller_pid.c, commander.c): a place
becomes a velocity, that a lean; a setpoint of port 7 goes before the high-level commander until it
is told that these stop; its supervisor has the last word.
"""

from __future__ import annotations

from math import cos, inf, radians, sin

from housefly.config.drone import DroneConfig
from housefly.geometry import Vec2, wrap_angle
from housefly.messages import AnySetpoint, Pose, PositionSetpoint, Setpoint, VelocitySetpoint
from housefly.messages.stick import Stick
from housefly.twin.contracts import FlightState
from housefly.twin.crazyflie.estimator import PlaceEstimator
from housefly.twin.crazyflie.planner import Planner, PlanState
from housefly.twin.crazyflie.supervisor import LEVEL_AFTER, Supervisor, SupervisorState
from housefly.twin.quadrotor.firmware import Firmware
from housefly.twin.quadrotor.inner_loops import LoopReferences
from housefly.twin.simulated_body import CONTROL_PERIOD, MOTORS_OFF, SensorReading, Wrench
from housefly.wires.crazyflie.high_level import HighLevelOrder, Land, TakeOff
from housefly.wires.crazyflie.localization import ToldPose
from housefly.wires.crazyflie.setpoints import (
    AltHold,
    FullState,
    GenericSetpoint,
    Hover,
    Place,
    Stop,
    WorldVelocity,
    ZDistance,
)
from housefly.wires.crazyflie.supervisor import SupervisorInfo

PLACE_GAIN, SPEED_MAX = 2.0, 1.0
"""Velocity per distance [1/s], and its bound [m/s]."""
LEAN_GAIN, LEAN_MAX = radians(25.0), radians(20.0)
"""Lean per velocity [rad s/m], and its bound [rad]."""
YAW_GAIN, YAW_RATE_MAX = 6.0, radians(200.0)
"""Yaw rate per angle [1/s], and its bound [rad/s]."""
_THRUST_MIN = 20000.0 / 65535.0
"""Share of full thrust below which it does not go while it holds a height or a climb."""
TAKE_OFF_HEIGHT, TAKE_OFF_TIME, SINK_RATE = 1.0, 2.0, 0.4
"""A take-off and a landing that lock step asks for: height [m], time [s], sink rate [m/s]."""
_STANDSTILL = AltHold(0.0, 0.0, 0.0, 0.0)


class CrazyflieFirmware(Firmware):
    """One Crazyflie's computer; call ``step`` once every ``CONTROL_PERIOD``.

    Attributes:
        estimator: where it believes to be.
        supervisor: whether its motors may turn.
        planner: its high-level commander.
        now: since it was switched on [s].
    """

    def __init__(self, drone: DroneConfig) -> None:
        super().__init__(drone)
        self.estimator, self.planner = PlaceEstimator(), Planner()
        self.supervisor = Supervisor(arms_itself=not drone.airframe.capabilities.arms)
        self._thrust_min = _THRUST_MIN * (drone.airframe.body.thrust_max or 0.0)
        self._hears_states = drone.airframe.capabilities.is_told_full_state
        self.now, self._psi, self._turns = 0.0, 0.0, False
        self._low: GenericSetpoint | None = None
        self._given_at = -inf
        self._is_stick_hovering = False

    @property
    def info(self) -> SupervisorInfo:
        """What its supervisor says."""
        info = self.supervisor.info
        if self.planner.state is not PlanState.STOPPED:
            info |= SupervisorInfo.HIGH_LEVEL_ACTIVE
        if self.planner.is_finished(self.now):
            info |= SupervisorInfo.TRAJECTORY_FINISHED
        return info

    def give(self, setpoint: GenericSetpoint) -> None:
        """Fly a setpoint of port 7 from now on; the high-level commander forgets everything."""
        self._low, self._given_at = setpoint, self.now
        self._is_stick_hovering = False
        self.planner.stop()

    def stop_setpoints(self) -> None:
        """Let the high-level commander be heard again."""
        self._low = None

    def obey(self, order: HighLevelOrder) -> int:
        """Obey a high-level order; return 0, or 1 where that is not possible now."""
        return self.planner.obey(order, self.estimator.position, self.estimator.yaw, self.now)

    def tell(self, told: ToldPose) -> None:
        """Take in where it is, as of now."""
        turned = told.orientation
        yaw = None if turned is None else Pose(told.position, turned).yaw
        self.estimator.tell(told.position, yaw, self._psi, self.now)

    def tell_pose(self, pose: Pose, age: float) -> None:
        """Take in where it is: it does not hear how long ago that was."""
        self.tell(ToldPose(pose.position, pose.orientation))

    def set_stick(self, stick: Stick) -> None:
        """Lean and climb as a stick says; one that hovers holds the place where it began."""
        is_flown_already = self.planner.state is not PlanState.STOPPED and stick.hover
        if is_flown_already or not self.supervisor.is_flying:
            return
        if not stick.hover:
            limits = self.limits
            self.give(
                AltHold(
                    phi=-stick.left * limits.tilt,
                    theta=stick.forward * limits.tilt,
                    yaw_rate=stick.turn * limits.yaw_rate,
                    vz=stick.up * limits.climb,
                )
            )
            return
        held = self._low if self._is_stick_hovering and self._low else self._standstill()
        self.give(held)
        self._is_stick_hovering = True

    def steer(self, asked: AnySetpoint) -> None:
        """Fly a setpoint in our own words, once it is in the air."""
        if not self.supervisor.is_flying:
            return
        yaw = self.estimator.yaw
        match asked:
            case Setpoint(theta, phi, vz, yaw_rate):
                self.give(AltHold(phi, theta, yaw_rate, vz))
            case VelocitySetpoint(forward, left, vz, yaw_rate):
                vx, vy = _turned((forward, left), yaw)
                self.give(WorldVelocity(vx, vy, vz, yaw_rate))
            case PositionSetpoint(x, y, z, yaw_rate):
                yaw = wrap_angle(yaw + yaw_rate / YAW_GAIN)
                is_state = self._hears_states
                self.give(FullState((x, y, z), yaw=yaw) if is_state else Place(x, y, z, yaw))

    def request_take_off(self) -> None:
        """Be armed, then rise by its own, once after a request to land."""
        if self.supervisor.state is SupervisorState.CHECKED:
            self.supervisor.arm(True)
        if not self._may_take_off or not self.supervisor.can_fly or self.supervisor.is_flying:
            return
        self._may_take_off = False
        self.stop_setpoints()
        self.obey(TakeOff(TAKE_OFF_HEIGHT, TAKE_OFF_TIME))

    def request_land(self) -> None:
        """Sink by its own, and stop."""
        self._may_take_off = True
        is_flown = self._low is not None or self.planner.state is PlanState.FLYING
        if not self.supervisor.is_flying or not is_flown:
            return
        height = self.estimator.position[2]
        self.obey(Land(0.0, max(height / SINK_RATE, 0.5)))
        self.stop_setpoints()

    def toggle_emergency(self) -> None:
        """Cut the motors for good, or be switched off and on."""
        if self.supervisor.state is not SupervisorState.LOCKED:
            self.supervisor.stop()
            return
        self.supervisor.restart()
        self.planner.stop()
        self.estimator.reset()
        self._low, self._is_stick_hovering = None, False

    def begin_hovering(self, height: float) -> None:
        """Hover from now on: for a flight that begins in the air."""
        self._may_take_off = False
        self.supervisor.begin_flying()
        self.give(self._standstill())
        self._is_stick_hovering = True

    def step(self, measured: SensorReading, voltage: float, silence: float) -> Wrench:
        """Run one control period; arguments as there."""
        self.now += CONTROL_PERIOD
        self._voltage, self._psi = voltage, measured.psi
        self.com_lost = silence > LEVEL_AFTER
        self.estimator.predict(measured)
        setpoint = self._in_force()
        self.supervisor.update(measured, self._turns, self.now - self._given_at)
        self.tilted = SupervisorInfo.IS_TUMBLED in self.supervisor.info
        self.flight = self._flight()
        if self.supervisor.state is SupervisorState.LEVEL_OUT:
            setpoint = _levelled(setpoint)
        may_turn = self.supervisor.can_fly and not isinstance(setpoint, Stop)
        wrench = self._wrench(setpoint, measured) if may_turn else MOTORS_OFF
        self._turns = wrench.thrust > 0.0
        return wrench

    def _in_force(self) -> GenericSetpoint:
        """Return what is flown: setpoints of port 7 before the high-level commander's."""
        if self._low is not None:
            return self._low
        self._given_at = self.now
        return self.planner.setpoint(self.now)

    def _flight(self) -> FlightState:
        supervisor = self.supervisor
        if supervisor.state in (SupervisorState.LOCKED, SupervisorState.CRASHED):
            return FlightState.EMERGENCY
        if not supervisor.is_flying:
            return FlightState.LANDED
        if self._low is not None:
            is_held = self._is_stick_hovering
            return FlightState.HOVERING if is_held else FlightState.FLYING
        if self.planner.state is not PlanState.FLYING:
            return FlightState.LANDING
        is_rising = self.planner.is_taking_off and not self.planner.is_finished(self.now)
        return FlightState.TAKING_OFF if is_rising else FlightState.HOVERING

    def _standstill(self) -> GenericSetpoint:
        """Return what holds the drone where it is now, as far as it knows where that is."""
        known = self.estimator
        return Place(*known.position, known.yaw) if known.is_told else _STANDSTILL

    def _wrench(self, setpoint: GenericSetpoint, measured: SensorReading) -> Wrench:
        believed = measured._replace(climb=self.estimator.velocity[2])
        wrench = self._loops.wrench(self._references(setpoint), believed)
        return wrench._replace(thrust=max(wrench.thrust, self._thrust_min))

    def _references(self, setpoint: GenericSetpoint) -> LoopReferences:
        match setpoint:
            case AltHold(phi, theta, yaw_rate, vz):
                return LoopReferences(phi, theta, vz, yaw_rate)
            case ZDistance(phi, theta, yaw_rate, z):
                return LoopReferences(phi, theta, self._climb_to(z), yaw_rate)
            case Hover(forward, left, yaw_rate, z):
                return self._leaning((forward, left), self._climb_to(z), yaw_rate)
            case WorldVelocity(vx, vy, vz, yaw_rate):
                return self._leaning(_turned((vx, vy), -self.estimator.yaw), vz, yaw_rate)
            case Place(x, y, z, yaw):
                turn = _clipped(YAW_GAIN * wrap_angle(yaw - self.estimator.yaw), YAW_RATE_MAX)
                return self._leaning(self._speed_to(x, y), self._climb_to(z), turn)
            case FullState((x, y, z), yaw=yaw):
                return self._references(Place(x, y, z, yaw))
            case Stop():
                return LoopReferences(0.0, 0.0, 0.0, 0.0)

    def _climb_to(self, z: float) -> float:
        return _clipped(PLACE_GAIN * (z - self.estimator.position[2]), SPEED_MAX)

    def _speed_to(self, x: float, y: float) -> Vec2:
        here = self.estimator.position
        ahead, left = _turned((x - here[0], y - here[1]), -self.estimator.yaw)
        return _clipped(PLACE_GAIN * ahead, SPEED_MAX), _clipped(PLACE_GAIN * left, SPEED_MAX)

    def _leaning(self, speed: Vec2, climb: float, yaw_rate: float) -> LoopReferences:
        vx, vy, _ = self.estimator.velocity
        ahead, left = _turned((vx, vy), -self.estimator.yaw)
        return LoopReferences(
            phi=-_clipped(LEAN_GAIN * (speed[1] - left), LEAN_MAX),
            theta=_clipped(LEAN_GAIN * (speed[0] - ahead), LEAN_MAX),
            climb=climb,
            yaw_rate=yaw_rate,
        )


def _levelled(setpoint: GenericSetpoint) -> GenericSetpoint:
    """Return a setpoint without lean and turn; its height or climb is kept."""
    match setpoint:
        case AltHold(vz=vz) | WorldVelocity(vz=vz):
            return AltHold(0.0, 0.0, 0.0, vz)
        case ZDistance(z=z) | Hover(z=z) | Place(z=z) | FullState((_, _, z)):
            return ZDistance(0.0, 0.0, 0.0, z)
        case Stop():
            return setpoint


def _turned(vector: Vec2, by: float) -> Vec2:
    c, s = cos(by), sin(by)
    return c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]


def _clipped(value: float, bound: float) -> float:
    return max(-bound, min(bound, value))
