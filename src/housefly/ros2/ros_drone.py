"""One drone on the node: what it tells, and what is asked of it."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from functools import partial
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics
from housefly.config.house_mode import HouseMode
from housefly.config.site import Site
from housefly.errors import HouseflyError
from housefly.evidence.live_blanker import LiveBlanker
from housefly.geometry import yaw_of
from housefly.hub.wall_clock import WallClock
from housefly.messages import LinkStatus, PilotStep, PlannedTrajectory, VideoFrame
from housefly.record.ros_topics import topic_part
from housefly.ros2 import diagnostics
from housefly.ros2.camera import RosCamera
from housefly.ros2.drone_messages import (
    DroneMessages,
    RosFrames,
    trajectory_message,
)
from housefly.ros2.flight_desk import FlightDesk, RosReply
from housefly.ros2.navigate_server import NavigateServer
from housefly.ros2.node import RosNode
from housefly.ros2.paper.autonomy import PAPER_PICTURES, PaperInterface
from housefly.ros2.topic_table import (
    CAMERA_INFO,
    DRONE_TOPICS,
    GOAL,
    H264,
    PICTURES,
    TRAJECTORY,
    RosTopic,
    full_name,
)

TRIGGER = "std_srvs/srv/Trigger"
"""Type of every service: a wish without parameters, answered in words."""


class RosDrone:
    """One drone on the node.

    Args:
        site: as its own chain sees it.
        room: namespace of the room.
        node: of the room.
        desk: takes wishes.
        wall: Unix time.
        has_paper_names: whether it serves the topics of the paper's own drone node, too.
    """

    def __init__(
        self,
        site: Site,
        room: str,
        node: RosNode,
        desk: FlightDesk,
        wall: WallClock,
        *,
        has_paper_names: bool,
    ) -> None:
        name = site.drone.name
        self._drone, self._node, self._desk, self._wall = name, node, desk, wall
        self._frame = site.ros2.frame
        self._space = (room, topic_part(name))
        self._frames = RosFrames.of(self._frame, topic_part(name))
        self._messages = DroneMessages(site.tracking.body, self._frames, site.map.flight_height)
        self._lens = site.drone.airframe.capabilities.camera
        self._camera: RosCamera | None = None
        if self._lens is not None:
            names: dict[RosTopic, tuple[str, ...]]
            names = {topic: (self._name(topic),) for topic in (PICTURES, H264, CAMERA_INFO)}
            if has_paper_names:
                names[PICTURES] = (*names[PICTURES], PAPER_PICTURES.name)
            blanker = LiveBlanker(site.tasks, self._lens)
            self._camera = RosCamera(node, self._lens, self._frames, blanker, names)
        self._paper: PaperInterface | None = None
        if has_paper_names:
            speed = site.limits.nudge_speed
            self._paper = PaperInterface(name, speed, self._frames, node, desk)
        action = "/".join(("", *self._space, "navigate_to_pose"))
        self._navigate = NavigateServer(name, action, self._frame, node, desk)
        self._step: PilotStep | None = None
        self._link: LinkStatus | None = None
        self._planned: tuple[Any, ...] = ()

    def begin(self, bus: Bus, stack: ExitStack) -> None:
        """Offer topics and services, and listen."""
        node, topics = self._node, DroneTopics(self._drone)
        for topic in DRONE_TOPICS:
            if self._camera is not None or not topic.name.startswith("camera/"):
                node.advertise(topic, self._name(topic))
        node.subscribe(GOAL, self._name(GOAL), self._on_goal)
        for what, wish in (
            ("takeoff", self._desk.take_off),
            ("land", self._desk.land),
            ("stop", self._desk.stop),
            ("home", self._desk.home),
        ):
            service = "/".join(("", *self._space, what))
            node.serve(TRIGGER, service, triggered(partial(wish, self._drone)))
        if self._paper is not None:
            self._paper.begin()
        if (listening := self._navigate.begin(bus)) is not None:
            stack.callback(listening.close)
        stack.callback(bus.subscribe(topics.step, self._on_step).close)
        stack.callback(bus.subscribe(topics.trajectory, self._on_trajectory).close)
        stack.callback(bus.subscribe(topics.link, self._on_link).close)
        if self._camera is not None:
            stack.callback(bus.subscribe(topics.video, self._on_video).close)

    def set_mode(self, mode: HouseMode) -> None:
        """Tell the mode of the house."""
        if self._camera is not None:
            self._camera.set_mode(mode)

    def statuses(self) -> list[Any]:
        """Return how the drone is, for diagnostics."""
        step, link = self._step, self._link
        found = [] if step is None else [diagnostics.flight_status(self._drone, step)]
        return found if link is None else [*found, diagnostics.link_status(self._drone, link)]

    def _on_step(self, step: PilotStep) -> None:
        self._step = step
        self._desk.heard(self._drone, step)
        self._navigate.add_step(step)
        if self._camera is not None:
            self._camera.add_step(step)
        for topic, make in self._messages.of(step, self._wall.offset()):
            self._node.publish(topic, self._name(topic), make)
        if self._paper is not None:
            for topic, make in self._paper.of(step, self._wall.offset()):
                self._node.publish(topic, topic.name, make)

    def _on_trajectory(self, planned: PlannedTrajectory) -> None:
        if planned.points != self._planned:  # it is said again and again
            self._planned = planned.points
            make = partial(trajectory_message, planned, self._wall.offset(), self._frames)
            self._node.publish(TRAJECTORY, self._name(TRAJECTORY), make)

    def _on_link(self, link: LinkStatus) -> None:
        self._link = link

    def _on_video(self, frame: VideoFrame) -> None:
        assert self._camera is not None
        self._camera.show(frame, self._wall.offset())

    def _on_goal(self, goal: Any) -> None:
        frame, place, turn = goal.header.frame_id, goal.pose.position, goal.pose.orientation
        if frame not in ("", self._frame):
            self._node.warn(f"goal refused: its frame is {frame!r}; allowed: {self._frame!r}")
            return
        quaternion = (turn.w, turn.x, turn.y, turn.z)
        yaw = yaw_of(quaternion) if any(quaternion) else None
        reply = self._desk.fly_to(self._drone, (place.x, place.y), yaw)
        words = f"goal x {place.x:.2f}, y {place.y:.2f} for {self._drone}: {reply.message}"
        (self._node.inform if reply.success else self._node.warn)(words)

    def _name(self, topic: RosTopic) -> str:
        return full_name(topic, *self._space)


def triggered(wish: Callable[[], RosReply]) -> Callable[[Any, Any], Any]:
    """Return the handler of a service of type ``TRIGGER``."""

    def handler(request: Any, response: Any) -> Any:
        try:
            reply = wish()
        except HouseflyError as error:
            reply = RosReply(False, str(error))
        response.success, response.message = reply.success, reply.message
        return response

    return handler
