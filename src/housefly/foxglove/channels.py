"""The channels of the live view: topic, schema, and whether late comers get the last message."""

from __future__ import annotations

import json
from dataclasses import dataclass
from enum import Enum

from housefly.bus.interfaces import definition
from housefly.config.site import Site
from housefly.foxglove.json_values import (
    DroneNumbers,
    HouseTasks,
    LinkNumbers,
    RoomHappening,
    RoomSituations,
    json_schema,
)
from housefly.record.ros_topics import topic_part

MARKERS = "visualization_msgs/msg/MarkerArray"


class Encoding(Enum):
    """CDR with the ROS 2 text of the type, or JSON with a JSON schema."""

    CDR = ("cdr", "ros2msg")
    JSON = ("json", "jsonschema")


@dataclass(frozen=True, slots=True)
class LiveChannel:
    """One channel.

    Attributes:
        topic: its name.
        schema_name: ROS 2 type, or the name of a JSON schema.
        schema: its text.
        encoding: of the messages.
        latched: whether its last message is sent again when somebody subscribes.
    """

    topic: str
    schema_name: str
    schema: str
    encoding: Encoding = Encoding.CDR
    latched: bool = False


def drone_topic(drone: str, name: str) -> str:
    """Return the topic of a drone: ``/drone/odom``."""
    return f"/{topic_part(drone)}/{name}"


def body_topic(body: str) -> str:
    """Return the topic of a tracked body: ``/sighting/visitor``."""
    return f"/sighting/{topic_part(body)}"


def tracked_bodies(site: Site) -> tuple[str, ...]:
    """Return the bodies that a site names, each once: drones, people, furniture."""
    named = (
        *site.drone_bodies,
        site.tracking.visitor,
        *site.people.bodies,
        *(piece.body for piece in site.furniture),
    )
    return tuple(dict.fromkeys(body for body in named if body))


def channels_of(site: Site) -> tuple[LiveChannel, ...]:
    """Return every channel of a site, each once: those of the room, then those of each drone."""
    room = [
        _ros("/tf", "tf2_msgs/msg/TFMessage"),
        _ros("/room/furniture", MARKERS, latched=True),
        _ros("/room/tracked", MARKERS),
        _ros("/room/obstacles", MARKERS),
        *(_ros(body_topic(body), "geometry_msgs/msg/PoseStamped") for body in tracked_bodies(site)),
    ]
    if site.hub.enabled:
        room += [_json("/room/events", RoomHappening), _json("/room/situations", RoomSituations)]
    if site.tasks.enabled:
        room.append(_json("/tasks", HouseTasks, latched=True))
    drones = (channel for drone in site.drone_names for channel in _drone_channels(site, drone))
    # Two bodies whose names differ only in what a topic cannot hold share one.
    return tuple({channel.topic: channel for channel in (*room, *drones)}.values())


def _drone_channels(site: Site, drone: str) -> list[LiveChannel]:
    own = site.for_drone(drone)
    named: dict[str, tuple[str, bool]] = {
        "map": ("nav_msgs/msg/OccupancyGrid", True),
        "body": (MARKERS, True),
        "odom": ("nav_msgs/msg/Odometry", False),
        "path": ("nav_msgs/msg/Path", True),
        "trajectory": ("nav_msgs/msg/Path", True),
        "cmd_vel": ("geometry_msgs/msg/TwistStamped", False),
        "cmd_pose": ("geometry_msgs/msg/PoseStamped", False),
        "battery": ("sensor_msgs/msg/BatteryState", True),
        "events": ("rcl_interfaces/msg/Log", False),
    }
    if own.drone.has_video and own.drone.has_camera:
        named["camera"] = ("foxglove_msgs/msg/CompressedVideo", False)
    return [
        *(
            _ros(drone_topic(drone, name), schema, latched=latched)
            for name, (schema, latched) in named.items()
        ),
        _json(drone_topic(drone, "state"), DroneNumbers),
        _json(drone_topic(drone, "link"), LinkNumbers),
    ]


def _ros(topic: str, schema: str, *, latched: bool = False) -> LiveChannel:
    return LiveChannel(topic, schema, definition(schema), latched=latched)


def _json(topic: str, kind: type, *, latched: bool = False) -> LiveChannel:
    schema = json.dumps(json_schema(kind))
    return LiveChannel(topic, f"housefly.{kind.__name__}", schema, Encoding.JSON, latched)
