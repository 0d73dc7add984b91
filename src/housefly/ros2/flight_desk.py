"""What comes in the terms of ROS and moves a drone: checked, asked of a person where it must be."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import cos, isfinite, sin
from threading import Lock
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import TASKS_QUERY
from housefly.clock import Clock
from housefly.errors import HouseflyError
from housefly.geometry import Vec2, Vec3
from housefly.messages import Order, OrderKind
from housefly.ros2.order_line import OrderLine, RosReply
from housefly.ros2.question_desk import QuestionDesk
from housefly.ros2.ros_caller import FLIGHTS_ARE_OFF, RosCaller
from housefly.tasks.api.answers import TaskBoard, TasksAnswer
from housefly.tasks.api.json import (
    task_answer_from_json,
    task_question_to_json,
)
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    RequestTask,
    TaskQuestion,
)
from housefly.tasks.api.values import (
    Confirm,
    ParameterValue,
    RequestSurface,
)

GO_SERVICE = "fly_to"
"""The service that flies to a point."""
_PATIENCE = 1.0
"""How long memory and board may take to answer [s]."""
_ASK_PATIENCE = 120.0
"""How long the tasks may take, which rehearse first [s]."""
_FLIGHT_PERIOD = 0.2
"""Between two orders to fly of one drone [s]."""
_FACES_AHEAD = 2.0
"""A heading is faced by looking at a point so far ahead [m]."""


class FlightDesk:
    """Takes the wishes of one caller; thread-safe.

    Args:
        bus: of the run.
        line: to the pilots.
        caller: whose wishes it takes.
        has_tasks: whether services run; without them nobody can be asked.
        clock: monotonic.

    Attributes:
        questions: answers what the caller asks.
    """

    def __init__(
        self, bus: Bus, line: OrderLine, caller: RosCaller, has_tasks: bool, clock: Clock
    ) -> None:
        self._bus, self._line, self._clock = bus, line, clock
        self._caller, self._requests = caller, caller.requests
        self.questions = QuestionDesk(bus, caller)
        self._has_tasks = has_tasks
        self._asking = Lock()
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
            return RosReply(False, FLIGHTS_ARE_OFF)
        return self._flown(drone, OrderKind.HOME)

    def reset(self, drone: str) -> RosReply:
        """End an emergency on the ground; stop what flies."""
        if self._line.is_airborne(drone):
            return self.stop(drone)
        if not self._caller.may_fly:
            return RosReply(False, FLIGHTS_ARE_OFF)
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

    def refusal(self, goal: Vec2) -> str:
        """Return why nobody is even asked to fly to a point [m], in words, or ""."""
        if not all(map(isfinite, goal)):
            return f"the goal {goal} is no point; allowed: finite metres"
        return FLIGHTS_ARE_OFF if self._requests == "off" else ""

    def board(self) -> TaskBoard:
        """Return what the tasks do; raises LinkError."""
        board: TaskBoard = self._ask_tasks(BoardQuestion(), _PATIENCE)
        return board

    def holder(self, drone: str) -> Order | None:
        """Return the order by which a drone flies; None on the ground."""
        return self._line.holder(drone)

    def call_off(self, drone: str, order: str, task: int) -> RosReply:
        """End what a wish began: a drone that it flies holds its place, a task comes home.

        Args:
            drone: its name.
            order: as the reply to the wish said it.
            task: likewise.
        """
        if task:
            taken_back = CancelTask(task, self._caller.name, only_of=self._caller.owner)
            try:
                self._ask_tasks(taken_back, _ASK_PATIENCE)
            except HouseflyError as error:
                return RosReply(False, str(error))
            return RosReply(True, f"task {task} is called off", task=task)
        holder = self._line.holder(drone)
        if holder is None or holder.id != order:
            return RosReply(True, "nothing flies by it any more")
        reply = self._ordered(drone, OrderKind.HOVER)
        if not reply.success:  # not in every phase; a STOP is taken in each
            reply = self._ordered(drone, OrderKind.STOP)
        self._line.give_back(drone, reply.order)
        return reply

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
            return RosReply(False, FLIGHTS_ARE_OFF)
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
        words = f"task {task.id}: {task.state.value}{waits}"
        return RosReply(True, words, task=task.id)

    def _take_back(self, number: int) -> None:
        self._question = 0
        tasks = self.board().tasks
        if any(one.id == number and one.question is not None for one in tasks):
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
