"""Steps that take off and fly somewhere."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import replace

from housefly.errors import HouseflyError
from housefly.geometry import Vec2, Vec3, distance, heading_to, wrap_angle
from housefly.hub.api.questions import WhereQuestion
from housefly.messages import DroneStatus, Order, OrderKind, OrderOutcome, Phase
from housefly.messages.words import UNSAID, Words
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.execution.last_seen import ANYBODY
from housefly.tasks.execution.order_tracker import ANSWER_TIME
from housefly.tasks.execution.run_context import RunContext
from housefly.tasks.execution.step_behavior import StepBehavior, StepFailed
from housefly.tasks.vantage.viewpoint import Viewpoint

ARRIVED_WITHIN = 0.6
"""A drone that holds so near to its goal has arrived [m]; the pilot itself is stricter."""
STRAY_TIME = 2.0
"""One that holds elsewhere for so long [s] does not get there."""
FACING_WITHIN = 0.2
"""Heading error with which the subject is in the picture [rad]."""
FACING_TIME = 6.0
"""Looking counts from here on even when the drone never quite faces the subject [s]."""
ORDER_TRIES = 3
"""An order that was too old, or was not answered, is given so often."""
START_TIME, TIME_PER_METRE = 75.0, 12.0
"""A flight may take so long [s], plus so much per metre of the straight way [s/m]: the pilot gives
up earlier."""
REGO_PERIOD = 1.0
"""A moving subject is flown after at most this often [s] ..."""
REGO_DISTANCE = 0.5
"""... when it moved more than this [m]."""
FACE_HEIGHT = 1.5
"""Of a person whose posture nobody knows [m]."""
_CODES = {OrderOutcome.BATTERY: ReasonCode.BATTERY, OrderOutcome.NO_WAY: ReasonCode.NO_WAY}
"""How a task tells a refusal; the others depend on where the drone is."""


class FlightStep(StepBehavior):
    """A step that gives one order and waits for what becomes of it."""

    LIMIT = 240.0

    def initialise(self) -> None:
        """Begin; called by the tree."""
        self.context.flights += 1
        self.context.looks = UNSAID
        self._tries = 0
        super().initialise()

    def begin(self) -> None:
        """Give the order."""
        if not self.is_done_already():
            self.send()

    def end(self) -> None:
        """Fly no longer."""
        self.context.flights -= 1

    def resume(self) -> None:
        """Give the order again."""
        self._tries = 0
        if not self.is_done_already():
            self.send()

    def is_done_already(self) -> bool:
        """Return whether nothing has to be ordered."""
        return False

    @abstractmethod
    def order(self) -> Order:
        """Return the order."""

    def send(self) -> None:
        """Give the order, now; raises StepFailed when it would take off again after the end."""
        if self.context.is_ending and self.context.stands:
            raise StepFailed("a task that ends does not take off again")
        self._tries += 1
        self.context.give(self.order())

    def is_accepted(self) -> bool:
        """Return whether the pilot took the order; raises StepFailed when it will not."""
        orders, now = self.context.orders, self.context.inputs.now
        answer = orders.answer
        if answer is None and now - orders.given_at <= ANSWER_TIME:
            return False
        if answer is not None and answer.is_taken:
            return True
        is_late = answer is None or answer.outcome is OrderOutcome.EXPIRED
        if is_late and self._tries < ORDER_TRIES:
            self.send()
        elif answer is None:
            raise StepFailed(Words("the pilot does not answer"), ReasonCode.NOT_READY)
        else:
            raise StepFailed(answer.reason, self._code_of(answer.outcome))
        return False

    def _code_of(self, outcome: OrderOutcome) -> ReasonCode:
        grounded = self.context.inputs.phase is Phase.IDLE
        otherwise = ReasonCode.PREFLIGHT if grounded else ReasonCode.STEP_FAILED
        return _CODES.get(outcome, otherwise)


class TakeOff(FlightStep):
    """Takes off and hovers."""

    LIMIT = 30.0

    def order(self) -> Order:
        """Return the order."""
        return Order(OrderKind.TAKE_OFF)

    def is_done_already(self) -> bool:
        """Return whether it flies."""
        return self.context.inputs.phase not in (Phase.IDLE, Phase.TAKING_OFF)

    def proceed(self) -> bool:
        """Wait until it hovers."""
        inputs = self.context.inputs
        flies = inputs.status not in (DroneStatus.LANDED, DroneStatus.TAKING_OFF)
        if self.context.hovers and flies:
            return True
        if inputs.phase is not Phase.TAKING_OFF:
            self.is_accepted()
        return False


class GoTo(FlightStep):
    """Flies to where a subject is seen from, or to a point."""

    FACES = False

    def begin(self) -> None:
        """Work out where to go, and set off."""
        self._origin = self.context.inputs.position
        self._who = self.context.faced = ""
        self._sent = self._look = -1e9
        self._stray: float | None = None
        self._arrived: float | None = None
        self._view: Viewpoint | None = None
        self._aim()
        away = 0.0 if self._origin is None else distance(self._origin[:2], self.goal)
        self._usual = START_TIME + TIME_PER_METRE * away
        self.send()

    def _aim(self) -> None:
        point = self._point()
        if point is not None:
            self.goal: Vec2 = point
            self.look_at: Vec3 | None = None
        else:
            self._take(self.viewpoint())

    def _point(self) -> Vec2 | None:
        given = self.step.arguments
        point = self.argument("point") if "point" in given else None
        if isinstance(point, tuple):
            return float(point[0]), float(point[1])
        return (self.number("x"), self.number("y")) if {"x", "y"} <= given.keys() else None

    def _take(self, view: Viewpoint) -> None:
        self._view, self.goal, self.look_at = view, view.position, view.look_at

    def viewpoint(self) -> Viewpoint:
        """Return where to look from now."""
        subject = self.text("subject")
        if not subject:
            raise StepFailed(Words("it is not known what to look at"), ReasonCode.UNKNOWN_THING)
        if subject == ANYBODY:
            subject = self._who = self._who or nearest_person(self.context, self._origin)
            self.context.faced = subject
        return self.context.room.viewpoint(subject, self._origin)

    def order(self) -> Order:
        """Return the order."""
        return Order(OrderKind.GO, goal=self.goal, look_at=self.look_at)

    def send(self) -> None:
        """Set off."""
        self._sent, self._stray, self._arrived = self.context.time, None, None
        super().send()

    def proceed(self) -> bool:
        """Wait until it has arrived and faces the subject."""
        self._chase()
        if not self.is_accepted() or not self._has_arrived():
            return False
        if self.FACES and not self.context.looks:
            self.context.looks = self.look_in_words()
        return not self.FACES or self._faces()

    def limit(self) -> float:
        """Return a time that suffices for the way, take-off and detours included [s]."""
        timeout = self.step.timeout
        return timeout if isinstance(timeout, float) else self._usual

    def _has_arrived(self) -> bool:
        context, here = self.context, self.context.inputs.position
        if not context.hovers or here is None:
            self._stray = None
            return False
        if distance(here[:2], self.goal) < ARRIVED_WITHIN:
            return context.time - self._sent > 0.5
        self._stray = context.time if self._stray is None else self._stray
        if context.time - self._stray > STRAY_TIME:
            why = context.orders.trouble or "the pilot holds elsewhere"
            raise StepFailed(why, ReasonCode.NO_WAY)
        return False

    def _faces(self) -> bool:
        inputs = self.context.inputs
        if self._arrived is None:
            self._arrived = self.context.time
        if self.look_at is None or inputs.position is None or inputs.yaw is None:
            return True
        error = wrap_angle(heading_to(inputs.position[:2], self.look_at[:2]) - inputs.yaw)
        return abs(error) < FACING_WITHIN or self.context.time - self._arrived > FACING_TIME

    def look_in_words(self) -> Words:
        """Return what it does once it is there."""
        subject = self.text("subject")
        shown = self._who if subject == ANYBODY else subject
        return Words("Looking at {goal}", goal=self.context.title_of(shown))

    def _chase(self) -> None:
        """Set off anew when the subject moved."""
        if self._view is None or self.context.time - max(self._sent, self._look) < REGO_PERIOD:
            return
        self._look = self.context.time
        try:
            view = self.viewpoint()
        except HouseflyError:
            return
        if has_moved(self._view, view):
            self._take(view)
            self._tries = 0
            self.send()


class LookAt(GoTo):
    """Flies to where a subject is seen from and faces it, or whoever is near it."""

    FACES = True

    def viewpoint(self) -> Viewpoint:
        """Return where to look from now."""
        if self.argument("place") == "next":
            return self._next_best()
        view = super().viewpoint()
        within = self.number("person_within")
        return self._of_person_near(view, within) if within else view

    def _of_person_near(self, view: Viewpoint, within: float) -> Viewpoint:
        """Face a person, not the door that they stand at; the first one found is kept."""
        people = self.context.room.people()
        near = [each for each in people if distance(each.position[:2], view.look_at[:2]) < within]
        kept = [each for each in near if each.id == self._who]
        if not near:
            return view
        who = min(kept or near, key=lambda p: distance(p.position[:2], view.look_at[:2]))
        try:
            closer = self.context.room.viewpoint(who.id, self._origin)
        except HouseflyError:
            x, y, z = who.position
            closer = replace(view, look_at=(x, y, z + FACE_HEIGHT))
        if who.id != self._who:
            self._who = self.context.faced = who.id
            self.context.found(self.text("as"), who.id, self.context.title_of(who.id))
        return closer

    def _next_best(self) -> Viewpoint:
        """Return where to look when the thing is not where the memory says."""
        subject = self.text("subject")
        for other in self.context.room.ask(WhereQuestion(subject)).alternatives:
            if other.thing:
                return self.context.room.viewpoint(other.thing, self._origin)
        words = f"{self.context.title_of(subject)}: no other place is likely"
        raise StepFailed(words, ReasonCode.UNKNOWN_THING)


def nearest_person(context: RunContext, here: Vec3 | None) -> str:
    """Return the id of whoever is seen nearest to a place [m]; raises StepFailed without one."""
    people = context.room.people()
    if not people:
        raise StepFailed(Words("nobody is seen"), ReasonCode.UNKNOWN_THING)
    if here is None:
        return people[0].id
    return min(people, key=lambda each: distance(each.position[:2], here[:2])).id


def has_moved(before: Viewpoint, now: Viewpoint) -> bool:
    """Return whether what is looked at moved enough to fly after it.

    Where it is best seen from may change with everybody who walks by: that is no reason to go.
    """
    return distance(before.look_at, now.look_at) > REGO_DISTANCE
