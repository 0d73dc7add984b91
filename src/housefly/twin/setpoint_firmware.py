"""The computer of a simulated drone that flies velocities or to places by itself.

It leans so that, behind the lag of its attitude, the velocity answers as its airframe says:

    v' = p (w - v)    for a velocity w,    x'' = k (r - x) - c x'    for a place r.

Its own speed is that of its sensors. Where it is, it is told from outside; between two poses it
reckons by that speed. States, take-off, landing and watchdogs are those of every simulated drone.
"""

from __future__ import annotations

from importlib import import_module
from math import atan, cos, hypot, inf, sin, tan

from housefly.config.drone import DroneConfig
from housefly.geometry import GRAVITY, Vec2, Vec3, wrap_angle
from housefly.messages import (
    AnySetpoint,
    Pose,
    PositionSetpoint,
    SetpointForm,
    VelocitySetpoint,
)
from housefly.messages.stick import Stick
from housefly.twin.contracts import FlightState
from housefly.twin.quadrotor.firmware import Firmware
from housefly.twin.quadrotor.inner_loops import LoopReferences
from housefly.twin.simulated_body import CONTROL_PERIOD, SensorReading, Wrench

_POSE_SHARE = 0.3
"""Share of what a pose differs by from what the drone reckons that it takes over."""
_POSE_AGE_MAX = 0.5
"""An older pose is worth nothing to it [s]."""


