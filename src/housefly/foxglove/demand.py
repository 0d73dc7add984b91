"""Listens on the bus only to what somebody watches: without viewers it costs nothing."""

from __future__ import annotations

import logging
import queue
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from typing import Protocol

from housefly.bus.bus import Subscription
from housefly.errors import HouseflyError

_LOG = logging.getLogger(__name__)

_LOOK_AGAIN = 2.0
"""How long a change may be missed, if ever [s]."""


class ViewedServer(Protocol):
    """The part of the server that demand needs."""

    def is_wanted(self, topic: str) -> bool:
        """Return whether anybody has subscribed to a channel."""
        ...

    def send_again(self, topic: str) -> None:
        """Send what is kept of a latched channel."""
        ...

    def forget(self, topics: Sequence[str]) -> None:
        """Keep nothing of channels that are no longer fed."""
        ...


@dataclass(frozen=True, slots=True)
class Feed:
    """What fills some channels.

    Attributes:
        topics: of the channels.
        start: begins to listen; returns what is closed when nobody watches any longer.
    """

    topics: tuple[str, ...]
    start: Callable[[], Sequence[Subscription]]


class Demand:
    """Starts and ends feeds as viewers come and go.

    Args:
        feeds: of all channels.
    """

    def __init__(self, feeds: Sequence[Feed]) -> None:
        self._feeds = tuple(feeds)
        self._running: dict[int, ExitStack] = {}
        self._changes: queue.SimpleQueue[tuple[str, bool] | None] = queue.SimpleQueue()

    def note(self, topic: str, has_come: bool) -> None:
        """Note that a viewer has subscribed to a channel or left it; from any thread, at once."""
        self._changes.put((topic, has_come))

    def end(self) -> None:
        """Let ``run`` return."""
        self._changes.put(None)

    def run(self, server: ViewedServer) -> None:
        """Follow the viewers until ``end``."""
        try:
            while True:
                try:
                    change = self._changes.get(timeout=_LOOK_AGAIN)
                except queue.Empty:
                    self.update(server)
                    continue
                if change is None:
                    return
                self.follow(server, *change)
        finally:
            for stack in self._running.values():
                stack.close()

    def follow(self, server: ViewedServer, topic: str, has_come: bool) -> None:
        """Start or end what a change asks for; who comes late gets what is kept."""
        if has_come:
            server.send_again(topic)
        self.update(server)

    def update(self, server: ViewedServer) -> None:
        """Run exactly those feeds of which somebody watches a channel."""
        for number, feed in enumerate(self._feeds):
            is_wanted = any(server.is_wanted(topic) for topic in feed.topics)
            if is_wanted and number not in self._running:
                self._start(number, feed)
            elif not is_wanted and number in self._running:
                self._running.pop(number).close()
                server.forget(feed.topics)

    def _start(self, number: int, feed: Feed) -> None:
        try:
            subscriptions = feed.start()
        except HouseflyError as error:
            _LOG.warning("%s: %s", ", ".join(feed.topics), error)
            return
        stack = self._running[number] = ExitStack()
        for subscription in subscriptions:
            stack.callback(subscription.close)
