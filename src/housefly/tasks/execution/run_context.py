"""What the steps of one running task share: the present tick, and what they want done."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import inf

from housefly.errors import HouseflyError
from housefly.evidence.clip_values import StartClip, TakeSnapshot
from housefly.geometry import Vec2
from housefly.hub.api.questions import WhereQuestion
from housefly.messages import DroneStatus, Order, OrderKind, OrderSource, Phase
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.words import UNSAID, Words
from housefly.pilot.behavior.standing import NEVER_STOOD, StandingHeight
from housefly.tasks.api.values import ReasonCode, TaskStepState
from housefly.tasks.document.templates import plain_text
from housefly.tasks.execution.order_tracker import OrderTracker
from housefly.tasks.execution.task_room import TaskRoom
from housefly.tasks.execution.values import GiveOrder, StopClip, TaskAction, TaskInputs

_FAILED = Words("a step failed")


@dataclass(slots=True)
class StepNote:
    """How far one step is, for people."""

    name: str
    words: str
    state: TaskStepState = TaskStepState.WAITING


@dataclass(slots=True)
class RunContext:
    """Shared by the steps of one task.

    Attributes:
        service: name of the task.
        room: what may be asked of the room.
        inputs: of the present tick.
        time: time that the task has run, pauses left out [s].
        orders: what became of its orders.
        actions: what is to be done after this tick.
        results: what steps found, by name: replies, people in need.
        titles: what people call what was found, by id.
        notes: every step, in order.
        failure: reason and words of the last step that failed.
        round: grows with each resumption; a step that sees a new one gives its order again.
        faced: id of the person whom the drone faces, or "".
        looks: what the drone shows people now, in words; UNSAID while it shows nothing.
        station: the order that brought the drone to where it hovers; None on the ground.
        has_flown: whether the task ordered anything that flies.
        is_ending: whether it only comes down any more: what landed stays down.
        home_refused_at: when the pilot refused the way home for good, on its clock [s].
        flights: steps that fly now.
        clips: clips that steps record now, inside each other.
        picture_poses: where the drone was at each picture: world xy [m], heading [rad].
        standing: where the drone stood before the task flew it.
    """

    service: str
    room: TaskRoom
    inputs: TaskInputs = field(default_factory=lambda: TaskInputs(0.0, 0.0))
    time: float = 0.0
    orders: OrderTracker = field(default_factory=OrderTracker)
    actions: list[TaskAction] = field(default_factory=list)
    results: dict[str, str] = field(default_factory=dict)
    titles: dict[str, str] = field(default_factory=dict)
    notes: list[StepNote] = field(default_factory=list)
    failure: tuple[ReasonCode, Words] = (ReasonCode.STEP_FAILED, _FAILED)
    round: int = 0
    faced: str = ""
    looks: Words = UNSAID
    station: Order | None = None
    has_flown: bool = False
    is_ending: bool = False
    home_refused_at: float = -inf
    flights: int = 0
    given: int = 0
    clips: int = 0
    picture_poses: list[tuple[Vec2, float]] = field(default_factory=list)
    standing: StandingHeight = NEVER_STOOD

    def hear(self, inputs: TaskInputs) -> None:
        """Take in the present tick."""
        self.inputs = inputs
        stands = inputs.status is DroneStatus.LANDED and not self.has_flown
        if stands and inputs.position is not None:
            self.standing = self.standing.stood_at(inputs.position[2], inputs.pose_age)

    def text(self, template: str) -> str:
        """Return a text with what steps found filled in: ids, for the room."""
        return plain_text(template, lambda name: self.results.get(name, ""))

    def words(self, template: str) -> str:
        """Return a text with what steps found filled in as people call it."""

        def shown(name: str) -> str:
            found = self.results.get(name, "")
            return self.titles.get(found, found)

        return plain_text(template, shown)

    def found(self, name: str, thing: str, title: str = "") -> None:
        """Keep what a step found under a name, and what people call it."""
        self.results[name] = thing
        if title:
            self.titles[thing] = title

    def title_of(self, thing: str) -> str:
        """Return what the memory calls a thing, or the word that was given."""
        try:
            return str(self.room.ask(WhereQuestion(thing)).name)
        except HouseflyError:
            return thing

    def clip(self, before: float, subject: str) -> StartClip:
        """Return the clip of a subject, with seconds of the past before it [s]."""
        return StartClip(before, *self._shown(subject))

    def snapshot(self, subject: str) -> TakeSnapshot:
        """Return the picture of a subject, and note where it is taken."""
        position, yaw = self.inputs.position, self.inputs.yaw
        if position is not None and yaw is not None:
            self.picture_poses.append((position[:2], yaw))
        return TakeSnapshot(*self._shown(subject))

    def _shown(self, subject: str) -> tuple[str, str, tuple[str, ...]]:
        """Return the place, the thing and the people that a picture shows, for its index."""
        people = (self.faced,) if self.faced else ()
        if not subject:
            return "", "", people
        try:
            kind = self.room.ask(WhereQuestion(subject)).kind
        except HouseflyError:
            kind = "place"
        if kind == "person":
            return "", "", (subject,)
        return (subject, "", people) if kind == "place" else ("", subject, people)

    def give(self, order: Order) -> None:
        """Give the pilot an order, stamped with the present."""
        self.given += 1
        stamped = replace(
            order,
            id=f"{self.service[:40]} {self.given} at {self.inputs.now:.6f}",
            issued_at=self.inputs.now,
            source=OrderSource.TASK,
        )
        self.has_flown = True
        self.orders.gave(stamped, self.inputs.now)
        self.actions.append(GiveOrder(stamped))
        if order.kind is OrderKind.GO:
            self.station = order
        elif order.kind in (OrderKind.HOME, OrderKind.LAND):
            self.station = None

    def start_clip(self, clip: StartClip) -> None:
        """Record from now on; a clip inside a clip is the same clip."""
        self.clips += 1
        if self.clips == 1:
            self.actions.append(clip)

    def stop_clip(self) -> None:
        """End what ``start_clip`` began."""
        self.clips -= 1
        if self.clips == 0:
            self.actions.append(StopClip())

    @property
    def is_airborne(self) -> bool:
        """Whether the drone flies, or is about to."""
        return self.inputs.phase is not Phase.IDLE or self.inputs.status in AIRBORNE_STATUSES

    @property
    def stands(self) -> bool:
        """Whether the drone is on the ground and nothing is under way."""
        status = self.inputs.status
        return self.inputs.phase is Phase.IDLE and status in (None, DroneStatus.LANDED)

    @property
    def standing_fault(self) -> str:
        """What is wrong with where the drone came down, in words, or ""."""
        inputs = self.inputs
        if not (self.has_flown and self.stands) or inputs.position is None:
            return ""
        return self.standing.fault(inputs.position[2], inputs.pose_age)

    @property
    def hovers(self) -> bool:
        """Whether the drone holds its place in the air."""
        return self.inputs.phase is Phase.HOLDING
