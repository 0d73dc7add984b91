"""What became of a task's orders, and whether somebody else flies the drone now."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.messages import Event, EventCode, Order, OrderAnswer, OrderKind, Phase, SafetyMode
from housefly.messages.order_words import ORDER_WORDS
from housefly.messages.words import Words, said
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.execution.values import TaskInputs

ANSWER_TIME = 1.5
"""The pilot answers an order within this [s], or never."""
SETTLING_TIME = 1.5
"""A phase that no order explains must last so long before it counts [s]: events come first."""

_I, _T, _O, _L, _H, _R, _D = tuple(Phase)
EXPECTED: dict[OrderKind, frozenset[Phase]] = {
    OrderKind.TAKE_OFF: frozenset({_T, _H}),
    OrderKind.GO: frozenset({_T, _O, _H}),
    OrderKind.HOVER: frozenset({_T, _H}),
    OrderKind.HOME: frozenset({_T, _R, _D, _I}),
    OrderKind.LAND: frozenset({_R, _D, _I}),
}
"""Phases that follow from each order once it is accepted."""

DECISIONS: dict[EventCode, ReasonCode] = {
    EventCode.BLOCKED: ReasonCode.NO_WAY,
    EventCode.OVERDUE: ReasonCode.TIMEOUT,
    EventCode.RETURN_WANTED: ReasonCode.SAFETY,
    EventCode.FORCED_DOWN: ReasonCode.SAFETY,
    EventCode.SINKING: ReasonCode.SAFETY,
    EventCode.EMERGENCY: ReasonCode.SAFETY,
    EventCode.TAKE_OFF_GIVEN_UP: ReasonCode.SAFETY,
    EventCode.CORNERED_LANDING: ReasonCode.SAFETY,
}
"""Events of the pilot that end a task, because the pilot flies on by itself."""
_ENDS_HOMING = frozenset({EventCode.FORCED_DOWN, EventCode.EMERGENCY, EventCode.CORNERED_LANDING})
"""Of those the ones that end a flight home, too; the others only bring it home."""
_WAY = frozenset({EventCode.NO_WAY, EventCode.WAY_BLOCKED})
_NOT_TAKING_OVER = frozenset({OrderKind.RESET, OrderKind.RESUME})
_DOWN_MODES = frozenset({SafetyMode.LAND, SafetyMode.DESCEND})


@dataclass(frozen=True, slots=True)
class Interference:
    """Why a task flies no longer: a reason code and one sentence."""

    code: ReasonCode
    words: Words


class OrderTracker:
    """Follows the orders of one task.

    Attributes:
        order: the last one given; None before the first and after a pause.
        given_at: when [s].
        answer: what the pilot made of it; None before it answers.
        trouble: the pilot's last warning about the way, in words.
    """

    def __init__(self) -> None:
        self.order: Order | None = None
        self.given_at = 0.0
        self.answer: OrderAnswer | None = None
        self.trouble = ""
        self._strange_since: float | None = None
        self._goal_name = ""

    def gave(self, order: Order, now: float) -> None:
        """Take note of an order that is given now [s]."""
        self.order, self.given_at = order, now
        self.answer, self.trouble = None, ""
        self._strange_since, self._goal_name = None, ""

    def forget(self) -> None:
        """Expect nothing: others may have flown meanwhile."""
        self.order, self._strange_since = None, None

    def is_open(self, now: float) -> bool:
        """Return whether the pilot may still be about to answer the last order."""
        is_waited_for = self.order is not None and self.answer is None
        return is_waited_for and now - self.given_at < ANSWER_TIME

    def update(self, inputs: TaskInputs) -> Interference | None:
        """Bring it up to now; return why the task flies no longer, None while it does."""
        self._hear_answer(inputs.answers)
        found = self._by_person(inputs)
        for event in inputs.events:
            found = found or self._told(event, inputs)
        self._notice_phase(inputs)
        found = found or self._by_gate(inputs) or self._by_phase(inputs)
        return found

    @property
    def is_taken(self) -> bool:
        """Whether the pilot took the last order."""
        return self.answer is not None and self.answer.is_taken

    @property
    def is_homing(self) -> bool:
        """Whether the last order was to come down."""
        return self.order is not None and self.order.kind in (OrderKind.HOME, OrderKind.LAND)

    def _hear_answer(self, answers: tuple[OrderAnswer, ...]) -> None:
        for answer in answers:
            if self.answer is None and self.order is not None and answer.order_id == self.order.id:
                self.answer = answer

    def _by_person(self, inputs: TaskInputs) -> Interference | None:
        refused = {answer.order_id for answer in inputs.answers if not answer.is_taken}
        for order in inputs.orders:
            if order.kind not in _NOT_TAKING_OVER and not (order.id and order.id in refused):
                return _taken_over(order.kind, order.sender)
        if inputs.safety is SafetyMode.STOPPED:
            return _taken_over(OrderKind.STOP, "")
        return None

    def _told(self, event: Event, inputs: TaskInputs) -> Interference | None:
        is_homing = self.is_homing and event.code not in _ENDS_HOMING
        if event.code in _WAY or (event.code in DECISIONS and is_homing):
            self.trouble = event.text
        elif event.code in DECISIONS:
            is_gates = event.code is EventCode.FORCED_DOWN
            text = _with_worst(event.text, inputs) if is_gates else event.text
            return Interference(DECISIONS[event.code], text)
        return None

    def _notice_phase(self, inputs: TaskInputs) -> None:
        """An answer that was not heard shows in the phase."""
        order = self.order
        is_early = inputs.now - self.given_at < ANSWER_TIME / 3.0
        if order is None or self.answer is not None or is_early:
            return
        if inputs.phase in EXPECTED[order.kind] - {Phase.IDLE, Phase.HOLDING}:
            self.answer = OrderAnswer(order.id)

    def _by_gate(self, inputs: TaskInputs) -> Interference | None:
        if inputs.safety in _DOWN_MODES and not self._lands_for_us(inputs):
            return Interference(ReasonCode.SAFETY, _with_worst(Words("landing for safety"), inputs))
        if inputs.safety is SafetyMode.RETURN and not self.is_homing:
            return Interference(
                ReasonCode.SAFETY, _with_worst(Words("coming home for safety"), inputs)
            )
        return None

    def _lands_for_us(self, inputs: TaskInputs) -> bool:
        return self.is_homing and inputs.phase in (Phase.LANDING, Phase.IDLE)

    def _by_phase(self, inputs: TaskInputs) -> Interference | None:
        """Return what a phase or a goal says that no order of this task explains."""
        order = self.order
        if order is None or not self.is_taken:
            return None
        is_strange = inputs.phase not in EXPECTED[order.kind]
        if inputs.phase is Phase.OUTBOUND and order.kind is OrderKind.GO:
            settled = inputs.now - self.given_at > SETTLING_TIME
            self._goal_name = self._goal_name or (inputs.goal_name if settled else "")
            is_strange = bool(self._goal_name) and inputs.goal_name != self._goal_name
        if not is_strange:
            self._strange_since = None
            return None
        since = self._strange_since = (
            inputs.now if self._strange_since is None else self._strange_since
        )
        if inputs.now - since < SETTLING_TIME:
            return None
        words = Words(
            "the drone is {phase}, which this task did not order", phase=said(inputs.phase)
        )
        return Interference(ReasonCode.PERSON_TOOK_OVER, words)


def _with_worst(what: Words, inputs: TaskInputs) -> Words:
    """Return words with the worst of what is wrong, where anything is told."""
    if not inputs.warnings:
        return what
    return Words("{what}: {why}", what=what, why=inputs.warnings[0])


def _taken_over(kind: OrderKind, sender: str) -> Interference:
    who, what = sender or Words("a person"), ORDER_WORDS[kind]
    return Interference(
        ReasonCode.PERSON_TOOK_OVER, Words("{who} took over: {what}", who=who, what=what)
    )
