"""Does what Home Assistant asks for: STOP at once, all else within limits and by the site's rules.

A flight is a task, with all that a task has: the mode of the house, a rehearsal, the queue, and a
person's yes unless the site says that what comes from there flies by itself.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Collection, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import TASKS_QUERY, DroneTopics
from housefly.clock import Clock
from housefly.config.homeassistant import HomeAssistantConfig
from housefly.errors import HouseflyError, LinkError, TaskError, WireError
from housefly.homeassistant.commands import (
    AnswerCommand,
    DroneCommand,
    DroneVerb,
    YesOrNo,
    answer_command,
    drone_command,
)
from housefly.homeassistant.room_entities import asking_task
from housefly.homeassistant.topics import HomeTopics
from housefly.messages import Order, OrderKind
from housefly.messages.flight import OrderSource
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.json import task_answer_from_json, task_question_to_json
from housefly.tasks.api.questions import ReplyToTask, RequestTask, TaskQuestion
from housefly.tasks.api.values import Confirm, PersonQuestion, ReasonCode, RequestSurface

ASKER = "Home Assistant"
"""Who asks, for people."""
_OWNER = "homeassistant"
_PATIENCE = 10.0
"""How long the tasks may take to answer [s]."""
_ORDERS = {
    DroneVerb.LAND: OrderKind.LAND,
    DroneVerb.HOVER: OrderKind.HOVER,
    DroneVerb.HOME: OrderKind.HOME,
}
"""They end a flight, so nobody is asked first."""
_VISITOR, _LOOK = "visitor", "look"
"""The services behind "start" and "Go to"."""
_ORDERS_A_SECOND, _REQUESTS_A_MINUTE = 5, 20


@dataclass(slots=True)
class _Pace:
    """At most so many in a time [s]."""

    count: int
    period: float
    _taken: deque[float] = field(default_factory=deque)

    def admits(self, now: float) -> bool:
        while self._taken and now - self._taken[0] >= self.period:
            self._taken.popleft()
        if len(self._taken) >= self.count:
            return False
        self._taken.append(now)
        return True


class HomeRequests:
    """Does what messages ask for.

    Args:
        config: what may be asked.
        topics: on which it is asked.
        places: to which a drone may be sent, by name.
        stops: sends STOP to each drone on its own path; each must return at once.
        bus: where orders go, and where the tasks are.
        board: tells the board of the tasks, None while nobody keeps it.
        clock: stamps orders, and for the limits.
    """

    def __init__(
        self,
        config: HomeAssistantConfig,
        topics: HomeTopics,
        places: Collection[str],
        stops: Mapping[str, Callable[[], Future[bool]]],
        bus: Bus,
        board: Callable[[], TaskBoard | None],
        clock: Clock,
    ) -> None:
        self._config, self._topics, self._places = config, topics, frozenset(places)
        self._stops, self._bus, self._board, self._clock = stops, bus, board, clock
        self._drones = {topics.drone_command(name): name for name in stops}
        self._orders = _Pace(_ORDERS_A_SECOND, 1.0)
        self._requests = _Pace(_REQUESTS_A_MINUTE, 60.0)
        self._lock = threading.Lock()
        self._stopping: dict[str, Future[None]] = {}
        self._thread = ThreadPoolExecutor(1, "home-stop")

    def is_stop(self, topic: str, payload: bytes) -> bool:
        """Return whether a message says STOP: that is never too much, and waits for nothing."""
        return topic in self._drones and payload.strip() == DroneVerb.STOP.value.encode()

    def stop(self, topic: str) -> None:
        """Send STOP to the drone of a topic, on its own path and over the bus; returns at once."""
        name = self._drones[topic]
        self._stops[name]()
        before = self._stopping.get(name)
        if before is None or before.done():  # a button held down fills no queue
            self._stopping[name] = self._thread.submit(self._publish, name, OrderKind.STOP)

    def is_order(self, topic: str, payload: bytes) -> bool:
        """Return whether a message is an order to the pilot, for which nobody is asked."""
        orders = {verb.value.encode() for verb in _ORDERS}
        return topic in self._drones and payload.strip() in orders

    def close(self) -> None:
        """Shut the thread down without waiting."""
        self._thread.shutdown(wait=False, cancel_futures=True)

    def take(self, topic: str, payload: bytes) -> str:
        """Do what a message asks for and return what came of it, in words; may take seconds."""
        try:
            if topic == self._topics.answer_command:
                return self._answer(answer_command(payload))
            if topic in self._drones:
                return self._fly(self._drones[topic], drone_command(payload))
            raise WireError("nothing is asked on this topic")
        except HouseflyError as error:
            return f"refused: {error}"

    def _fly(self, drone: str, command: DroneCommand) -> str:
        self._check_allowed()
        if command.verb in _ORDERS:
            with self._lock:
                if not self._orders.admits(self._clock.now()):
                    raise TaskError("too many orders in a second", ReasonCode.RATE_LIMIT.value)
            self._publish(drone, _ORDERS[command.verb])
            return f"told {drone}: {_ORDERS[command.verb].value}"
        if command.verb is DroneVerb.GO and command.place not in self._places:
            raise TaskError(f"there is no place {command.place!r}", ReasonCode.UNKNOWN_PLACE.value)
        self._admit_request()
        goes = command.verb is DroneVerb.GO
        asked = RequestTask(
            _LOOK if goes else _VISITOR,
            {"subject": command.place} if goes else {},
            ASKER,
            RequestSurface.MQTT,
            cause="mqtt",
            confirm=Confirm.AUTO if self._config.requests == "auto" else Confirm.ASK,
            owner=_OWNER,
            drone=drone if len(self._stops) > 1 else "",
        )
        task = self._asked(asked).tasks[0]
        return f"{task.title}: {task.state.value}"

    def _answer(self, command: AnswerCommand) -> str:
        self._check_allowed()
        task, question = self._meant(command)
        choice = _choice(command.choice, question)
        if choice != question.otherwise and not self._config.answers:
            raise TaskError(
                "homeassistant.answers = false: only no is said there", ReasonCode.NOT_ALLOWED.value
            )
        self._admit_request()
        answered = self._asked(ReplyToTask(task, question.id, choice, ASKER)).tasks[0]
        return f"{answered.title}: {answered.state.value}"

    def _meant(self, command: AnswerCommand) -> tuple[int, PersonQuestion]:
        """Return the question that is meant, with its task; raises TaskError for none, or two."""
        board = self._board()
        asking = [one for one in board.tasks if one.question is not None] if board else []
        if command.task:
            asking = [one for one in asking if one.id == command.task]
        elif len(asking) > 1:
            words = f"{len(asking)} questions wait: say which is meant, by its task"
            raise TaskError(words, ReasonCode.BAD_PARAMETER.value)
        task = asking_task(board) if not command.task else next(iter(asking), None)
        question = task.question if task is not None else None
        if task is None or question is None or command.question not in ("", question.id):
            raise TaskError("nobody asks that any more", ReasonCode.BAD_PARAMETER.value)
        return task.id, question

    def _check_allowed(self) -> None:
        if self._config.requests == "off":
            words = 'homeassistant.requests = "off": only STOP is heard'
            raise TaskError(words, ReasonCode.NOT_ALLOWED.value)

    def _admit_request(self) -> None:
        with self._lock:
            if not self._requests.admits(self._clock.now()):
                words = f"more than {_REQUESTS_A_MINUTE} requests in a minute"
                raise TaskError(words, ReasonCode.RATE_LIMIT.value)

    def _asked(self, question: TaskQuestion) -> Any:
        try:
            text = self._bus.ask(TASKS_QUERY, task_question_to_json(question), _PATIENCE)
        except LinkError as error:
            raise LinkError("the services of the house do not answer") from error
        return task_answer_from_json(question, text)

    def _publish(self, drone: str, kind: OrderKind) -> None:
        order = Order(kind, issued_at=self._clock.now(), sender=ASKER, source=OrderSource.PROGRAM)
        self._bus.publish(DroneTopics(drone).order, order)


def _choice(said: YesOrNo | str, question: PersonQuestion) -> str:
    """Return a choice of a question: yes is its first, no the one that counts without an answer."""
    by_word = {YesOrNo.YES: question.choices[0], YesOrNo.NO: question.otherwise}
    choice = by_word[said] if isinstance(said, YesOrNo) else said
    if choice not in question.choices:
        allowed = " or ".join(question.choices)
        raise TaskError(f"{choice!r} is no answer: {allowed}", ReasonCode.BAD_PARAMETER.value)
    return choice
