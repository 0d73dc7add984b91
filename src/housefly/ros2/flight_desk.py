"""What comes in the terms of ROS and moves a drone: checked, asked of a person where it must be."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from math import cos, isfinite, sin
from threading import BoundedSemaphore, Lock
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY, TASKS_QUERY
from housefly.clock import Clock
from housefly.errors import HouseflyError, TaskError, WireError
from housefly.geometry import Vec2, Vec3
from housefly.hub.api.json import question_from_json
from housefly.messages import OrderKind
from housefly.ros2.order_line import OrderLine, RosReply
from housefly.ros2.ros_caller import RosCaller
from housefly.tasks.api.answers import TaskBoard, TasksAnswer
from housefly.tasks.api.json import (
    task_answer_from_json,
    task_question_from_json,
    task_question_to_json,
)
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    RequestTask,
    Sentence,
    TaskQuestion,
)
from housefly.tasks.api.values import (
    Confirm,
    ParameterValue,
    ReasonCode,
    RequestSurface,
)
from housefly.tasks.rules.outside_question import outside_question

GO_SERVICE = "fly_to"
"""The service that flies to a point."""
_PATIENCE = 1.0
"""How long memory and board may take to answer [s]."""
_ASK_PATIENCE = 120.0
"""How long the tasks may take, which rehearse first [s]."""
_ASKED_AT_ONCE = 2
"""A rehearsal takes seconds; who waits for one holds up nobody's STOP."""
_FLIGHT_PERIOD = 0.2
"""Between two orders to fly of one drone [s]."""
_FACES_AHEAD = 2.0
"""A heading is faced by looking at a point so far ahead [m]."""
_OFF = "flights are off for you: requests in the site file, or your role"
_NO_QUESTIONS = "you may look, not ask: your role"


