"""Orders that other processes give the pilot: bounded, so that nobody's loop makes it late.

Each order may need a way to be planned. Whoever gives too many is named, and the rest of theirs is
refused; what stops the drone always passes, and of motions by hand the newest.
"""

from __future__ import annotations

from collections import Counter, deque
from threading import Lock

from housefly.clock import Clock
from housefly.messages import Event, Order, OrderAnswer, OrderKind, OrderOutcome, Severity
from housefly.messages.event_code import EventCode
from housefly.messages.words import Words, figure

SENDER_ORDERS_MAX, ORDERS_MAX = 20, 40
"""Orders in a second of one sender, and of all of them."""
ORDERS_PER_STEP = 1
"""So many are taken at once; the others wait for the next step, until they are too old."""
STOPPING_ORDERS = frozenset({OrderKind.STOP, OrderKind.LAND, OrderKind.CUT})
"""These always pass: one of each kind and sender in a step."""
_PERIOD = 1.0
_REASONS = {
    OrderOutcome.TOO_MANY: Words("too many orders in a second"),
    OrderOutcome.SUPERSEDED: Words("an order to stop or land came before it was taken"),
}
_NAME_MAX = 40


class OrderInbox:
    """Collects orders between two steps of the pilot; may be added to from any thread.

    Args:
        clock: the pilot's.
    """

    def __init__(self, clock: Clock) -> None:
        self._clock, self._lock = clock, Lock()
        self._stopping: dict[tuple[OrderKind, str], Order] = {}
        self._nudges: dict[str, Order] = {}
        self._waiting: deque[Order] = deque()
        self._since = clock.now()
        self._taken: dict[str, int] = {}
        self._refused = Counter[str]()
        self._answers: list[OrderAnswer] = []

    @property
    def waiting(self) -> tuple[Order, ...]:
        """What no step has taken yet."""
        with self._lock:
            return (*self._waiting, *self._nudges.values(), *self._stopping.values())

    def add(self, order: Order) -> None:
        """Add an order, or refuse it."""
        with self._lock:
            if order.kind in STOPPING_ORDERS:
                self._stopping.setdefault((order.kind, order.sender), order)
            elif order.kind is OrderKind.NUDGE and self._may_nudge(order.sender):
                self._nudges[order.sender] = order
            elif self._is_allowed(order.sender):
                self._waiting.append(order)
            else:
                self._refuse(order, OrderOutcome.TOO_MANY)

    def _may_nudge(self, sender: str) -> bool:
        return sender in self._nudges or len(self._nudges) < ORDERS_MAX

    def _is_allowed(self, sender: str) -> bool:
        """Count an order of this second; strangers beyond the first senders share a name."""
        known = sender in self._taken or len(self._taken) < ORDERS_MAX
        name = sender if known else "others"
        given = self._taken.get(name, 0)
        if given < SENDER_ORDERS_MAX and sum(self._taken.values()) < ORDERS_MAX:
            self._taken[name] = given + 1
            return True
        self._refused[name] += 1
        return False

    def drain(self) -> tuple[Order, ...]:
        """Return what the next step takes; what stops the drone comes last, and has the last word.

        What still waits then was given before it, and counts no more.
        """
        with self._lock:
            count = min(len(self._waiting), ORDERS_PER_STEP)
            taken = tuple(self._waiting.popleft() for _ in range(count))
            nudges, stopping = tuple(self._nudges.values()), tuple(self._stopping.values())
            if stopping:
                for order in self._waiting:
                    self._refused[order.sender] += 1
                    self._refuse(order, OrderOutcome.SUPERSEDED)
                self._waiting.clear()
            self._nudges.clear()
            self._stopping.clear()
            return (*taken, *nudges, *stopping)

    def _refuse(self, order: Order, outcome: OrderOutcome) -> None:
        if order.id and len(self._answers) < ORDERS_MAX:
            self._answers.append(OrderAnswer(order.id, outcome, _REASONS[outcome]))

    def answers(self) -> tuple[OrderAnswer, ...]:
        """Return the answers to what was refused since the last call."""
        with self._lock:
            answers, self._answers = tuple(self._answers), []
            return answers

    def told(self) -> tuple[Event, ...]:
        """Return whose orders were too many, once a second."""
        now = self._clock.now()
        with self._lock:
            if now - self._since < _PERIOD:
                return ()
            self._since, refused = now, self._refused
            self._taken, self._refused = {}, Counter()
        return tuple(
            Event(now, Severity.WARNING, EventCode.ORDERS_FLOODED, _words(name, count))
            for name, count in refused.items()
        )


def _words(name: str, count: int) -> Words:
    return Words(
        "{who} gives too many orders: {n} were refused in a second (limit {m} a second)",
        who=repr(name[:_NAME_MAX]),
        n=figure(count),
        m=figure(SENDER_ORDERS_MAX),
    )
