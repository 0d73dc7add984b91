"""One drone in the terms of ROS: what it tells, and what may be asked of it."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from functools import partial
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics
from housefly.config.house_mode import HouseMode
from housefly.config.site import Site
from housefly.evidence.live_blanker import LiveBlanker
from housefly.geometry import yaw_of
from housefly.hub.wall_clock import WallClock
from housefly.messages import LinkStatus, PilotStep, PlannedTrajectory, VideoFrame
from housefly.record.ros_topics import topic_part
from housefly.ros2 import diagnostics
from housefly.ros2.camera import RosCamera
from housefly.ros2.carrier import RosCarrier
from housefly.ros2.drone_messages import (
    DroneMessages,
    RosFrames,
    trajectory_message,
)
from housefly.ros2.flight_desk import FlightDesk
from housefly.ros2.order_line import OrderLine, RosReply
from housefly.ros2.paper.autonomy import PAPER_PICTURES, PAPER_TOLD, PaperInterface
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
from housefly.ros2.wishes import Offered, RosInput, RosService


class RosDrone:
    """One drone.

    Args:
        site: as its own chain sees it.
        room: namespace of the room.
        carrier: of the room.
        line: hears what the pilot says.
        wall: Unix time.
        has_paper_names: whether it serves the topics of the paper's own drone node, too.

    Attributes:
        name: of the drone.
        action: full name of the action that flies it to a pose.
        on_step: hears each step of its pilot, once the line has heard it.
    """

    def __init__(
        self,
        site: Site,
        room: str,
        carrier: RosCarrier,
        line: OrderLine,
        wall: WallClock,
        *,
        has_paper_names: bool,
    ) -> None:
        name = site.drone.name
        self.name, self._carrier, self._line, self._wall = name, carrier, line, wall
        self._frame = site.ros2.frame
        self._space = (room, topic_part(name))
        self.action = "/".join(("", *self._space, "navigate_to_pose"))
        self.on_step: Callable[[PilotStep], None] = lambda _: None
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
            self._camera = RosCamera(carrier, self._lens, self._frames, blanker, names)
        self._paper: PaperInterface | None = None
        if has_paper_names:
            speed = site.limits.nudge_speed
            self._paper = PaperInterface(name, speed, self._frames)
        self._step: PilotStep | None = None
        self._link: LinkStatus | None = None
        self._planned: tuple[Any, ...] = ()

    def begin(self, bus: Bus, stack: ExitStack) -> None:
        """Offer topics, and listen."""
        carrier, topics = self._carrier, DroneTopics(self.name)
        for topic in DRONE_TOPICS:
            if self._camera is not None or not topic.name.startswith("camera/"):
                carrier.advertise(topic, self._name(topic))
        if self._paper is not None:
            for topic in PAPER_TOLD:
                carrier.advertise(topic, topic.name)
        stack.callback(bus.subscribe(topics.step, self._on_step).close)
        stack.callback(bus.subscribe(topics.trajectory, self._on_trajectory).close)
        stack.callback(bus.subscribe(topics.link, self._on_link).close)
        if self._camera is not None:
            stack.callback(bus.subscribe(topics.video, self._on_video).close)

    def offered(self, desk: FlightDesk) -> Offered:
        """Yield what may be asked of it."""
        for what, wish, is_safer in (
            ("takeoff", desk.take_off, False),
            ("land", desk.land, True),
            ("stop", desk.stop, True),
            ("home", desk.home, False),
        ):
            name = "/".join(("", *self._space, what))
            stops = (self.name,) if wish == desk.stop else ()
            yield RosService(name, partial(wish, self.name), is_safer, stops)
        yield RosInput(self._name(GOAL), GOAL, partial(self._on_goal, desk))
        if self._paper is not None:
            yield from self._paper.offered(desk)

    def set_mode(self, mode: HouseMode) -> None:
        """Tell the mode of the house."""
        if self._camera is not None:
            self._camera.set_mode(mode)

    def statuses(self) -> list[Any]:
        """Return how the drone is, for diagnostics."""
        step, link = self._step, self._link
        found = [] if step is None else [diagnostics.flight_status(self.name, step)]
        return found if link is None else [*found, diagnostics.link_status(self.name, link)]

    def _on_step(self, step: PilotStep) -> None:
        self._step = step
        self._line.heard(self.name, step)
        self.on_step(step)
        if self._camera is not None:
            self._camera.add_step(step)
        for topic, make in self._messages.of(step, self._wall.offset()):
            self._carrier.publish(topic, self._name(topic), make)
        if self._paper is not None:
            for topic, make in self._paper.of(step, self._wall.offset()):
                self._carrier.publish(topic, topic.name, make)

    def _on_trajectory(self, planned: PlannedTrajectory) -> None:
        if planned.points != self._planned:  # it is said again and again
            self._planned = planned.points
            make = partial(trajectory_message, planned, self._wall.offset(), self._frames)
            self._carrier.publish(TRAJECTORY, self._name(TRAJECTORY), make)

    def _on_link(self, link: LinkStatus) -> None:
        self._link = link

    def _on_video(self, frame: VideoFrame) -> None:
        assert self._camera is not None
        self._camera.show(frame, self._wall.offset())

    def _on_goal(self, desk: FlightDesk, goal: Any) -> RosReply:
        frame, place, turn = goal.header.frame_id, goal.pose.position, goal.pose.orientation
        if frame not in ("", self._frame):
            words = f"goal refused: its frame is {frame!r}; allowed: {self._frame!r}"
            return RosReply(False, words)
        quaternion = (turn.w, turn.x, turn.y, turn.z)
        yaw = yaw_of(quaternion) if any(quaternion) else None
        reply = desk.fly_to(self.name, (place.x, place.y), yaw)
        words = f"goal x {place.x:.2f}, y {place.y:.2f} for {self.name}: {reply.message}"
        return RosReply(reply.success, words)

    def _name(self, topic: RosTopic) -> str:
        return full_name(topic, *self._space)
