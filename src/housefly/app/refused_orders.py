"""Orders that are refused before the pilot's step hears them."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.messages import Event, Order, OrderAnswer, OrderKind, OrderOutcome, Severity

RISING_ORDERS = frozenset({OrderKind.TAKE_OFF, OrderKind.GO, OrderKind.SERVICE})
"""Orders that take off."""


@dataclass(frozen=True, slots=True)
class RefusedOrder:
    """An order, and why it was not taken: which kind of reason, and in words."""

    order: Order
    outcome: OrderOutcome
    why: str

    @property
    def answer(self) -> OrderAnswer:
        """What whoever waits for it is told."""
        return OrderAnswer(self.order.id, self.outcome, self.why)

    def event(self, now: float) -> Event:
        """Return what people are told; ``now`` is the pilot's clock [s]."""
        asked = self.order.kind.value.replace("_", " ")
        return Event(now, Severity.WARNING, "order_refused", f"{asked} refused: {self.why}")


def refuse_rising(
    orders: tuple[Order, ...], outcome: OrderOutcome, why: str
) -> tuple[tuple[Order, ...], tuple[RefusedOrder, ...]]:
    """Return the orders without those that take off, and those; all pass where ``why`` is ""."""
    refused = [order for order in orders if why and order.kind in RISING_ORDERS]
    passed = tuple(order for order in orders if order not in refused)
    return passed, tuple(RefusedOrder(order, outcome, why) for order in refused)


def answers_to(refused: tuple[RefusedOrder, ...]) -> tuple[OrderAnswer, ...]:
    """Return the answers to those that have an id."""
    return tuple(one.answer for one in refused if one.order.id)
