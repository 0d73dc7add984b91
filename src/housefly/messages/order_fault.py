"""Whether the values of an order make sense by themselves, in any room."""

from __future__ import annotations

from collections.abc import Iterable

from housefly.messages.flight import Order, OrderKind
from housefly.messages.words import UNSAID, Words, figure

CALMING_ORDERS = frozenset({OrderKind.STOP, OrderKind.LAND, OrderKind.CUT, OrderKind.HOVER})
"""Orders that make things safer: they pass whatever their other values are."""
COORDINATE_MAX = 1000.0
"""Goals further from the origin on any axis [m] are refused: no room is so long."""
LOOK_TIME_MAX = 3600.0
"""Longest time to look at something [s]."""
SPEED_MAX = 10.0
"""No drone is moved faster by hand on any axis [m/s]."""
NAME_LENGTH_MAX = 100
"""Longest name of a place, a sender or an order."""


def order_fault(order: Order) -> Words:
    """Return what is wrong with an order's values, in words with range and unit, or UNSAID."""
    if order.kind in CALMING_ORDERS:
        return UNSAID
    far = Words("coordinates of at most {d} m", d=figure(COORDINATE_MAX, "g"))
    name = Words("at most {n} printable letters", n=figure(NAME_LENGTH_MAX))
    fast = Words("at most {d} m/s, and only by nudge", d=figure(SPEED_MAX, "g"))
    long = Words("0 to {n} s", n=figure(LOOK_TIME_MAX, "g"))
    checks = (
        (_within(order.goal or ()), Words("goal is not a position in a room"), far),
        (_within(order.look_at or ()), Words("look_at is not a position in a room"), far),
        (0.0 <= order.look_s <= LOOK_TIME_MAX, Words("look_s is wrong"), long),
        (_is_velocity(order), Words("velocity is wrong"), fast),
        (_is_name(order.place), Words("place is not a name"), name),
        (_is_name(order.sender), Words("sender is not a name"), name),
        (_is_name(order.id), Words("id is not a name"), name),
    )
    faults = (
        Words("the order's {what}; allowed: {limit}", what=what, limit=allowed)
        for well, what, allowed in checks
        if not well
    )
    return next(faults, UNSAID)


def shown_name(text: str) -> str:
    """Return a name as it goes into a line of the event log: short, and on one line."""
    return "".join(letter if letter.isprintable() else "?" for letter in text[:NAME_LENGTH_MAX])


def _within(point: Iterable[float]) -> bool:
    return all(abs(value) <= COORDINATE_MAX for value in point)


def _is_velocity(order: Order) -> bool:
    if order.velocity is None or order.kind is not OrderKind.NUDGE:
        return (order.velocity is None) == (order.kind is not OrderKind.NUDGE)
    return all(abs(value) <= SPEED_MAX for value in order.velocity)


def _is_name(text: str) -> bool:
    return len(text) <= NAME_LENGTH_MAX and text.isprintable()
