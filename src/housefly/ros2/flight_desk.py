"""What comes from ROS and moves a drone: checked, asked of a person where the site wants it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import cos, isfinite, sin
from secrets import token_hex
from threading import Condition, Lock
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import TASKS_QUERY, DroneTopics
from housefly.clock import Clock
from housefly.config.ros2 import RosRequests
from housefly.errors import HouseflyError
from housefly.geometry import Vec2, Vec3
from housefly.messages import Order, OrderAnswer, OrderKind, OrderSource, PilotStep
from housefly.ros2.flight_lease import FlightLease
from housefly.ros2.sender import FLIGHTS_ARE_OFF, OWNER, SENDER
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
"""How long the pilot may take to answer an order [s]."""
_ASK_PATIENCE = 120.0
"""How long the tasks may take, which rehearse first [s]."""
_FLIGHT_PERIOD = 0.2
"""Between two orders to fly of one drone [s]."""
_FACES_AHEAD = 2.0
"""A heading is faced by looking at a point so far ahead [m]."""


@dataclass(frozen=True, slots=True)
class RosReply:
    """What became of a wish, as std_srvs/Trigger says it.

    Attributes:
        success, message: whether it is done, and why not, in words.
        order: id of the order that was given; "" for none.
        task: number of the task that was asked for; 0 for none.
    """

    success: bool
    message: str
    order: str = ""
    task: int = 0


class FlightDesk:
    """Takes wishes from ROS; thread-safe.

    Args:
        bus: of the run.
        requests: what the site allows.
        drones: their names.
        has_tasks: whether services run; without them nobody can be asked.
        clock: monotonic.
    """

    def __init__(
        self,
        bus: Bus,
        requests: RosRequests,
        drones: tuple[str, ...],
        has_tasks: bool,
        clock: Clock,
    ) -> None:
        self._bus, self._requests, self._clock = bus, requests, clock
        self._has_tasks = has_tasks
        self._topics = {name: DroneTopics(name) for name in drones}
        self._leases = {name: FlightLease() for name in drones}
        self._answers: dict[str, OrderAnswer | None] = {}
        self._answered = Condition()
        self._asking = Lock()
        self._flown_at: dict[str, float] = {}
        self._question = 0

    def heard(self, drone: str, step: PilotStep) -> None:
        """Take in a step of a drone's pilot."""
        self._leases[drone].add(step)
        if step.outputs.answers and self._answers:
            with self._answered:
                for answer in step.outputs.answers:
                    if answer.order_id in self._answers:
                        self._answers[answer.order_id] = answer
                self._answered.notify_all()

    def stop(self, drone: str) -> RosReply:
        """Stop a drone, whoever flies it."""
        return self._ordered(drone, OrderKind.STOP)

    def land(self, drone: str) -> RosReply:
        """Land a drone where it is, whoever flies it."""
        return self._ordered(drone, OrderKind.LAND)

    def home(self, drone: str) -> RosReply:
        """Bring a drone home."""
        if self._requests == "off":
            return RosReply(False, FLIGHTS_ARE_OFF)
        return self._flown(drone, OrderKind.HOME)

    def reset(self, drone: str) -> RosReply:
        """End an emergency on the ground; stop what flies."""
        kind = OrderKind.STOP if self._leases[drone].is_airborne else OrderKind.RESET
        return self._ordered(drone, kind)

    def nudge(self, drone: str, velocity: Vec3) -> str:
        """Move a drone that holds its place by hand [m/s]; return why not, in words, or ""."""
        if self._requests != "auto":
            return 'moving by hand needs [ros2] requests = "auto"'
        words = self._leases[drone].objection(SENDER)
        if not words:
            order = self._new_order(OrderKind.NUDGE)
            self._bus.publish(self._topics[drone].order, replace(order, velocity=velocity))
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
        return self._leases[drone].holder

    def call_off(self, drone: str, order: str, task: int) -> RosReply:
        """End what a wish began: a drone that it flies holds its place, a task comes home.

        Args:
            drone: its name.
            order: as the reply to the wish said it.
            task: likewise.
        """
        if task:
            try:
                self._ask_tasks(CancelTask(task, SENDER, only_of=OWNER), _ASK_PATIENCE)
            except HouseflyError as error:
                return RosReply(False, str(error))
            return RosReply(True, f"task {task} is called off", task=task)
        lease = self._leases[drone]
        if lease.holder is None or lease.holder.id != order:
            return RosReply(True, "nothing flies by it any more")
        reply = self._ordered(drone, OrderKind.HOVER)
        if not reply.success:  # not in every phase; a STOP is taken in each
            reply = self._ordered(drone, OrderKind.STOP)
        lease.give_back(reply.order)
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
            SENDER,
            RequestSurface.ROS,
            confirm=Confirm.AUTO if self._requests == "auto" else Confirm.ASK,
            owner=OWNER,
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
            self._ask_tasks(CancelTask(number, SENDER, only_of=OWNER), _PATIENCE)

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
        if words := self._leases[drone].objection(SENDER):
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
        order = replace(self._new_order(kind), goal=goal, look_at=look_at)
        with self._answered:
            self._answers[order.id] = None
        try:
            self._bus.publish(self._topics[drone].order, order)
            return self._reply(drone, order.id)
        finally:
            with self._answered:
                del self._answers[order.id]

    def _new_order(self, kind: OrderKind) -> Order:
        return Order(
            kind,
            issued_at=self._clock.now(),
            sender=SENDER,
            id=token_hex(6),
            source=OrderSource.PROGRAM,
        )

    def _reply(self, drone: str, order: str) -> RosReply:
        def is_answered() -> bool:
            return self._answers[order] is not None

        with self._answered:
            self._answered.wait_for(is_answered, _PATIENCE)
            answer = self._answers[order]
        if answer is None:
            return RosReply(False, f"the pilot of {drone} does not answer")
        return RosReply(answer.is_taken, str(answer.reason) or "done", order)
