"""One message of everything that the live view listens to, told on a bus again and again."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import replace

from filming import video

from housefly.bus.bus import Bus
from housefly.bus.topics import FRAME_TOPIC, OBSTACLE_TOPIC, ROOM_TOPICS, DroneTopics
from housefly.config.house_mode import HouseMode
from housefly.config.site import Site
from housefly.hub.api.answers import EventAnswer, News, SituationAnswer
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.messages import (
    LEVEL,
    Action,
    Command,
    DroneStatus,
    Estimate,
    Event,
    EventCode,
    Inputs,
    LinkStatus,
    Obstacle,
    ObstacleKind,
    Outputs,
    Path,
    Phase,
    PilotStep,
    PlannedTrajectory,
    Pose,
    Reference,
    Severity,
    Sighting,
    Telemetry,
    TrackedFrame,
    TrajectoryPoint,
    VideoFrame,
)
from housefly.messages.words import Words, literal
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.topics import TASK_NEWS_TOPIC
from housefly.tasks.api.values import (
    Priority,
    ReasonCode,
    RequestSurface,
    TaskStage,
    TaskStatus,
)

PATH = Path(((1.0, 1.0), (3.0, 2.0)), 2.2, 0.8)


def step(now: float, sequence: int = 1) -> PilotStep:
    """Return a step of a flight, at a monotonic time [s]."""
    telemetry = Telemetry(now - 0.02, DroneStatus.FLYING, 0.8, phi=0.02, theta=0.05)
    estimate = Estimate(now - 0.01, (1.5, 1.2, 1.1), (0.3, 0.0, -0.1), 0.4, 0.01, 0.004)
    event = Event(now, Severity.WARNING, EventCode.BATTERY_WEAK, literal("the battery is weak"))
    outputs = Outputs(
        Command(Action.FLY, LEVEL),
        estimate,
        Reference((1.6, 1.3, 1.1), (0.0, 0.0, 0.0), 0.4),
        phase=Phase.OUTBOUND,
        goal_name="entrance",
        path=PATH,
        events=(event,),
    )
    return PilotStep(sequence, now, Inputs(telemetry=telemetry, late=0.002), outputs)


def board(mode: HouseMode = HouseMode.HOME, at: float = 1e9) -> TaskBoard:
    """Return what the tasks tell."""
    task = TaskStatus(
        7,
        "visitor",
        "See who is at the door",
        {},
        TaskStage.RUNNING,
        ReasonCode.OK,
        literal("flying"),
        "Kim",
        RequestSurface.CONSOLE,
        "",
        Priority.PERSON,
        at,
    )
    return TaskBoard(at, mode, literal("flies"), False, (task,), ())


def news(at: float) -> News:
    """Return what the hub tells."""
    event = EventAnswer(
        "door opened", "entrance", at, "door", "", 1.0, {}, Words("the door opened")
    )
    held = SituationAnswer("visitor waits", "entrance", at, 0.9, "bell", words=Words("waits"))
    return News(at, (), (event,), (held,), ())


class Talker:
    """Tells one of everything on a bus.

    Args:
        bus: where to.
        site: whose drone and bodies.
        mode: of the house.
    """

    def __init__(self, bus: Bus, site: Site, mode: HouseMode = HouseMode.HOME) -> None:
        self.bus, self.mode = bus, mode
        self._topics = DroneTopics(site.drone.name)
        self._bodies = (site.tracking.body, site.tracking.visitor)
        self._frames: Iterator[VideoFrame] = iter(())
        self._count = 0
        self.orders = self._topics.order
        self.keys = tuple(topic.key for topic in (*self._topics.all, *ROOM_TOPICS))

    def tell(self) -> None:
        """Tell everything once, at the time that it is."""
        now, self._count = time.monotonic(), self._count + 1
        bus, topics = self.bus, self._topics
        bus.publish(TASK_NEWS_TOPIC, board(self.mode, time.time()))
        bus.publish(ROOM_NEWS_TOPIC, news(time.time()))
        bus.publish(topics.step, step(now, self._count))
        points = tuple(
            TrajectoryPoint((*xy, 1.1 + n), float(n), 0.5) for n, xy in enumerate(PATH.waypoints)
        )
        bus.publish(topics.trajectory, PlannedTrajectory(now, points))
        bus.publish(topics.link, LinkStatus(now, True, True, True, 100.0, 200.0, 15.0))
        sightings = tuple(
            Sighting(body, Pose((1.0 + n, 2.0, 1.0)), now, now)
            for n, body in enumerate(self._bodies)
        )
        bus.publish(FRAME_TOPIC, TrackedFrame(sightings))
        person = Obstacle("p1", (2.0, 2.0), 0.3, top=1.8, seen_at=now, kind=ObstacleKind.PERSON)
        bus.publish(OBSTACLE_TOPIC, person)
        bus.publish(topics.video, self._frame(now))

    def tell_picture(self, data: bytes) -> None:
        """Tell one picture, whatever its bytes are."""
        now, self._count = time.monotonic(), self._count + 1
        frame = VideoFrame(data, True, 640, 360, self._count, now, now)
        self.bus.publish(self._topics.video, frame)

    def _frame(self, now: float) -> VideoFrame:
        frame = next(self._frames, None)
        if frame is None:
            self._frames = video(1.0, first=15 * self._count)
            frame = next(self._frames)
        return replace(frame, received_at=now, drone_time=now, sequence=self._count)
