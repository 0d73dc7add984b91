"""One open console and its bounded send queue; a slow browser slows nobody else."""

from __future__ import annotations

import asyncio
from collections import deque
from dataclasses import dataclass, field
from math import inf

from starlette.websockets import WebSocket

from housefly.messages import Order, OrderKind
from housefly.web.access.session import Session
from housefly.web.http.rate_limit import CommandLimiter
from housefly.web.messages.client_messages import PlanQuestion
from housefly.web.messages.server_messages import ServerMessage, to_text

_ORDERS_KEPT = 30
_MAX_QUEUED_MESSAGES = 1000
"""Answers and events that may wait for one browser; with more its socket is closed."""
_PINGS_KEPT = 10


@dataclass(slots=True)
class LineDelay:
    """How late messages of one page arrive, against its quickest of the last ten pings.

    The page's clock is not ours. What is known is how long after the page's own stamp its quickest
    message came: who comes later than that was held up on the line by the difference.
    """

    _apart: deque[float] = field(default_factory=lambda: deque(maxlen=_PINGS_KEPT))

    def learn(self, sent: float, now: float) -> None:
        """Take in a ping: when the page sent it by its own clock, and when it came by ours [s]."""
        self._apart.append(now - sent)

    def lateness(self, sent: float, now: float) -> float:
        """Return how much later than the quickest a message came [s]; 0 before the first ping."""
        return max(0.0, now - sent - min(self._apart, default=now - sent))


@dataclass(eq=False, slots=True)
class Viewer:
    """A socket with a queue of messages that must arrive and a slot for the newest of each kind.

    Attributes:
        session: the session that the socket belongs to, with its role when it was opened.
        number: who this is; kept over reconnects of the same tab.
        name: shown to the others.
        event: last line of the event log that was sent.
        limiter: what the socket may still send.
        question: the newest plan question not yet answered.
        asking: whether a plan question is being answered now.
        delay: how late its messages arrive.
        nudged_at: when it last moved the drone by hand [s].
        orders: its newest ones, by id.
    """

    socket: WebSocket
    session: Session
    number: int = 0
    name: str = ""
    event: int = 0
    limiter: CommandLimiter = field(default_factory=CommandLimiter)
    question: PlanQuestion | None = None
    asking: bool = False
    delay: LineDelay = field(default_factory=LineDelay)
    nudged_at: float = -inf
    orders: dict[str, OrderKind] = field(default_factory=dict)
    _queue: deque[str] = field(default_factory=deque)
    _slots: dict[str, str] = field(default_factory=dict)
    _wake: asyncio.Event = field(default_factory=asyncio.Event)
    _closing: tuple[int, str] | None = None

    @property
    def present(self) -> bool:
        """Whether the browser has said hello."""
        return self.number > 0

    def gave(self, order: Order) -> None:
        """Remember an order that was passed on: the pilot answers later."""
        self.orders[order.id] = order.kind
        if len(self.orders) > _ORDERS_KEPT:
            del self.orders[next(iter(self.orders))]

    def send(self, message: ServerMessage) -> None:
        """Queue a message that must arrive."""
        self._queue.append(to_text(message))
        if len(self._queue) > _MAX_QUEUED_MESSAGES:
            self.close(1013, "this browser is too slow")
        self._wake.set()

    def send_latest(self, kind: str, text: str) -> None:
        """Put a message in its kind's slot; an older one that still waits is dropped."""
        self._slots[kind] = text
        self._wake.set()

    def close(self, code: int, reason: str) -> None:
        """Close the socket at the writer's next turn."""
        self._closing = (code, reason)
        self._wake.set()

    async def write(self) -> None:
        """Send what waits until the socket closes."""
        while True:
            await self._wake.wait()
            self._wake.clear()
            while (self._queue or self._slots) and not self._closing:
                await self.socket.send_text(self._next())
            if self._closing:
                await self.socket.close(*self._closing)
                return

    def _next(self) -> str:
        if self._queue:
            return self._queue.popleft()
        return self._slots.pop(next(iter(self._slots)))
