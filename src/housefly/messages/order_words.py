"""What people call an order, and what it asks for."""

from __future__ import annotations

from housefly.messages.flight import Order, OrderKind
from housefly.messages.order_fault import shown_name
from housefly.messages.words import Words

ORDER_WORDS: dict[OrderKind, Words] = {
    OrderKind.TAKE_OFF: Words("take off"),
    OrderKind.LAND: Words("land"),
    OrderKind.HOVER: Words("hover"),
    OrderKind.GO: Words("go"),
    OrderKind.SERVICE: Words("service"),
    OrderKind.HOME: Words("home"),
    OrderKind.STOP: Words("stop"),
    OrderKind.RESUME: Words("resume"),
    OrderKind.CUT: Words("cut"),
    OrderKind.RESET: Words("reset"),
    OrderKind.NUDGE: Words("nudge"),
}
"""The name of each order in a sentence."""


def asked_words(order: Order) -> Words:
    """Return what an order asks for, with its place."""
    name, place = ORDER_WORDS[order.kind], shown_name(order.place)
    return Words("{asked} {place}", asked=name, place=place) if place else name


def refused_words(asked: Words, why: Words) -> Words:
    """Return that something asked for was refused, and why."""
    return Words("{asked} refused: {why}", asked=asked, why=why)
