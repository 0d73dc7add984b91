"""From what a browser asks to an order for the pilot: who may ask for what, and how it is said in
the log.
"""

from __future__ import annotations

from housefly.hub.api.queries import RoomView
from housefly.messages import Order, OrderKind
from housefly.web.vocabulary import OrderRequest

FOR_EVERYONE = frozenset({OrderKind.STOP, OrderKind.LAND})
"""Orders that need no control: they only make the drone safer."""
GOES_SOMEWHERE = frozenset({OrderKind.GO, OrderKind.SERVICE})

IN_WORDS = {
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
}


def objection(request: OrderRequest, room: RoomView | None) -> str:
    """Return what is wrong with a request by itself, in words, or ""."""
    targets = bool(request.place) + (request.goal is not None)
    if request.order not in GOES_SOMEWHERE:
        return (
            ""
            if targets == 0
            else f"the order to {IN_WORDS[request.order]} takes no place and no goal"
        )
    if targets != 1:
        return "the order needs either a place or a goal"
    if room is None:
        return "the room is not known yet"
    if request.place and request.place not in {place.name for place in room.places}:
        return (
            f"no place called {request.place!r}; known places:"
            f" {', '.join(place.name for place in room.places)}"
        )
    if request.goal is not None and not _within(request.goal, room.bounds):
        return "the goal is outside the room"
    return ""


def order_of(request: OrderRequest, sender: str, now: float) -> Order:
    """Return the order that goes on the bus."""
    return Order(
        request.order,
        request.place,
        request.goal,
        look_s=request.look_s,
        issued_at=now,
        sender=sender,
    )


def in_words(request: OrderRequest) -> str:
    """Return the request as the event log says it."""
    target = request.place or (
        "" if request.goal is None else f"x {request.goal[0]:.1f} m, y {request.goal[1]:.1f} m"
    )
    return IN_WORDS[request.order].format(target=target)


def _within(point: tuple[float, float], bounds: tuple[float, float, float, float]) -> bool:
    return bounds[0] <= point[0] <= bounds[2] and bounds[1] <= point[1] <= bounds[3]
