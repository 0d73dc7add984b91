"""What one client is to be told: replies in order, then the messages of its topics in turn."""

from __future__ import annotations

import asyncio
import time
from collections import deque
from contextlib import suppress
from threading import Lock

from housefly.errors import WireError
from housefly.web.rosbridge.subscription import Pace, Subscription

TOPICS_MAX = 64
"""Topics that one client may hear."""
IDS_MAX = 16
"""Subscriptions of one client to one topic."""
REPLIES_MAX = 200
"""Replies that may wait; who asks on without reading is cut."""
WAITING_MAX = 8 * 2**20
"""Messages that wait, of all topics [characters]."""


class Outbox:
    """Filled from any thread, emptied on one loop; bounded: messages drop, replies end it.

    Args:
        loop: where it is emptied.

    Attributes:
        is_full: whether more replies wait than may.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        self._loop, self._lock = loop, Lock()
        self._wake = asyncio.Event()
        self._replies: deque[str] = deque()
        self._topics: dict[str, Subscription] = {}
        self.is_full = False

    def subscribe(self, topic: str, ident: str | int | None, pace: Pace) -> None:
        """Let messages of a topic in.

        Raises:
            WireError: that would be too many.
        """
        with self._lock:
            if topic not in self._topics and len(self._topics) >= TOPICS_MAX:
                raise WireError(f"{TOPICS_MAX} topics are heard already; allowed: {TOPICS_MAX}")
            known = self._topics.get(topic) or Subscription()
            if ident not in known.paces and len(known.paces) >= IDS_MAX:
                raise WireError(f"{topic}: {IDS_MAX} subscriptions already; allowed: {IDS_MAX}")
            known.paces[ident] = pace
            self._topics[topic] = known

    def unsubscribe(self, topic: str, ident: str | int | None) -> bool:
        """Let one subscription go, or all of a topic; return whether nobody hears it any more."""
        with self._lock:
            known = self._topics.get(topic)
            if known is not None and ident is not None:
                known.paces.pop(ident, None)
            if known is None or ident is None or not known.paces:
                self._topics.pop(topic, None)
                return True
            return False

    def topics(self) -> tuple[str, ...]:
        """Return what is heard."""
        with self._lock:
            return tuple(self._topics)

    def offer(self, topic: str, text: str) -> None:
        """Let a message wait where its topic is heard."""
        with self._lock:
            known = self._topics.get(topic)
            if known is None:
                return
            if sum(one.size for one in self._topics.values()) + len(text) > WAITING_MAX:
                known.clear()
            known.add(text)
        self._called()

    def reply(self, text: str) -> None:
        """Let a reply wait."""
        with self._lock:
            if len(self._replies) >= REPLIES_MAX:
                self.is_full = True
            else:
                self._replies.append(text)
        self._called()

    async def next(self) -> str:
        """Return what is to be told next; raises ConnectionError for who does not read."""
        while not self.is_full:
            self._wake.clear()
            text, wait = self._next(time.monotonic())
            if text is not None:
                return text
            with suppress(TimeoutError):
                async with asyncio.timeout(wait):
                    await self._wake.wait()
        raise ConnectionAbortedError(f"more than {REPLIES_MAX} replies wait")

    def _next(self, now: float) -> tuple[str | None, float | None]:
        """Return a text, or how long to wait for one [s]; None until there is one."""
        with self._lock:
            if self._replies:
                return self._replies.popleft(), None
            waits = {topic: one.wait(now) for topic, one in self._topics.items()}
            wait = min(waits.values(), default=float("inf"))
            if wait > 0.0:
                return None, None if wait == float("inf") else wait
            topic = next(one for one, after in waits.items() if after <= 0.0)
            known = self._topics.pop(topic)
            self._topics[topic] = known  # behind the others: each has its turn
            return known.take(now), None

    def _called(self) -> None:
        with suppress(RuntimeError):  # the loop is closed
            self._loop.call_soon_threadsafe(self._wake.set)