class FlightDesk:
    """Takes the wishes of one caller; thread-safe.

    Args:
        bus: of the run.
        line: to the pilots.
        caller: whose wishes it takes.
        has_tasks: whether services run; without them nobody can be asked.
        clock: monotonic.
    """

    def __init__(
        self, bus: Bus, line: OrderLine, caller: RosCaller, has_tasks: bool, clock: Clock
    ) -> None:
        self._bus, self._line, self._clock = bus, line, clock
        self._caller, self._requests = caller, caller.requests
        self._has_tasks = has_tasks
        self._asking, self._answering = Lock(), BoundedSemaphore(_ASKED_AT_ONCE)
        self._flown_at: dict[str, float] = {}
        self._question = 0

    def stop(self, drone: str) -> RosReply:
        """Stop a drone, whoever flies it."""
        return self._ordered(drone, OrderKind.STOP)

    def land(self, drone: str) -> RosReply:
        """Land a drone where it is, whoever flies it."""
        return self._ordered(drone, OrderKind.LAND)

    def home(self, drone: str) -> RosReply:
        """Bring a drone home."""
        if self._requests == "off" or not self._caller.may_fly:
            return RosReply(False, _OFF)
        return self._flown(drone, OrderKind.HOME)

    def reset(self, drone: str) -> RosReply:
        """End an emergency on the ground; stop what flies."""
        if self._line.is_airborne(drone):
            return self.stop(drone)
        if not self._caller.may_fly:
            return RosReply(False, _OFF)
        return self._ordered(drone, OrderKind.RESET)

    def nudge(self, drone: str, velocity: Vec3) -> str:
        """Move a drone that holds its place by hand [m/s]; return why not, in words, or ""."""
        if self._requests != "auto":
            return 'moving by hand needs requests = "auto" in the site file'
        sender = self._caller.name
        words = self._line.objection(drone, sender)
        if not words:
            order = self._line.new_order(OrderKind.NUDGE, sender)
            self._line.publish(drone, replace(order, velocity=velocity))
        return words

    def take_off(self, drone: str) -> RosReply:
        """Take off and hover, once a person has said yes where the site wants it."""
        if self._requests == "auto":
            return self._flown(drone, OrderKind.TAKE_OFF)
        return self.request(GO_SERVICE, {}, drone)

    def fly_to(self, drone: str, goal: Vec2, yaw: float | None = None) -> RosReply:
        """Fly to a point [m], face a heading [rad], and hover there."""
        if not all(map(isfinite, (*goal, yaw or 0.0))):
            return RosReply(False, f"the goal {goal} is no point; allowed: finite metres")
        if self._requests == "auto":
            ahead: Vec3 | None = None
            if yaw is not None:
                x, y = goal
                ahead = (x + _FACES_AHEAD * cos(yaw), y + _FACES_AHEAD * sin(yaw), 1.0)
            return self._flown(drone, OrderKind.GO, goal, ahead)
        return self.request(GO_SERVICE, {"x": goal[0], "y": goal[1]}, drone)

    def request(
        self, service: str, parameters: Mapping[str, ParameterValue], drone: str = ""
    ) -> RosReply:
        """Ask for a service; a wish of ours that still waits for a yes is taken back."""
        if self._requests == "off":
            return RosReply(False, _OFF)
        if not self._has_tasks:
            return RosReply(False, "no services run here ([tasks] enabled in the site file)")
        if not self._asking.acquire(blocking=False):
            return RosReply(False, "the last wish is still being looked at")
        try:
            return self._requested(service, parameters, drone)
        except HouseflyError as error:
            return RosReply(False, str(error))
        finally:
            self._asking.release()

    def ask(self, text: str) -> str:
        """Return the answer, as JSON, to a sentence or to a question of memory or tasks as JSON."""
        if not self._caller.may_ask:
            return json.dumps({"error": _NO_QUESTIONS})
        if not self._answering.acquire(blocking=False):
            return json.dumps({"error": f"{_ASKED_AT_ONCE} questions are being answered already"})
        try:
            if not text.lstrip().startswith("{"):
                return self._sentence(text)
            return self._question_answered(text)
        except (HouseflyError, ValueError, RecursionError) as error:
            return json.dumps({"error": str(error)})
        finally:
            self._answering.release()

    def _sentence(self, text: str) -> str:
        # Checked like any question from outside: its length, its letters.
        said = task_question_from_json(json.dumps({"ask": "sentence", "text": text}))
        return self._asked_tasks(task_question_to_json(said))

    def _question_answered(self, text: str) -> str:
        tree = json.loads(text)
        if not isinstance(tree, dict):
            raise WireError("this is no JSON object")
        try:
            question_from_json(text)
        except WireError:
            return self._asked_tasks(json.dumps({"ask": "request", **tree}))
        return self._bus.ask(HUB_QUERY, text, _PATIENCE)

    def _asked_tasks(self, text: str) -> str:
        question = outside_question(
            text,
            by=self._caller.name,
            owner=self._caller.owner,
            surface=RequestSurface.ROS,
            is_trusted=self._requests == "auto",
        )
        if self._requests == "off" and isinstance(question, RequestTask):
            raise TaskError(_OFF, ReasonCode.NOT_ALLOWED.value)
        if self._requests == "off" and isinstance(question, Sentence):
            question = replace(question, fly=False)
        if isinstance(question, CancelTask) and not self._caller.may_fly:
            question = replace(question, only_of=self._caller.owner)
        return self._bus.ask(TASKS_QUERY, task_question_to_json(question), _ASK_PATIENCE)

    def _requested(
        self, service: str, parameters: Mapping[str, ParameterValue], drone: str
    ) -> RosReply:
        if self._question:
            self._take_back(self._question)
        question = RequestTask(
            service,
            dict(parameters),
            self._caller.name,
            RequestSurface.ROS,
            confirm=Confirm.AUTO if self._requests == "auto" else Confirm.ASK,
            owner=self._caller.owner,
            drone=drone,
        )
        answer: TasksAnswer = self._ask_tasks(question, _ASK_PATIENCE)
        (task,) = answer.tasks
        self._question = task.id if task.question is not None else 0
        waits = ": a person must say yes in the console" if self._question else ""
        return RosReply(True, f"task {task.id}: {task.state.value}{waits}")

    def _take_back(self, number: int) -> None:
        self._question = 0
        board: TaskBoard = self._ask_tasks(BoardQuestion(), _PATIENCE)
        if any(one.id == number and one.question is not None for one in board.tasks):
            taken_back = CancelTask(number, self._caller.name, only_of=self._caller.owner)
            self._ask_tasks(taken_back, _PATIENCE)

    def _ask_tasks(self, question: TaskQuestion, patience: float) -> Any:
        text = self._bus.ask(TASKS_QUERY, task_question_to_json(question), patience)
        return task_answer_from_json(question, text)

    def _flown(
        self,
        drone: str,
        kind: OrderKind,
        goal: Vec2 | None = None,
        look_at: Vec3 | None = None,
    ) -> RosReply:
        if words := self._line.objection(drone, self._caller.name):
            return RosReply(False, words)
        now = self._clock.now()
        if now - self._flown_at.get(drone, -_FLIGHT_PERIOD) < _FLIGHT_PERIOD:
            return RosReply(False, f"too many wishes: one in {_FLIGHT_PERIOD:g} s is taken")
        self._flown_at[drone] = now
        return self._ordered(drone, kind, goal, look_at)

    def _ordered(
        self,
        drone: str,
        kind: OrderKind,
        goal: Vec2 | None = None,
        look_at: Vec3 | None = None,
    ) -> RosReply:
        order = self._line.new_order(kind, self._caller.name)
        return self._line.ordered(drone, replace(order, goal=goal, look_at=look_at))
