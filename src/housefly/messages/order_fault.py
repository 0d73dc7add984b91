"""Whether the values of an order make sense by themselves, in any room."""

from __future__ import annotations

from collections.abc import Iterable

from housefly.messages.flight import Order, OrderKind

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


def order_fault(order: Order) -> str:
    """Return what is wrong with an order's values, in words with range and unit, or ""."""
    if order.kind in CALMING_ORDERS:
        return ""
    far = f"coordinates of at most {COORDINATE_MAX:g} m"
    name = f"at most {NAME_LENGTH_MAX} printable letters"
    checks = (
        (_within(order.goal or ()), "goal is not a position in a room", far),
        (_within(order.look_at or ()), "look_at is not a position in a room", far),
        (0.0 <= order.look_s <= LOOK_TIME_MAX, "look_s is wrong", f"0 to {LOOK_TIME_MAX:g} s"),
        (_is_velocity(order), "velocity is wrong", f"at most {SPEED_MAX:g} m/s, and only by nudge"),
        (_is_name(order.place), "place is not a name", name),
        (_is_name(order.sender), "sender is not a name", name),
        (_is_name(order.id), "id is not a name", name),
    )
    faults = (
        f"the order's {what}; allowed: {allowed}" for well, what, allowed in checks if not well
    )
    return next(faults, "")


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
