"""A person who moves the drone by hand: how late a nudge arrives, and the order that it becomes.

The page's clock is not ours. What is known is how long after the page's own stamp its quickest
message came: who comes later than that was held up on the line by the difference.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from secrets import token_hex

from housefly.messages import Order, OrderKind
from housefly.messages.order_fault import NAME_LENGTH_MAX
from housefly.web.sockets.client_messages import NudgeRequest

LATE_MAX = 0.3
"""A nudge that was held up for longer is nothing [s]; the pilot gives it up after the same time."""
NEW_TIME = 2.0
"""A nudge so long after the last one begins anew [s]: one line of the log."""
_KEPT = 10


@dataclass(slots=True)
class LineDelay:
    """How late messages of one page arrive, against its quickest of the last ten pings."""

    _apart: deque[float] = field(default_factory=lambda: deque(maxlen=_KEPT))

    def learn(self, sent: float, now: float) -> None:
        """Take in a ping: when the page sent it by its own clock, and when it came by ours [s]."""
        self._apart.append(now - sent)

    def lateness(self, sent: float, now: float) -> float:
        """Return how much later than the quickest a message came [s]; 0 before the first ping."""
        return max(0.0, now - sent - min(self._apart, default=now - sent))


def nudge_order(request: NudgeRequest, sender: str, given_at: float) -> Order:
    """Return the order that goes on the bus, given at a time of ours [s]."""
    by = sender[:NAME_LENGTH_MAX]
    return Order(
        OrderKind.NUDGE, issued_at=given_at, sender=by, velocity=request.velocity, id=token_hex(6)
    )