class SetpointFirmware(Firmware):
    """As ``Firmware``, steered by ``steer``; a stick that hovers ends that.

    Attributes:
        reckoned: where it believes to be [m]; None before it was told.
    """

    def __init__(self, drone: DroneConfig) -> None:
        super().__init__(drone)
        self._drone, self._response = drone, drone.airframe.response
        self._asked: AnySetpoint | None = None
        ends_after = drone.airframe.capabilities.silence.setpoint_ends_after
        self._setpoint_ends_after = inf if ends_after is None else ends_after
        self._heading: float | None = None
        self.reckoned: Vec3 | None = None

    def set_stick(self, stick: Stick) -> None:
        """Hover: sticks say nothing else to it."""
        self._asked = None
        super().set_stick(Stick())

    def steer(self, asked: AnySetpoint) -> None:
        """Fly a setpoint from now on."""
        self._asked = asked

    def tell_pose(self, pose: Pose, age: float) -> None:
        """Take in where it was so long ago [s]."""
        if age > _POSE_AGE_MAX:
            return
        self._heading = wrap_angle(pose.yaw - self._turned)
        if self.reckoned is None:
            self.reckoned = pose.position
            return
        later = (
            seen + age * speed for seen, speed in zip(pose.position, self._velocity, strict=True)
        )
        x, y, z = (
            own + _POSE_SHARE * (seen - own) for own, seen in zip(self.reckoned, later, strict=True)
        )
        self.reckoned = x, y, z

    def step(self, measured: SensorReading, voltage: float, silence: float) -> Wrench:
        """Run one control period; arguments as there."""
        self._reckon(measured)
        if self.flight is not FlightState.FLYING:
            self._asked = self._asked if self.flight is FlightState.HOVERING else None
        elif silence > self._setpoint_ends_after and isinstance(self._asked, VelocitySetpoint):
            self._asked = VelocitySetpoint()
        return super().step(measured, voltage, silence)

    _turned = 0.0
    _velocity: Vec3 = (0.0, 0.0, 0.0)

    def _reckon(self, measured: SensorReading) -> None:
        self._turned = measured.psi
        if self._heading is None or self.reckoned is None:
            return
        yaw = self._heading + measured.psi
        vx, vy = _turned((measured.forward, measured.left), yaw)
        self._velocity = vx, vy, measured.climb
        x, y, z = (
            own + CONTROL_PERIOD * speed
            for own, speed in zip(self.reckoned, self._velocity, strict=True)
        )
        self.reckoned = x, y, z

    def _fly(self, measured: SensorReading) -> LoopReferences:
        match self._asked:
            case VelocitySetpoint():
                self.flight = FlightState.FLYING
                return self._fly_velocity(self._asked, measured)
            case PositionSetpoint() if self.reckoned is not None and self._heading is not None:
                self.flight = FlightState.FLYING
                return self._fly_to(self._asked, self.reckoned, self._heading, measured)
            case _:
                return super()._fly(measured)

    def _fly_velocity(self, asked: VelocitySetpoint, measured: SensorReading) -> LoopReferences:
        pull = self._response.velocity_lag or 0.0
        wanted = _shortened((asked.forward, asked.left), self._response.speed_max or 0.0)
        push = pull * wanted[0], pull * wanted[1]
        return self._leaning(push, pull, asked.vz, asked.yaw_rate, measured)

    def _fly_to(
        self, asked: PositionSetpoint, here: Vec3, heading: float, measured: SensorReading
    ) -> LoopReferences:
        stiffness, pull = self._response.stiffness or 0.0, self._response.damping or 0.0
        way = asked.x - here[0], asked.y - here[1]
        reach = (self._response.speed_max or 0.0) * pull / stiffness
        ahead, left = _turned(_shortened(way, reach), -(heading + measured.psi))
        climb = stiffness / self._drone.climb_lag * (asked.z - here[2])
        push = stiffness * ahead, stiffness * left
        return self._leaning(push, pull, climb, asked.yaw_rate, measured)

    def _leaning(
        self, push: Vec2, pull: float, climb: float, yaw_rate: float, measured: SensorReading
    ) -> LoopReferences:
        """Return the lean that accelerates by push - pull v behind the lag of the attitude.

        Args:
            push: forward and left [m/s^2].
            pull: [1/s].
            climb: wanted climb rate [m/s].
            yaw_rate: wanted [rad/s].
            measured: the sensors' newest reading.
        """
        lean, drag = tan(measured.theta), self._drone.drag
        has = GRAVITY * lean, -GRAVITY * tan(measured.phi) * (1.0 + lean * lean) ** 0.5
        ahead, left = (
            wanted - (pull - drag) * (speed + (now - drag * speed) / self._drone.attitude_lag)
            for wanted, speed, now in zip(push, (measured.forward, measured.left), has, strict=True)
        )
        tilt, rate = self.limits.tilt, self.limits.yaw_rate
        return LoopReferences(
            phi=_clipped(-atan(left / GRAVITY), tilt),
            theta=_clipped(atan(ahead / GRAVITY), tilt),
            climb=_clipped(climb, self.limits.climb),
            yaw_rate=_clipped(yaw_rate, rate),
        )


OWN_FIRMWARE = {
    "betaflight": ("housefly.twin.betaflight.firmware", "BetaflightFirmware"),
    "crazyflie": ("housefly.twin.crazyflie.firmware", "CrazyflieFirmware"),
    "crazyflie_brushless": ("housefly.twin.crazyflie.firmware", "CrazyflieFirmware"),
}
"""Module and class of the computers of models that have one of their own."""


def firmware_of(drone: DroneConfig) -> Firmware:
    """Return the computer of a simulated drone: its model's own, or by its form of setpoints."""
    if drone.kind in OWN_FIRMWARE:
        module, name = OWN_FIRMWARE[drone.kind]
        own: Firmware = getattr(import_module(module), name)(drone)
        return own
    form = drone.airframe.capabilities.form
    return Firmware(drone) if form is SetpointForm.TILT_AND_CLIMB else SetpointFirmware(drone)


def _turned(vector: Vec2, by: float) -> Vec2:
    c, s = cos(by), sin(by)
    return c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]


def _shortened(vector: Vec2, bound: float) -> Vec2:
    length = hypot(*vector)
    share = 1.0 if length <= bound else bound / length
    return share * vector[0], share * vector[1]


def _clipped(value: float, bound: float) -> float:
    return max(-bound, min(bound, value))
