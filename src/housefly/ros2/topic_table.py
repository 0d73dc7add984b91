"""Every topic of the node: name, type, quality of service, what it is."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Quality(Enum):
    """Quality of service as ROS users expect it.

    SENSOR is best effort: who is slow gets the newest. STATE is reliable. LATCHED is kept for who
    comes later (transient local).
    """

    SENSOR = "sensor data"
    STATE = "reliable"
    LATCHED = "latched"


@dataclass(frozen=True, slots=True)
class RosTopic:
    """One topic.

    Attributes:
        name: below the namespace of the room, or of the drone; with ``/`` before it, as it is.
        type: of the messages, for example ``nav_msgs/msg/Path``.
        quality: of service.
        about: what it is.
    """

    name: str
    type: str
    quality: Quality
    about: str


_SENSOR, _STATE, _LATCHED = Quality.SENSOR, Quality.STATE, Quality.LATCHED

POSE = RosTopic("pose", "geometry_msgs/msg/PoseStamped", _SENSOR, "where tracking saw it")
ODOMETRY = RosTopic("odom", "nav_msgs/msg/Odometry", _SENSOR, "the filter's estimate")
PATH = RosTopic("path", "nav_msgs/msg/Path", _LATCHED, "the path in use; empty for none")
TRAJECTORY = RosTopic(
    "trajectory",
    "trajectory_msgs/msg/MultiDOFJointTrajectory",
    _LATCHED,
    "the trajectory in space, with times",
)
BATTERY = RosTopic("battery", "sensor_msgs/msg/BatteryState", _LATCHED, "charge, 0 to 1")
PHASE = RosTopic("phase", "std_msgs/msg/String", _LATCHED, "idle, taking off, holding ...")
DRONE_EVENTS = RosTopic("events", "rcl_interfaces/msg/Log", _STATE, "what happened, in words")
PICTURES = RosTopic(
    "camera/image_raw/compressed",
    "sensor_msgs/msg/CompressedImage",
    _SENSOR,
    "JPEG, made while somebody listens",
)
H264 = RosTopic(
    "camera/h264", "sensor_msgs/msg/CompressedImage", _SENSOR, "H.264 as the drone sends it"
)
CAMERA_INFO = RosTopic(
    "camera/camera_info", "sensor_msgs/msg/CameraInfo", _SENSOR, "pinhole, with each picture"
)
DRONE_TOPICS = (
    *(POSE, ODOMETRY, PATH, TRAJECTORY, BATTERY, PHASE),
    *(DRONE_EVENTS, PICTURES, H264, CAMERA_INFO),
)
"""Of each drone, below its name."""

MAP = RosTopic("map", "nav_msgs/msg/OccupancyGrid", _LATCHED, "the map at the flight height")
ROOM_MARKERS = RosTopic(
    "room", "visualization_msgs/msg/MarkerArray", _LATCHED, "walls and furniture in space"
)
THING_MARKERS = RosTopic(
    "things/markers", "visualization_msgs/msg/MarkerArray", _LATCHED, "things, with names"
)
THINGS = RosTopic(
    "things", "std_msgs/msg/String", _LATCHED, "where things are: JSON of `PlacedThing`"
)
PEOPLE = RosTopic("people", "geometry_msgs/msg/PoseArray", _STATE, "where people are")
OBSTACLES = RosTopic(
    "obstacles",
    "visualization_msgs/msg/MarkerArray",
    _STATE,
    "what sensors see that no map shows",
)
ROOM_EVENTS = RosTopic("events", "std_msgs/msg/String", _STATE, "JSON of `EventAnswer`")
SITUATIONS = RosTopic("situations", "std_msgs/msg/String", _LATCHED, "JSON of `SituationAnswer`")
TASKS = RosTopic("tasks", "std_msgs/msg/String", _LATCHED, "JSON of `TaskBoard`")
ANSWERS = RosTopic("answers", "std_msgs/msg/String", _STATE, "to `ask`, as JSON")
DIAGNOSTICS = RosTopic(
    "/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", _STATE, "drones, links and sensors"
)
ROOM_TOPICS = (
    *(MAP, ROOM_MARKERS, THING_MARKERS, THINGS, PEOPLE, OBSTACLES),
    *(ROOM_EVENTS, SITUATIONS, TASKS, ANSWERS, DIAGNOSTICS),
)
"""Of the room."""

TRANSFORMS = RosTopic("/tf", "tf2_msgs/msg/TFMessage", _STATE, "world to each drone")
STATIC_TRANSFORMS = RosTopic(
    "/tf_static", "tf2_msgs/msg/TFMessage", _LATCHED, "pads, sensors, cameras"
)

GOAL = RosTopic("goal_pose", "geometry_msgs/msg/PoseStamped", _STATE, "fly there and hover")
ASK = RosTopic("ask", "std_msgs/msg/String", _STATE, "a sentence, or a question as JSON")


def full_name(topic: RosTopic, *namespace: str) -> str:
    """Return the name of a topic below its namespaces."""
    if topic.name.startswith("/"):
        return topic.name
    return "/" + "/".join((*namespace, topic.name))
