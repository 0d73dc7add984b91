"""The room in the terms of ROS: map, things, people, sensors, tasks, and its drones."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import partial
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY, OBSTACLE_TOPIC, TASKS_QUERY
from housefly.clock import RealClock
from housefly.config.house_mode import HouseMode
from housefly.config.process_log import log_traceback
from housefly.errors import LinkError
from housefly.geometry import Vec3
from housefly.hub.api.answers import (
    News,
    PictureAnswer,
    PlacedThing,
    SensorsAnswer,
    SituationAnswer,
)
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import PictureQuestion, Question, SensorsQuestion
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.hub.wall_clock import WallClock
from housefly.messages import Obstacle
from housefly.record import ros_messages
from housefly.record.ros_topics import topic_part
from housefly.room.tracked import untracked, untracked_grid
from housefly.ros2 import diagnostics, room_messages
from housefly.ros2.carrier import RosCarrier
from housefly.ros2.drone_messages import text_message
from housefly.ros2.flight_desk import FlightDesk
from housefly.ros2.order_line import OrderLine, RosReply
from housefly.ros2.ros_caller import RosCaller
from housefly.ros2.ros_drone import RosDrone
from housefly.ros2.static_frames import static_frames, static_transforms
from housefly.ros2.topic_table import (
    ANSWERS,
    ASK,
    DIAGNOSTICS,
    MAP,
    OBSTACLES,
    PEOPLE,
    ROOM_EVENTS,
    ROOM_MARKERS,
    ROOM_TOPICS,
    SITUATIONS,
    STATIC_TRANSFORMS,
    TASKS,
    THING_MARKERS,
    THINGS,
    TRANSFORMS,
    RosTopic,
    full_name,
)
from housefly.ros2.wishes import NOTHING_TO_SAY, Offered, RosInput, RosService, Tell, replied
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.api.answers import ServicesAnswer, TaskBoard
from housefly.tasks.api.json import task_answer_from_json, task_question_to_json
from housefly.tasks.api.questions import BoardQuestion, ServicesQuestion
from housefly.tasks.api.topics import TASK_NEWS_TOPIC

_LOOK_PERIOD = 1.0
"""How often sensors are asked for, and what is in the way is told [s]."""
_OBSTACLE_PERIOD = 0.2
_OBSTACLE_AGE_MAX = 1.0
"""What was seen longer ago is not in the way any more [s]."""
_PERSON, _STRUCTURE = "person", "structure"


class RosRoom:
    """The room and its drones.

    Args:
        loaded: the site.
        bus: of the run.
        carrier: of their topics.

    Attributes:
        errands: services of the tasks that need no parameter, once the tasks have named them.
        on_errands: is told when they are known.
        drones: in the order of the site.
    """

    def __init__(self, loaded: LoadedSite, bus: Bus, carrier: RosCarrier) -> None:
        site = loaded.site
        self._loaded, self._site, self._bus, self._carrier = loaded, site, bus, carrier
        self.errands: tuple[str, ...] = ()
        self.on_errands: Callable[[], None] = lambda: None
        self._wall, self._clock = WallClock(), RealClock()
        self._room = site.ros2.namespace or topic_part(site.name).lower()
        self._line = OrderLine(bus, site.drone_names, self._clock)
        self.drones = tuple(
            RosDrone(
                site.for_drone(name),
                self._room,
                carrier,
                self._line,
                self._wall,
                has_paper_names=site.ros2.paper_names and number == 0,
            )
            for number, name in enumerate(site.drone_names)
        )
        self._things: dict[str, PlacedThing] = {}
        self._obstacles: dict[tuple[str, str], Obstacle] = {}
        self._places: dict[str, tuple[Vec3 | None, str]] = {}
        self._situations: tuple[SituationAnswer, ...] | None = None
        self._lock = threading.Lock()

    def begin(self, stack: ExitStack) -> None:
        """Offer topics, and listen; what is listened to is closed with the stack."""
        bus = self._bus
        for topic in (*ROOM_TOPICS, TRANSFORMS, STATIC_TRANSFORMS):
            self._carrier.advertise(topic, self._name(topic))
        self._tell_what_stands()
        for drone in self.drones:
            drone.begin(bus, stack)
        for subscription in (
            bus.subscribe(ROOM_NEWS_TOPIC, self._on_news),
            bus.subscribe(OBSTACLE_TOPIC, self._on_obstacle),
            bus.subscribe(TASK_NEWS_TOPIC, self._on_board),
        ):
            stack.callback(subscription.close)
        if not self._site.tasks.enabled:
            self._set_mode(HouseMode.HOME)

    def desk(self, caller: RosCaller) -> FlightDesk:
        """Return what takes the wishes of a caller."""
        return FlightDesk(self._bus, self._line, caller, self._site.tasks.enabled, self._clock)

    def offered(self, desk: FlightDesk, tell: Tell) -> Offered:
        """Yield what may be asked, at a desk; ``tell`` publishes answers to whoever asked."""
        every = self._site.drone_names
        for what, wish, stops in (("stop", desk.stop, every), ("land", desk.land, ())):
            yield RosService(f"/{self._room}/{what}", partial(self._all, wish), True, stops)
        yield RosInput(self._name(ASK), ASK, partial(self._asked, desk, tell))
        for drone in self.drones:
            yield from drone.offered(desk)
        yield from self.offered_errands(desk)

    def offered_errands(self, desk: FlightDesk) -> Iterator[RosService]:
        """Yield a service for each errand that is known by now."""
        for name in self.errands:
            yield RosService(f"/{self._room}/tasks/{name}", partial(desk.request, name, {}))

    def look(self, ended: Callable[[float], bool]) -> None:
        """Tell again and again what nobody publishes, until the end.

        Args:
            ended: waits for so long [s]; returns whether that was the end.
        """
        begun = [self._ask_picture, self._ask_board, self._ask_errands]
        looked_at = float("-inf")
        while not ended(_OBSTACLE_PERIOD):
            try:
                self._tell_obstacles()
                if time.monotonic() - looked_at >= _LOOK_PERIOD:
                    looked_at = time.monotonic()
                    while begun:
                        begun[0]()
                        begun.pop(0)
                    self._tell_health()
            except LinkError:
                continue  # memory or tasks are being started again
            except Exception:  # one look; the next may do
                log_traceback()

    def _tell_what_stands(self) -> None:
        at, frame = self._wall.now(), self._site.ros2.frame
        loaded, site = self._loaded, self._site
        grid = untracked_grid(loaded.room, site, loaded.grid)
        self._tell(MAP, partial(ros_messages.occupancy, at, grid, frame))
        solids = untracked(loaded.room, site).solids
        self._tell(ROOM_MARKERS, partial(room_messages.room_markers, at, frame, solids))
        frames = static_frames(loaded)
        self._tell(STATIC_TRANSFORMS, partial(static_transforms, at, frames))

    def _on_news(self, news: News) -> None:
        with self._lock:
            self._things |= {one.thing: one for one in news.things}
        if news.things:
            self._tell_things()
        for event in news.events:
            text = room_messages.json_text(event)
            self._tell(ROOM_EVENTS, partial(text_message, text))
        self._tell_situations(news.situations)

    def _tell_situations(self, situations: tuple[SituationAnswer, ...]) -> None:
        if situations != self._situations:
            self._situations = situations
            self._tell(SITUATIONS, partial(text_message, room_messages.json_text(situations)))

    def _tell_things(self) -> None:
        """Tell where people are, and things where one of them has moved."""
        with self._lock:
            things = tuple(one for one in self._things.values() if one.kind != _STRUCTURE)
        at, frame = self._wall.now(), self._site.ros2.frame
        people = [one for one in things if one.kind == _PERSON]
        self._tell(PEOPLE, partial(room_messages.people_message, at, frame, people))
        others = tuple(one for one in things if one.kind != _PERSON)
        places = {one.thing: (_rounded(one.position), one.inside) for one in others}
        if places != self._places:
            self._places = places
            self._tell(THING_MARKERS, partial(room_messages.thing_markers, at, frame, others))
            self._tell(THINGS, partial(text_message, room_messages.json_text(others)))

    def _on_obstacle(self, seen: Obstacle) -> None:
        with self._lock:
            self._obstacles[seen.source, seen.id] = seen

    def _tell_obstacles(self) -> None:
        now = self._clock.now()
        with self._lock:
            self._obstacles = {
                key: one
                for key, one in self._obstacles.items()
                if one.confidence > 0.0 and now - one.seen_at < _OBSTACLE_AGE_MAX
            }
            there = tuple(self._obstacles.values())
        at, frame = self._wall.now(), self._site.ros2.frame
        self._tell(OBSTACLES, partial(room_messages.obstacle_markers, at, frame, there))

    def _on_board(self, board: TaskBoard) -> None:
        self._set_mode(board.mode)
        self._tell(TASKS, partial(text_message, room_messages.json_text(board)))

    def _set_mode(self, mode: HouseMode) -> None:
        for drone in self.drones:
            drone.set_mode(mode)

    def _ask_picture(self) -> None:
        if self._site.hub.enabled:
            picture: PictureAnswer = self._asked_memory(PictureQuestion())
            with self._lock:
                self._things = {one.thing: one for one in picture.things} | self._things
            self._tell_things()
            self._tell_situations(picture.situations)

    def _ask_board(self) -> None:
        if self._site.tasks.enabled:
            question = BoardQuestion()
            text = self._bus.ask(TASKS_QUERY, task_question_to_json(question))
            self._on_board(task_answer_from_json(question, text))

    def _tell_health(self) -> None:
        statuses = [status for drone in self.drones for status in drone.statuses()]
        if self._site.hub.enabled and self._carrier.is_heard(self._name(DIAGNOSTICS)):
            answer: SensorsAnswer = self._asked_memory(SensorsQuestion())
            statuses += [diagnostics.sensor_status(sensor) for sensor in answer.sensors]
        at = self._wall.now()
        self._tell(DIAGNOSTICS, partial(diagnostics.diagnostics_message, at, statuses))

    def _asked_memory(self, question: Question) -> Any:
        return answer_from_json(question, self._bus.ask(HUB_QUERY, question_to_json(question)))

    def _ask_errands(self) -> None:
        """Learn which services of the room need no parameter."""
        if self._site.tasks.enabled:
            question = ServicesQuestion()
            text = self._bus.ask(TASKS_QUERY, task_question_to_json(question))
            answer: ServicesAnswer = task_answer_from_json(question, text)
            self.errands = tuple(
                info.name
                for info in answer.services
                if not any(parameter.required for parameter in info.parameters)
            )
            self.on_errands()

    def _asked(self, desk: FlightDesk, tell: Tell, said: Any) -> RosReply:
        answer = desk.questions.ask(said.data)
        tell(ANSWERS, self._name(ANSWERS), partial(text_message, answer))
        return NOTHING_TO_SAY

    def _all(self, wish: Callable[[str], RosReply]) -> RosReply:
        replies = {name: replied(partial(wish, name)) for name in self._site.drone_names}
        words = "; ".join(f"{name}: {reply.message}" for name, reply in replies.items())
        return RosReply(all(reply.success for reply in replies.values()), words)

    def _tell(self, topic: RosTopic, make: Callable[[], Any]) -> None:
        self._carrier.publish(topic, self._name(topic), make)

    def _name(self, topic: RosTopic) -> str:
        return full_name(topic, self._room)


def _rounded(position: Vec3 | None) -> Vec3 | None:
    """Return a place to the centimetre: noise is no news."""
    if position is None:
        return None
    x, y, z = position
    return round(x, 2), round(y, 2), round(z, 2)
