"""What ``ardrone_autonomy`` serves, so that a node written for it flies ours.

Source: documentation of the ROS package ardrone_autonomy 1.4 (topics, Navdata.msg, units).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import cos, degrees, isfinite, sin
from typing import Any

import numpy as np
from rosbags.typesys import get_types_from_msg

from housefly.bus.interfaces import type_store
from housefly.geometry import Vec3
from housefly.messages import DroneStatus, PilotStep, Telemetry
from housefly.record.ros_messages import header, message
from housefly.ros2.drone_messages import Outgoing, RosFrames
from housefly.ros2.flight_desk import FlightDesk
from housefly.ros2.order_line import RosReply
from housefly.ros2.topic_table import Quality, RosTopic
from housefly.ros2.wishes import NOTHING_TO_SAY, Offered, RosInput

_NAVDATA_TYPE = "ardrone_autonomy/msg/Navdata"
_NAVDATA_TEXT = """\
std_msgs/Header header
float32 batteryPercent
uint32 state
int32 magX
int32 magY
int32 magZ
int32 pressure
int32 temp
float32 wind_speed
float32 wind_angle
float32 wind_comp_angle
float32 rotX
float32 rotY
float32 rotZ
int32 altd
float32 vx
float32 vy
float32 vz
float32 ax
float32 ay
float32 az
uint8 motor1
uint8 motor2
uint8 motor3
uint8 motor4
uint32 tags_count
uint32[] tags_type
uint32[] tags_xc
uint32[] tags_yc
uint32[] tags_width
uint32[] tags_height
float32[] tags_orientation
float32[] tags_distance
float32 tm
"""
_EMPTY = "std_msgs/msg/Empty"
TAKE_OFF = RosTopic("/ardrone/takeoff", _EMPTY, Quality.STATE, "take off and hover")
LAND = RosTopic("/ardrone/land", _EMPTY, Quality.STATE, "land")
RESET = RosTopic(
    "/ardrone/reset", _EMPTY, Quality.STATE, "ends an emergency on the ground; in the air: STOP"
)
CMD_VEL = RosTopic(
    "/cmd_vel", "geometry_msgs/msg/Twist", Quality.STATE, "-1 to 1 of the speed by hand"
)
NAVDATA = RosTopic("/ardrone/navdata", _NAVDATA_TYPE, Quality.SENSOR, "the drone's report")
PAPER_PICTURES = RosTopic(
    "/ardrone/image_raw/compressed", "sensor_msgs/msg/CompressedImage", Quality.SENSOR, "JPEG"
)
PAPER_TOLD = (NAVDATA, PAPER_PICTURES)

_STATES = {
    DroneStatus.UNKNOWN: 0,
    DroneStatus.LANDED: 2,
    DroneStatus.FLYING: 4,
    DroneStatus.TAKING_OFF: 6,
    DroneStatus.LANDING: 8,
    DroneStatus.EMERGENCY: 0,
}
"""``state`` of Navdata: 2 landed, 4 hovering, 6 taking off, 8 landing, 0 unknown or emergency."""
_GRAVITY = 9.81


class PaperInterface:
    """Serves the names for one drone.

    Args:
        drone: its name.
        speed: of full deflection [m/s].
        frames: of the drone.
    """

    def __init__(self, drone: str, speed: float, frames: RosFrames) -> None:
        self._drone, self._speed, self._frames = drone, speed, frames
        self._yaw: float | None = None
        register_navdata()

    def offered(self, desk: FlightDesk) -> Offered:
        """Yield what may be asked of the drone."""
        for topic, wish, is_safer in (
            (TAKE_OFF, desk.take_off, False),
            (LAND, desk.land, True),
            (RESET, desk.reset, True),
        ):
            yield RosInput(topic.name, topic, partial(self._wish, wish), is_safer)
        yield RosInput(CMD_VEL.name, CMD_VEL, partial(self._on_velocity, desk))

    def of(self, step: PilotStep, offset: float) -> Iterator[Outgoing]:
        """Yield what a step has to tell; ``offset`` is the Unix time of its zero [s]."""
        estimate = step.outputs.estimate
        self._yaw = None if estimate is None else estimate.yaw
        if (telemetry := step.inputs.telemetry) is not None:
            at = telemetry.received_at + offset
            yield NAVDATA, partial(navdata, at, telemetry, self._frames.body)

    def _wish(self, wish: Callable[[str], RosReply], _: Any) -> RosReply:
        reply = wish(self._drone)
        return (
            NOTHING_TO_SAY if reply.success else RosReply(False, f"{self._drone}: {reply.message}")
        )

    def _on_velocity(self, desk: FlightDesk, twist: Any) -> RosReply:
        linear = (twist.linear.x, twist.linear.y, twist.linear.z)
        if not all(map(isfinite, linear)) or self._yaw is None or not any(linear):
            return NOTHING_TO_SAY
        if not self._speed:
            words = "limits.nudge_speed is 0: nothing is moved by hand here"
        else:
            words = desk.nudge(self._drone, world_velocity(linear, self._yaw, self._speed))
        return RosReply(False, f"{CMD_VEL.name}: {words}") if words else NOTHING_TO_SAY


def register_navdata() -> None:
    """Add the type of ``ardrone_autonomy`` to those that we write."""
    store = type_store()
    if _NAVDATA_TYPE not in store.types:
        store.register(get_types_from_msg(_NAVDATA_TEXT, _NAVDATA_TYPE))


def world_velocity(stick: Vec3, yaw: float, speed: float) -> Vec3:
    """Return the velocity along the world's axes [m/s].

    Args:
        stick: forward, left, up, each -1 to 1; more counts as 1.
        yaw: of the drone [rad].
        speed: of full deflection [m/s].
    """
    forward, left, up = (speed * max(-1.0, min(1.0, part)) for part in stick)
    cosine, sine = cos(yaw), sin(yaw)
    return cosine * forward - sine * left, sine * forward + cosine * left, up


def navdata(at: float, telemetry: Telemetry, frame: str) -> Any:
    """Return ardrone_autonomy/Navdata: degrees, mm, mm/s and g, as that package has them."""
    acceleration = telemetry.acceleration or (0.0, 0.0, _GRAVITY)
    whole, none = np.array([], dtype=np.uint32), np.array([], dtype=np.float32)
    return message(
        _NAVDATA_TYPE,
        header(at, frame),
        100.0 * telemetry.battery,
        _STATES[telemetry.status],
        *(0, 0, 0, 0, 0),
        *(0.0, 0.0, 0.0),
        *map(degrees, (telemetry.phi, telemetry.theta, telemetry.psi)),
        round(1e3 * telemetry.height),
        *(1e3 * part for part in telemetry.velocity),
        *(part / _GRAVITY for part in acceleration),
        *(0, 0, 0, 0),
        0,
        *(whole,) * 5,
        *(none,) * 2,
        1e6 * (telemetry.drone_time or 0.0),
    )
