"""The drone's own sensors: noise, bias, drift and delay on the true state.

Speed and height come 40 ms late (tum-vision/tum_ardrone, DroneKalmanFilter), the sonar pings at 25
Hz (Parrot ARDroneLib SDK 2.0.1, ultrasound_freq 8). All other numbers are chosen so that a hover by
optical flow wanders by centimetres to decimetres in minutes.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from math import exp, sqrt

import numpy as np

from housefly.config.airframe import airframe_named
from housefly.geometry import GRAVITY, Vec3, euler_from_quaternion, rotate, wrap_angle
from housefly.twin.quadrotor.body import STANDING_HEIGHT
from housefly.twin.simulated_body import CONTROL_PERIOD, BodyState, SensorReading

_FLOW = airframe_named("ardrone").flow
assert _FLOW is not None
FLOW_DELAY = _FLOW.delay
_SONAR_DIVIDER = 8
"""Control periods between two pings: 25 Hz."""

_ATTITUDE_NOISE = 0.0005
_GYRO_NOISE = 0.004
_GYRO_BIAS = 0.0005
"""Yaw drift, one sigma of one flight [rad/s]."""
_ATTITUDE_OFFSET = 0.0035
_TRIMMED_OFFSET = 0.0009
"""Attitude offset, one sigma at power-on and after a flat trim [rad]."""
_LEAN_MIN = 0.005
"""A drone that leans less than this stands level [rad]."""
_FLOW_NOISE, _FLOW_BIAS, _FLOW_BIAS_TIME = _FLOW.noise, _FLOW.bias, _FLOW.bias_time
"""Optical flow: white noise and slowly wandering bias [m/s], correlation time of the bias [s]."""
_CLIMB_NOISE = 0.01
_SONAR_NOISE = 0.01
_ACCELERATION_NOISE = 0.1

_BLOCK = 512
_CHANNELS = 14


def _bare_floor(position: Vec3) -> float:
    """Return the height of the surface below a position where nothing stands [m]."""
    return 0.0


class OnboardSensors:
    """The sensors of one drone.

    Every reading draws the same amount of noise, so that observers cannot change a flight.

    Args:
        rng: source of all noise.
        surface_below: returns the height [m] of the surface that the sonar meets below a world
            position; asked once per ping.
        standing_height: of the drone's middle when it stands [m].
    """

    def __init__(
        self,
        rng: np.random.Generator,
        surface_below: Callable[[Vec3], float] = _bare_floor,
        standing_height: float = STANDING_HEIGHT,
    ) -> None:
        self._rng, self._standing_height = rng, standing_height
        self._surface_below = surface_below
        self._noise: deque[list[float]] = deque()
        self._offset_phi, self._offset_theta = rng.normal(0.0, _ATTITUDE_OFFSET, 2).tolist()
        self._attitude = (0.0, 0.0)
        self._gyro_bias = float(rng.normal(0.0, _GYRO_BIAS))
        self._psi = 0.0
        self._psi_before: float | None = None
        self._flow_bias = (0.0, 0.0)
        self._late: deque[tuple[float, float, Vec3]] = deque(
            maxlen=round(FLOW_DELAY / CONTROL_PERIOD) + 1
        )
        self._height = 0.0
        self._count = 0

    def flat_trim(self) -> None:
        """Take the present attitude as level, up to a small error."""
        phi, theta = self._rng.normal(0.0, _TRIMMED_OFFSET, 2).tolist()
        is_leaning = max(map(abs, self._attitude)) > _LEAN_MIN
        lean_phi, lean_theta = self._attitude if is_leaning else (0.0, 0.0)
        self._offset_phi, self._offset_theta = phi - lean_phi, theta - lean_theta

    def read(self, body: BodyState) -> SensorReading:
        """Return a reading; call once every ``CONTROL_PERIOD``."""
        n = self._drawn()
        phi, theta, yaw = euler_from_quaternion(body.orientation)
        self._attitude = phi, theta
        self._follow_heading(yaw)
        self._wander(n[0], n[1])
        forward, left, height = self._flow_and_sonar(body, n[2])
        p, q, r = body.rate
        return SensorReading(
            phi=phi + self._offset_phi + _ATTITUDE_NOISE * n[3],
            theta=theta + self._offset_theta + _ATTITUDE_NOISE * n[4],
            psi=self._psi,
            rate=(
                p + _GYRO_NOISE * n[5],
                q + _GYRO_NOISE * n[6],
                r + self._gyro_bias + _GYRO_NOISE * n[7],
            ),
            height=height,
            climb=body.velocity[2] + _CLIMB_NOISE * n[8],
            forward=forward + self._flow_bias[0] + _FLOW_NOISE * n[9],
            left=left + self._flow_bias[1] + _FLOW_NOISE * n[10],
            acceleration=_specific_force(body, n[11], n[12], n[13]),
        )

    def _drawn(self) -> list[float]:
        """Return a row of normal numbers, drawn in blocks: a draw costs more than a number."""
        if not self._noise:
            self._noise.extend(self._rng.standard_normal((_BLOCK, _CHANNELS)).tolist())
        return self._noise.popleft()

    def _follow_heading(self, yaw: float) -> None:
        """Integrate the turn since power-on, with the gyro's drift."""
        before = yaw if self._psi_before is None else self._psi_before
        self._psi = wrap_angle(self._psi + yaw - before + self._gyro_bias * CONTROL_PERIOD)
        self._psi_before = yaw

    def _wander(self, drive_forward: float, drive_left: float) -> None:
        forward, left = self._flow_bias
        self._flow_bias = (
            _KEEP * forward + _DRIVE * drive_forward,
            _KEEP * left + _DRIVE * drive_left,
        )

    def _flow_and_sonar(self, body: BodyState, noise: float) -> Vec3:
        w, x, y, z = body.orientation
        vx, vy, _ = rotate((w, -x, -y, -z), body.velocity)
        self._late.append((vx, vy, body.position))
        forward, left, position = self._late[0]
        if self._count % _SONAR_DIVIDER == 0:
            height = position[2] - self._standing_height - self._surface_below(position)
            self._height = max(0.0, height + _SONAR_NOISE * noise)
        self._count += 1
        return forward, left, self._height


_KEEP = exp(-CONTROL_PERIOD / _FLOW_BIAS_TIME)
_DRIVE = _FLOW_BIAS * sqrt(1.0 - _KEEP * _KEEP)


def _specific_force(body: BodyState, nx: float, ny: float, nz: float) -> Vec3:
    w, x, y, z = body.orientation
    ax, ay, az = body.acceleration
    fx, fy, fz = rotate((w, -x, -y, -z), (ax, ay, az + GRAVITY))
    return (
        fx + _ACCELERATION_NOISE * nx,
        fy + _ACCELERATION_NOISE * ny,
        fz + _ACCELERATION_NOISE * nz,
    )
