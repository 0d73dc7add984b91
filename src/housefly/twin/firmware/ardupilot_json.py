"""What ArduPilot and a simulator say to each other: motor pulses out, one line of JSON back. Pure.

Source: ArduPilot, libraries/SITL/examples/JSON/readme.md. Its parser finds numbers by their keys
and knows no spaces; a line begins and ends with a line feed. Axes are north, east, down.
"""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass

from housefly.errors import WireError
from housefly.geometry import GRAVITY, rotate
from housefly.twin.simulated_body import BodyState
from housefly.wires.mavlink.frames import across_body, across_orientation, across_world

_HEAD = struct.Struct("<HHI")
_CHANNELS = {18458: 16, 29569: 32}
"""How many pulses follow each of its two magic numbers."""
_PULSE_MAX = 3000
"""A servo knows no longer pulse [us]; 0 is none."""


@dataclass(frozen=True, slots=True)
class ServoOutput:
    """What ArduPilot tells its motors in one step.

    Attributes:
        rate_hz: how many steps a second it wants.
        frame: counts up with each step; from 0 after a restart.
        pulses: of each output [us]; 0 for none.
    """

    rate_hz: int
    frame: int
    pulses: tuple[int, ...]


def servo_output_in(datagram: bytes) -> ServoOutput:
    """Return what a datagram tells the motors.

    Raises:
        WireError: another magic number, length, rate or pulse.
    """
    if len(datagram) < _HEAD.size:
        raise WireError(f"a servo packet has {len(datagram)} bytes; allowed: 40 or 72")
    magic, rate_hz, frame = _HEAD.unpack_from(datagram)
    count = _CHANNELS.get(magic)
    if count is None:
        allowed = " or ".join(map(str, _CHANNELS))
        raise WireError(f"a servo packet's magic number is {magic}; allowed: {allowed}")
    if len(datagram) != _HEAD.size + 2 * count:
        allowed = f"{_HEAD.size + 2 * count} after magic number {magic}"
        raise WireError(f"a servo packet has {len(datagram)} bytes; allowed: {allowed}")
    if rate_hz == 0:
        raise WireError("a servo packet's frame rate is 0 Hz; allowed: 1 to 65535")
    pulses = struct.unpack_from(f"<{count}H", datagram, _HEAD.size)
    longest = max(pulses)
    if longest > _PULSE_MAX:
        raise WireError(f"a servo packet's pulse is {longest} us; allowed: 0 to {_PULSE_MAX}")
    return ServoOutput(rate_hz, frame, pulses)


def body_line(at: float, body: BodyState) -> bytes:
    """Return the line that tells ArduPilot what its sensors see.

    Time is the simulator's alone: it does not slow down to its own clock.

    Args:
        at: time of the room [s].
        body: the true state; its noise is the program's own.
    """
    w, x, y, z = body.orientation
    ax, ay, az = body.acceleration
    felt = rotate((w, -x, -y, -z), (ax, ay, az + GRAVITY))
    told = {
        "timestamp": at,
        "imu": {"gyro": across_body(body.rate), "accel_body": across_body(felt)},
        "position": across_world(body.position),
        "quaternion": across_orientation(body.orientation),
        "velocity": across_world(body.velocity),
        "no_time_sync": 1,
    }
    return b"\n" + json.dumps(told, separators=(",", ":"), allow_nan=False).encode() + b"\n"
