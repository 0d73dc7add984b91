"""A world without MuJoCo: a point that leans, climbs and turns as commanded, in an empty room.

For tests and benchmarks of the wires. Tilt and turn follow at once, speed follows tilt against
linear drag (tum-vision/tum_ardrone, DroneKalmanFilter c1), climb follows at once; no noise, no
delays, no tracking.
"""

from __future__ import annotations

from math import cos, sin, tan

from housefly.geometry import GRAVITY, Vec3, quaternion_from_euler, wrap_angle
from housefly.messages import Pose
from housefly.messages.stick import Stick
from housefly.twin.contracts import (
    FlightState,
    GroundTruth,
    MocapFrame,
    OnboardLimits,
    OnboardState,
)
from housefly.twin.quadrotor.leds import Leds

_STEP = 0.005
_DRAG = 0.58
"""Deceleration per speed [1/s]."""
_TAKE_OFF_HEIGHT = 1.0
_TAKE_OFF_CLIMB = 0.8
_SINK = 0.5
_WATCHDOG_AFTER = 0.05


class KinematicWorld:
    """Implements ``twin.contracts.TwinWorld``.

    Attributes:
        flight: major control state.
        asked: the last stick.
        limits: maxima in force.
        battery: charge, 0 to 1; set it as a test needs.
        trims: how many flat trims counted.
    """

    def __init__(self) -> None:
        self.flight = FlightState.LANDED
        self.asked = Stick()
        self.limits = OnboardLimits()
        self.battery = 1.0
        self.trims = 0
        self.visitor = False
        self._now = 0.0
        self._heard_at = 0.0
        self._position = [0.0, 0.0, 0.0]
        self._speed = [0.0, 0.0]
        self._climb = 0.0
        self._tilt = (0.0, 0.0)
        self._leds = Leds()
        self._psi = 0.0

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._now

    def advance(self, seconds: float) -> None:
        """Move in steps of at most ``_STEP``."""
        end = self._now + seconds
        while self._now < end - 1e-9:
            self._step(min(_STEP, end - self._now))

    def set_stick(self, stick: Stick) -> None:
        """Set the movement command."""
        self.asked = stick

    def keep_alive(self) -> None:
        """Record that a command came."""
        self._heard_at = self._now

    def request_take_off(self) -> None:
        """Take off from the ground."""
        if self.flight is FlightState.LANDED:
            self.flight = FlightState.TAKING_OFF

    def request_land(self) -> None:
        """Land from the air."""
        if self.flight.airborne:
            self.flight = FlightState.LANDING

    def toggle_emergency(self) -> None:
        """Cut the motors, or be ready again."""
        self.flight = (
            FlightState.LANDED if self.flight is FlightState.EMERGENCY else FlightState.EMERGENCY
        )

    def flat_trim(self) -> None:
        """Count a trim on the ground."""
        self.trims += self.flight is FlightState.LANDED

    def set_limits(self, limits: OnboardLimits) -> None:
        """Set the maxima."""
        self.limits = limits

    def onboard(self) -> OnboardState:
        """Return the state without error."""
        silence = self._now - self._heard_at
        theta, phi = self._tilt
        duty = 0.6 if self.flight.airborne else 0.0
        return OnboardState(
            at=self._now,
            flight=self.flight,
            battery=self.battery,
            battery_voltage=9.0 + 3.6 * self.battery,
            phi=phi,
            theta=theta,
            psi=self._psi,
            height=self._position[2],
            velocity=self._body_velocity(),
            acceleration=(0.0, 0.0, GRAVITY),
            angular_rate=(0.0, 0.0, self._turn_rate()),
            motors=(duty, duty, duty, duty),
            low_battery=self.battery < 0.2,
            com_watchdog=silence > _WATCHDOG_AFTER,
            com_lost=silence > self.limits.silence,
        )

    def truth(self) -> GroundTruth:
        """Return where the point is."""
        x, y, z = self._position
        theta, phi = self._tilt
        pose = Pose((x, y, z), quaternion_from_euler(phi, theta, self._psi))
        velocity = (self._speed[0], self._speed[1], self._climb)
        leds = self._leds.animation(self._now)
        return GroundTruth(self._now, pose, velocity, 0 if z > 0.0 else 1, leds)

    def mocap_frames(self) -> tuple[MocapFrame, ...]:
        """Return nothing: this room has no cameras."""
        return ()

    def play_leds(self, animation: int, frequency_hz: float, seconds: float) -> None:
        """Play an animation on the lights."""
        self._leds.play(animation, frequency_hz, seconds, self._now)

    def set_visitor(self, present: bool) -> None:
        """Record whether someone is at the door."""
        self.visitor = present

    def _step(self, dt: float) -> None:
        self._now += dt
        stick = (
            Stick()
            if self.asked.hover or self.flight not in (FlightState.FLYING, FlightState.HOVERING)
            else self.asked
        )
        self._tilt = (stick.forward * self.limits.tilt, -stick.left * self.limits.tilt)
        self._climb = self._wanted_climb(stick)
        self._psi = wrap_angle(self._psi + dt * self._turn_rate())
        for axis, push in enumerate(self._push()):
            braking = _DRAG if not stick.hover else 3.0
            self._speed[axis] += dt * (push - braking * self._speed[axis])
            self._position[axis] += dt * self._speed[axis]
        self._position[2] = max(0.0, self._position[2] + dt * self._climb)
        self._change_state()

    def _change_state(self) -> None:
        height = self._position[2]
        if self.flight is FlightState.TAKING_OFF and height >= _TAKE_OFF_HEIGHT:
            self.flight = FlightState.HOVERING
        elif self.flight in (FlightState.FLYING, FlightState.HOVERING):
            self.flight = FlightState.HOVERING if self.asked.hover else FlightState.FLYING
        elif self.flight is FlightState.LANDING and height <= 0.0:
            self.flight = FlightState.LANDED
        if self.flight.airborne and self._now - self._heard_at > self.limits.silence:
            self.flight = FlightState.LANDING

    def _wanted_climb(self, stick: Stick) -> float:
        fixed = {
            FlightState.TAKING_OFF: _TAKE_OFF_CLIMB,
            FlightState.LANDING: -_SINK,
            FlightState.EMERGENCY: -3.0,
        }
        climb = fixed.get(self.flight, stick.up * self.limits.climb)
        return min(climb, 0.0) if self._position[2] >= self.limits.altitude else climb

    def _turn_rate(self) -> float:
        return (
            0.0
            if self.asked.hover or self.flight is not FlightState.FLYING
            else self.asked.turn * self.limits.yaw_rate
        )

    def _push(self) -> tuple[float, float]:
        theta, phi = self._tilt
        forward, left = GRAVITY * tan(theta), -GRAVITY * tan(phi)
        c, s = cos(self._psi), sin(self._psi)
        return c * forward - s * left, s * forward + c * left

    def _body_velocity(self) -> Vec3:
        c, s = cos(self._psi), sin(self._psi)
        vx, vy = self._speed
        return c * vx + s * vy, -s * vx + c * vy, self._climb
