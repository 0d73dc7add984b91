"""The topics and queries of the bus.

Keys are relative; the transport prepends the site's namespace.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from typing import Any, Generic, TypeVar

from housefly.config.drone import DRONE_NAME
from housefly.errors import WireError
from housefly.messages import (
    DepthImage,
    LinkStatus,
    Obstacle,
    Order,
    PilotStep,
    PlannedTrajectory,
    RecordingNews,
    RoomEvent,
    SensorReport,
    SightNews,
    TrackedFrame,
    VideoFrame,
)
from housefly.messages.order_fault import order_fault

_Message = TypeVar("_Message")


class Delivery(Enum):
    """LATEST may drop old values (poses, pictures); EVERY blocks rather than lose one (orders)."""

    LATEST = "latest"
    EVERY = "every"


class Encoding(Enum):
    """CDR for the types of ``bus/msg``; JSON for what hub and tasks also answer as JSON."""

    CDR = "cdr"
    JSON = "json"


@dataclass(frozen=True, slots=True)
class Topic(Generic[_Message]):
    """A named stream of one message type.

    Attributes:
        key: name on the wire.
        type: of the messages.
        delivery: what happens if a subscriber is slow.
        depth: unread messages that a LATEST topic keeps for a slow subscriber.
        max_size: longer messages are dropped before they are decoded [bytes].
        fault: says in words what is wrong with a message; one with a fault is not sent, and not
            delivered.
        encoding: of the messages on the wire.
    """

    key: str
    type: type[_Message]
    delivery: Delivery
    depth: int = 1
    max_size: int = 256 * 1024
    fault: Callable[[_Message], str] = field(default=lambda _: "", repr=False)
    encoding: Encoding = Encoding.CDR

    def check(self, message: _Message) -> _Message:
        """Return the message; raises WireError when it has a fault."""
        if words := self.fault(message):
            raise WireError(words)
        return message


FRAME_TOPIC: Topic[TrackedFrame] = Topic("room/frame", TrackedFrame, Delivery.LATEST, depth=100)
OBSTACLE_TOPIC: Topic[Obstacle] = Topic("room/obstacles", Obstacle, Delivery.LATEST, depth=256)
DEPTH_TOPIC: Topic[DepthImage] = Topic(
    "room/depth", DepthImage, Delivery.LATEST, depth=2, max_size=16 * 2**20
)
ROOM_EVENT_TOPIC: Topic[RoomEvent] = Topic(
    "room/event", RoomEvent, Delivery.EVERY, max_size=16 * 1024
)
"""What a process other than the hub says has happened; the hub keeps it."""
SENSOR_TOPIC: Topic[SensorReport] = Topic("room/sensors", SensorReport, Delivery.LATEST, depth=64)
SIGHT_TOPIC: Topic[SightNews] = Topic("room/sight", SightNews, Delivery.LATEST)


class DroneTopics:
    """The topics and queries of one drone of the room.

    Args:
        name: of the drone.

    Attributes:
        name: of the drone.
        step: what its pilot heard and decided.
        trajectory: what is planned in space; beside the steps, whose form old recordings hold.
        link: health of the pilot's wires and loop.
        video: its camera.
        order: what people and tasks ask of it.
        recording: whether its camera is recorded.
        plan: query: JSON request of a plan -> JSON answer (see ``hub.api.pilot_queries``).
        room: query: "" -> JSON view of the room and of this drone's map (likewise).
        preflight: query: "" -> JSON list of the pre-flight checks (likewise).
        stand_down: query: "" -> "", and its pilot takes no order to fly for a moment, or why not,
            in words.
    """

    def __init__(self, name: str = DRONE_NAME) -> None:
        self.name, key = name, f"drones/{name}"
        # Ten seconds: a recorder that stands still for a moment on a busy machine misses nothing,
        # and can replay bit for bit.
        self.step = Topic(f"{key}/step", PilotStep, Delivery.LATEST, depth=1000, max_size=2**20)
        self.trajectory = Topic(f"{key}/trajectory", PlannedTrajectory, Delivery.LATEST)
        self.link = Topic(f"{key}/link", LinkStatus, Delivery.LATEST)
        self.video = Topic(
            f"{key}/video", VideoFrame, Delivery.LATEST, depth=15, max_size=4 * 2**20
        )
        self.order = Topic(f"{key}/order", Order, Delivery.EVERY, max_size=2048, fault=order_fault)
        self.recording = Topic(f"{key}/recording", RecordingNews, Delivery.LATEST)
        self.plan, self.room = f"{key}/plan", f"{key}/room"
        self.preflight, self.stand_down = f"{key}/preflight", f"{key}/stand_down"

    @property
    def all(self) -> tuple[Topic[Any], ...]:
        """Every topic of the drone."""
        return self.step, self.trajectory, self.link, self.video, self.order, self.recording


ROOM_TOPICS: tuple[Topic[Any], ...] = (
    FRAME_TOPIC,
    OBSTACLE_TOPIC,
    DEPTH_TOPIC,
    SENSOR_TOPIC,
    SIGHT_TOPIC,
    ROOM_EVENT_TOPIC,
)
"""Those of ``housefly.messages`` that are no drone's; hub and tasks have one each of their own."""

USE_EDITS_QUERY = "run/use_edits"
"""Query to the launcher: number of saved edits -> "", and they come into use, or why not."""
HUB_QUERY = "hub/ask"
"""Query: JSON question to the room -> JSON answer or refusal (see ``hub.api.json``)."""
TASKS_QUERY = "tasks/ask"
"""Query: JSON question to the tasks -> JSON answer or refusal (see ``tasks.api.json``)."""
