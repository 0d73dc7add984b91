"""A browser's request or nudge as an order for the pilot: what it needs, its words in the log."""

from __future__ import annotations

from secrets import token_hex

from housefly.hub.api.pilot_queries import RoomView
from housefly.messages import Order, OrderKind
from housefly.messages.order_fault import NAME_LENGTH_MAX
from housefly.messages.words import UNSAID, Words, literal
from housefly.room.model import unknown_place
from housefly.web.messages.client_messages import NudgeRequest, OrderRequest

ORDERS_WITHOUT_CONTROL = frozenset({OrderKind.STOP, OrderKind.LAND})
"""Orders that need no control: they only make the drone safer."""
_ORDERS_WITH_TARGET = frozenset({OrderKind.GO, OrderKind.SERVICE})

ORDER_WORDS = {
    OrderKind.TAKE_OFF: "take off",
    OrderKind.LAND: "land",
    OrderKind.HOVER: "hover",
    OrderKind.GO: "fly to {target} and stay",
    OrderKind.SERVICE: "look at {target} and come back",
    OrderKind.HOME: "come home",
    OrderKind.STOP: "STOP",
    OrderKind.RESUME: "resume",
    OrderKind.CUT: "cut motors",
    OrderKind.RESET: "reset the emergency",
    OrderKind.NUDGE: "move by hand",
}


def order_objection(request: OrderRequest, room: RoomView | None) -> Words:
    """Return why a request makes no sense by itself, in words, or UNSAID."""
    if request.order is OrderKind.NUDGE:
        return Words("moving by hand is asked for by nudges, each with a velocity")
    targets = bool(request.place) + (request.goal is not None)
    if request.order not in _ORDERS_WITH_TARGET:
        if targets == 0:
            return UNSAID
        asked = literal(ORDER_WORDS[request.order])
        return Words("the order to {asked} takes no place and no goal", asked=asked)
    if targets != 1:
        return Words("the order needs either a place or a goal")
    if room is None:
        return Words("the room is not known yet")
    known = [place.name for place in room.places]
    if request.place and request.place not in known:
        return unknown_place(request.place, known)
    if request.goal is not None and not _within(request.goal, room.bounds):
        return Words("the goal is outside the room")
    return UNSAID


def to_order(request: OrderRequest, sender: str, now: float) -> Order:
    """Return the order that goes on the bus."""
    place, goal, look_s = request.place, request.goal, request.look_s
    by, order_id = sender[:NAME_LENGTH_MAX], token_hex(6)
    return Order(request.order, place, goal, look_s=look_s, issued_at=now, sender=by, id=order_id)


def order_in_words(request: OrderRequest) -> str:
    """Return the request in the words of the event log."""
    target = request.place or (
        "" if request.goal is None else f"x {request.goal[0]:.1f} m, y {request.goal[1]:.1f} m"
    )
    return ORDER_WORDS[request.order].format(target=target)


def _within(point: tuple[float, float], bounds: tuple[float, float, float, float]) -> bool:
    return bounds[0] <= point[0] <= bounds[2] and bounds[1] <= point[1] <= bounds[3]


LATE_MAX = 0.3
"""A nudge that was held up for longer is nothing [s]; the pilot gives it up after the same time."""
NEW_TIME = 2.0
"""A nudge so long after the last one begins anew [s]: one line of the log."""


def nudge_order(request: NudgeRequest, sender: str, given_at: float) -> Order:
    """Return the order that goes on the bus, given at a time of ours [s]."""
    by = sender[:NAME_LENGTH_MAX]
    return Order(
        OrderKind.NUDGE, issued_at=given_at, sender=by, velocity=request.velocity, id=token_hex(6)
    )
