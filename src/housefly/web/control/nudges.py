"""A person who moves the drone by hand: the order that a nudge becomes, and when it is too late."""

from __future__ import annotations

from secrets import token_hex

from housefly.messages import Order, OrderKind
from housefly.messages.order_fault import NAME_LENGTH_MAX
from housefly.web.messages.client_messages import NudgeRequest

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
