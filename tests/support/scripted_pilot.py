"""A pilot of a few lines for tests of tasks: its own table of orders, no flight mechanics."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import hypot, inf
from typing import Any

from housefly.errors import TaskError, ThingError
from housefly.geometry import Vec2, Vec3, heading_to
from housefly.hub.api.questions import Question, StateQuestion
from housefly.messages import (
    DroneStatus,
    Event,
    EventCode,
    Order,
    OrderAnswer,
    OrderKind,
    OrderOutcome,
    Phase,
    SafetyMode,
    Severity,
)
from housefly.pilot.behavior.mission import Refused
from housefly.pilot.behavior.mission_tables import ORDERS, REFUSALS, Response
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.execution.task_run import TaskRun
from housefly.tasks.execution.values import GiveOrder, PersonReply, TaskAction, TaskInputs
from housefly.tasks.vantage.thing_search import SearchLook, SearchSummary
from housefly.tasks.vantage.viewpoint import Viewpoint

PERIOD = 0.1
SPEED = 1.0
HOME: Vec2 = (0.0, 0.0)
RISE_TIME = SINK_TIME = 1.0
UNIX_BEGIN = 1.7e9
_FLOWN = {Phase.OUTBOUND, Phase.RETURNING}


class ScriptedPilot:
    """Obeys orders one period after they were given, by the real table of orders."""

    def __init__(self) -> None:
        self.now = 10.0
        self.phase, self.status = Phase.IDLE, DroneStatus.LANDED
        self.safety = SafetyMode.NOMINAL
        self.position: Vec3 = (*HOME, 0.0)
        self.yaw = 0.0
        self.goal: Vec2 | None = None
        self.look_at: Vec3 | None = None
        self.after: Order | None = None
        self.since = 0.0
        self.events: list[Event] = []
        self.answers: list[OrderAnswer] = []
        self.by_people: list[Order] = []
        self.refuses: Refused | None = None
        self.was_up = False
        self.floor, self.pose_age = 0.0, 0.01

    def advance(self, orders: list[Order], people: tuple[Order, ...] = ()) -> None:
        """Go on by one period."""
        self.now += PERIOD
        self.events, self.answers, self.by_people = [], [], list(people)
        for order in (*people, *orders):
            self._obey(order)
        self._move()
        self.was_up = self.was_up or self.position[2] > 0.0

    def _obey(self, order: Order) -> None:
        response = ORDERS[order.kind][self.phase]
        words = order.kind.value.replace("_", " ")
        expired = order.kind not in (OrderKind.HOVER, OrderKind.LAND, OrderKind.STOP)
        refused: Refused | None = None
        if expired and self.now - order.issued_at > 0.5:
            refused = Refused(OrderOutcome.EXPIRED, "the order is old")
        elif response in REFUSALS:
            refused = Refused(OrderOutcome.WRONG_PHASE, response.value)
        elif response in (Response.START, Response.DEPART):
            refused = self.refuses
        if refused is not None:
            self.answers.append(OrderAnswer(order.id, refused.outcome, refused.reason))
            self._tell("order_refused", f"{words} refused: {refused.reason}", Severity.WARNING)
            return
        self.answers.append(OrderAnswer(order.id))
        if response in (Response.START, Response.LATER):
            self.after = order
            if response is Response.START:
                self._enter(Phase.TAKING_OFF)
        elif response is Response.DEPART:
            self._depart(order)
        elif response is Response.HOLD:
            self.after = None
            if self.phase is not Phase.TAKING_OFF:
                self._enter(Phase.HOLDING)
        elif response is Response.LAND:
            self._enter(Phase.LANDING)
        elif response is Response.STOP:
            self.safety = SafetyMode.STOPPED
            if self.phase in _FLOWN:
                self._enter(Phase.HOLDING)

    def _depart(self, order: Order) -> None:
        is_home = order.kind is OrderKind.HOME
        self.goal = HOME if is_home else order.goal
        self.look_at = order.look_at
        self._enter(Phase.RETURNING if is_home else Phase.OUTBOUND)

    def _enter(self, phase: Phase) -> None:
        self.phase, self.since = phase, self.now

    def _tell(self, code: str, text: str, severity: Severity = Severity.INFO) -> None:
        self.events.append(Event(self.now, severity, EventCode(code), text))

    def _move(self) -> None:
        elapsed = self.now - self.since
        x, y, _ = self.position
        if self.phase is Phase.TAKING_OFF:
            self.status = DroneStatus.LANDED if elapsed < 0.3 else DroneStatus.TAKING_OFF
            if elapsed >= 0.3:
                self.position = (x, y, 1.0)
            if elapsed >= RISE_TIME:
                self.status = DroneStatus.FLYING
                order, self.after = self.after, None
                self._enter(Phase.HOLDING)
                if order is not None and order.kind is not OrderKind.TAKE_OFF:
                    self._depart(order)
        elif self.phase in _FLOWN and self.goal is not None:
            self._fly(self.goal)
        elif self.phase is Phase.LANDING:
            if self.status is not DroneStatus.LANDED:
                self.status = DroneStatus.LANDING
            if elapsed >= SINK_TIME or self.status is DroneStatus.LANDED:
                self.position, self.status = (x, y, self.floor), DroneStatus.LANDED
                self._enter(Phase.IDLE)

    def _fly(self, goal: Vec2) -> None:
        x, y, z = self.position
        left = hypot(goal[0] - x, goal[1] - y)
        step = min(left, SPEED * PERIOD)
        if left > 0.0:
            x, y = x + step * (goal[0] - x) / left, y + step * (goal[1] - y) / left
        self.position = (x, y, z)
        if left - step < 1e-9 and self.now - self.since > 0.3:
            if self.look_at is not None:
                self.yaw = heading_to((x, y), self.look_at[:2])
            self._enter(Phase.LANDING if self.phase is Phase.RETURNING else Phase.HOLDING)

    def inputs(self, replies: tuple[PersonReply, ...] = ()) -> TaskInputs:
        """Return what a task is told now."""
        name = "" if self.goal is None else f"({self.goal[0]:.1f}, {self.goal[1]:.1f})"
        return TaskInputs(
            self.now,
            UNIX_BEGIN + self.now,
            self.status,
            self.phase,
            self.safety,
            name,
            self.position,
            self.yaw,
            tuple(self.events),
            (),
            replies,
            0.9,
            tuple(self.by_people),
            self.pose_age,
            tuple(self.answers),
        )


@dataclass
class ScriptedSearch:
    """Looks one after the other, each of which may show the thing with the same probability."""

    left: list[Viewpoint]
    shown: list[tuple[str, bool]] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)

    def looks(
        self, drone: Vec3 | None = None, least: float = 0.03, budget: float = inf
    ) -> tuple[SearchLook, ...]:
        return tuple(SearchLook(0, view, 0.2, (view.subject,)) for view in self.left)

    def was_shown(self, look: SearchLook, *, nothing: bool) -> None:
        self.left.pop(0)
        self.shown.append((look.view.subject, nothing))

    def leave_out(self, look: SearchLook) -> None:
        self.skipped.append(self.left.pop(0).subject)

    def summary(self) -> SearchSummary:
        answered = sum(nothing for _, nothing in self.shown)
        left = tuple((name, 0.2) for name in self.skipped)
        looked = tuple(name for name, _ in self.shown)
        return SearchSummary(looked, left, 0.2 * len(self.shown), 0.2 * answered)


@dataclass
class ScriptedRoom:
    """Subjects with their viewpoints; answers to questions by name."""

    views: dict[str, Viewpoint] = field(default_factory=dict)
    seen: tuple[SeenPerson, ...] = ()
    answers: dict[tuple[str, str], Any] = field(default_factory=dict)
    asked: list[Question] = field(default_factory=list)
    looks: list[Viewpoint] = field(default_factory=list)

    def ask(self, question: Question) -> Any:
        self.asked.append(question)
        name = getattr(question, "thing", "")
        if isinstance(question, StateQuestion):
            name = f"{name} {question.state}"
        found = self.answers.get((question.ask, name))
        if found is None:
            raise ThingError(f"there is no {name}")
        return found

    def people(self) -> tuple[SeenPerson, ...]:
        return self.seen

    def viewpoint(self, subject: str, drone: Vec3 | None = None) -> Viewpoint:
        if subject not in self.views:
            raise TaskError(f"there is no {subject} here", "unknown_thing")
        return self.views[subject]

    def view_from(self, subject: str, place: Vec2) -> Viewpoint | None:
        return None

    def round_names(self, *, whole: bool = False) -> tuple[str, ...]:
        names = [name for name in self.views if "floor" in name]
        return tuple(name for name in names if name.startswith("whole") == whole)

    def shown_share(self, poses: tuple[tuple[Vec2, float], ...]) -> float:
        return min(1.0, 0.1 * len(poses))

    def search(self, thing: str, drone: Vec3 | None, look_time: float) -> ScriptedSearch:
        return ScriptedSearch(list(self.looks))


def view(subject: str, x: float, y: float, ahead: float = 2.0) -> Viewpoint:
    """Return a viewpoint that looks along +x."""
    return Viewpoint(subject, (x, y), (x + ahead, y, 1.0), ahead, "")


@dataclass
class Flight:
    """One task on a scripted pilot, ticked to its end; orders take ``delay`` more ticks."""

    run: TaskRun
    pilot: ScriptedPilot
    actions: list[tuple[float, TaskAction]] = field(default_factory=list)
    orders: list[Order] = field(default_factory=list)
    waiting: list[Order] = field(default_factory=list)
    delay: int = 0
    under_way: list[list[Order]] = field(default_factory=list)

    def tick(
        self, replies: tuple[PersonReply, ...] = (), people: tuple[Order, ...] = ()
    ) -> tuple[TaskAction, ...]:
        """Let the pilot obey what the last tick ordered, then tick the task."""
        self.under_way.append(self.waiting)
        self.waiting = []
        orders = self.under_way.pop(0) if len(self.under_way) > self.delay else []
        self.pilot.advance(orders, people)
        done = self.run.step(self.pilot.inputs(replies))
        self.actions += [(self.pilot.now, action) for action in done]
        self.waiting = [action.order for action in done if isinstance(action, GiveOrder)]
        self.orders += self.waiting
        return done

    def fly(self, ticks: int = 5000) -> Flight:
        """Tick until it is over."""
        for _ in range(ticks):
            if self.run.is_over:
                return self
            self.tick()
        raise AssertionError(f"not over after {ticks} ticks: {self.run.steps}")

    def of(self, kind: type) -> list[Any]:
        """Return the actions of one kind."""
        return [action for _, action in self.actions if isinstance(action, kind)]

    @property
    def kinds(self) -> list[str]:
        """The kinds of the orders given, in order."""
        return [order.kind.value for order in self.orders]

    def stands_on_pad(self) -> bool:
        """Whether the drone stands where it started and nothing is under way."""
        x, y, z = self.pilot.position
        is_down = self.pilot.phase is Phase.IDLE and self.pilot.status is DroneStatus.LANDED
        return is_down and z == 0.0 and hypot(x, y) < 0.01
