"""Orders that are refused before the pilot's step hears them."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.messages import Event, Order, OrderAnswer, OrderKind, OrderOutcome, Severity
from housefly.messages.event_code import EventCode
from housefly.messages.order_words import ORDER_WORDS, refused_words
from housefly.messages.words import Words

RISING_ORDERS = frozenset({OrderKind.TAKE_OFF, OrderKind.GO, OrderKind.SERVICE})
"""Orders that take off."""


@dataclass(frozen=True, slots=True)
class RefusedOrder:
    """An order, and why it was not taken: which kind of reason, and in words."""

    order: Order
    outcome: OrderOutcome
    why: Words

    @property
    def answer(self) -> OrderAnswer:
        """What whoever waits for it is told."""
        return OrderAnswer(self.order.id, self.outcome, self.why)

    def event(self, now: float) -> Event:
        """Return what people are told; ``now`` is the pilot's clock [s]."""
        text = refused_words(ORDER_WORDS[self.order.kind], self.why)
        return Event(now, Severity.WARNING, EventCode.ORDER_REFUSED, text)


def refuse_rising(
    orders: tuple[Order, ...], outcome: OrderOutcome, why: Words
) -> tuple[tuple[Order, ...], tuple[RefusedOrder, ...]]:
    """Return the orders without those that take off, and those; all where ``why`` is UNSAID."""
    refused = [order for order in orders if why and order.kind in RISING_ORDERS]
    passed = tuple(order for order in orders if order not in refused)
    return passed, tuple(RefusedOrder(order, outcome, why) for order in refused)


def answers_to(refused: tuple[RefusedOrder, ...]) -> tuple[OrderAnswer, ...]:
    """Return the answers to those that have an id."""
    return tuple(one.answer for one in refused if one.order.id)
