"""What Betaflight and a simulator say to each other: four motors out, a state back. Pure.

Source: betaflight/betaflight, src/platform/SIMULATOR (sitl.c, target.h). Gyro: forward, right,
down. Its accelerometer is told the pull of gravity, forward, left, up, and so is the lean that it
finds: tried on the program, where the sources and the makers of simulators do not agree.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass

from housefly.errors import WireError
from housefly.geometry import GRAVITY, rotate
from housefly.twin.disturbance import MotorGains
from housefly.twin.simulated_body import BodyState

STATE_PORT, MOTOR_PORT, MSP_PORT = 9003, 9002, 5761
_STATE, _MOTORS = struct.Struct("<18d"), struct.Struct("<4f")
_LONGITUDE, _LATITUDE = 7.0, 45.0
_PRESSURE = 101325.0
"""It computes its own of the height [Pa]."""
_SLACK = 1e-3
"""Rounding of a throttle."""


@dataclass(frozen=True, slots=True)
class MotorOutput:
    """Throttles of front right, rear left, front left, rear right, 0 to 1."""

    throttles: tuple[float, float, float, float]

    @property
    def gains(self) -> MotorGains:
        """The same in the order of ``quadrotor.motors``."""
        front_right, rear_left, front_left, rear_right = self.throttles
        return front_left, front_right, rear_right, rear_left


def motor_output_in(datagram: bytes) -> MotorOutput:
    """Return what a datagram tells the motors.

    Raises:
        WireError: another length, or a throttle beyond 0 to 1.
    """
    if len(datagram) != _MOTORS.size:
        raise WireError(f"a motor packet has {len(datagram)} bytes; allowed: {_MOTORS.size}")
    told = _MOTORS.unpack(datagram)
    for throttle in told:
        if not -_SLACK <= throttle <= 1.0 + _SLACK:
            raise WireError(f"a motor packet's throttle is {throttle}; allowed: 0 to 1")
    one, two, three, four = (min(max(throttle, 0.0), 1.0) for throttle in told)
    return MotorOutput((one, two, three, four))


def state_packet(at: float, body: BodyState) -> bytes:
    """Return the packet that tells Betaflight what its sensors see.

    Args:
        at: time of the room [s].
        body: the true state; where it is it is not told, only how high.
    """
    w, x, y, z = body.orientation
    ax, ay, az = body.acceleration
    forward, left, up = rotate((w, -x, -y, -z), (ax, ay, az + GRAVITY))
    p, q, r = body.rate
    return _STATE.pack(
        at,
        *(p, -q, -r),
        *(-forward, -left, -up),
        *(w, x, -y, -z),
        *body.velocity,
        *(_LONGITUDE, _LATITUDE, body.position[2]),
        _PRESSURE,
    )
