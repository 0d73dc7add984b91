"""SET_POSITION_TARGET_LOCAL_NED: a velocity along the level body's axes, or a place, and a turn.

A velocity goes in BODY_NED (8), whose axes are the heading's and down: ArduCopter and PX4 both heed
it. A place goes in LOCAL_NED (1). In both the yaw rate counts and the yaw does not.
"""

from __future__ import annotations

from typing import Any

from housefly.errors import WireError
from housefly.messages import AnySetpoint, PositionSetpoint, VelocitySetpoint
from housefly.wires.mavlink.dialect import dialect
from housefly.wires.mavlink.frames import across_body, across_world
from housefly.wires.mavlink.framing import finite

LOCAL_NED, BODY_NED, BODY_OFFSET_NED = 1, 8, 9
_PLACE, _VELOCITY, _ACCELERATION, _YAW = 0x007, 0x038, 0x1C0, 0x400
_ASKS_VELOCITY = _PLACE | _ACCELERATION | _YAW
_ASKS_PLACE = _VELOCITY | _ACCELERATION | _YAW
"""What is to be ignored of a velocity, and of a place."""


def setpoint_message(asked: AnySetpoint, target: tuple[int, int], time: float) -> Any:
    """Return the message of a setpoint.

    Args:
        asked: a velocity or a place.
        target: system and component.
        time: ours [s].

    Raises:
        WireError: a form that no message of these is for.
    """
    stamp = int(1000.0 * time) % (1 << 32)
    match asked:
        case VelocitySetpoint():
            velocity = across_body((asked.forward, asked.left, asked.vz))
            frame, mask = BODY_NED, _ASKS_VELOCITY
            place = 0.0, 0.0, 0.0
        case PositionSetpoint():
            place = across_world((asked.x, asked.y, asked.z))
            frame, mask = LOCAL_NED, _ASKS_PLACE
            velocity = 0.0, 0.0, 0.0
        case _:
            raise WireError(f"a setpoint of the form {type(asked).__name__} has no message")
    return dialect().MAVLink_set_position_target_local_ned_message(
        stamp, *target, frame, mask, *place, *velocity, 0.0, 0.0, 0.0, 0.0, -asked.yaw_rate
    )


def setpoint_in(message: Any) -> AnySetpoint:
    """Return the setpoint of a message; raises WireError for a form or frame that is not ours."""
    frame, mask = message.coordinate_frame, message.type_mask
    (rate,) = (0.0,) if mask & 0x800 else finite(message, "yaw_rate")
    if frame in (BODY_NED, BODY_OFFSET_NED) and not mask & _VELOCITY and mask & _PLACE == _PLACE:
        vx, vy, vz = finite(message, "vx", "vy", "vz")
        forward, left, up = across_body((vx, vy, vz))
        return VelocitySetpoint(forward, left, up, -rate)
    if frame == LOCAL_NED and not mask & _PLACE:
        north, east, down = finite(message, "x", "y", "z")
        x, y, z = across_world((north, east, down))
        return PositionSetpoint(x, y, z, -rate)
    raise WireError(
        f"SET_POSITION_TARGET_LOCAL_NED of frame {frame} with mask {mask:#x}; allowed: a velocity"
        f" in frame {BODY_NED} or {BODY_OFFSET_NED}, or a place in frame {LOCAL_NED}"
    )
