"""A synchronous bus inside one process, with a fixed order of handlers.

zenoh delivers messages on threads of its own, so lock-step simulation and reproducible tests use
this one instead.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Self, TypeVar

from housefly.bus.topics import Topic
from housefly.errors import LinkError

_Message = TypeVar("_Message")


@dataclass(frozen=True, slots=True, eq=False)
class _Entry:
    key: str
    handler: Callable[[Any], Any]


class _Table:
    """Handlers in the order of subscription."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._entries: tuple[_Entry, ...] = ()

    def add(self, entry: _Entry) -> None:
        with self._lock:
            self._entries = (*self._entries, entry)

    def remove(self, entry: _Entry) -> None:
        with self._lock:
            self._entries = tuple(known for known in self._entries if known is not entry)

    def handlers(self, key: str) -> tuple[Callable[[Any], Any], ...]:
        return tuple(entry.handler for entry in self._entries if entry.key == key)


class _LocalSubscription:
    def __init__(self, table: _Table, entry: _Entry) -> None:
        self._table, self._entry = table, entry

    def close(self) -> None:
        self._table.remove(self._entry)


class LocalBus:
    """A member of a bus in this process; handlers run on the caller's thread in ``publish``.

    The first ``LocalBus()`` makes the bus, ``join()`` adds members. Handlers are called in
    the order of subscription. Closing a member ends its own subscriptions and answers only.
    """

    def __init__(self) -> None:
        self._topics, self._queries = _Table(), _Table()
        self._mine: list[_LocalSubscription] = []
        self._closed = False

    def join(self) -> LocalBus:
        """Return another member of the same bus."""
        member = LocalBus()
        member._topics, member._queries = self._topics, self._queries
        return member

    def publish(self, topic: Topic[_Message], message: _Message) -> None:
        """Call every handler of the topic with the message; does nothing after ``close``."""
        if self._closed:
            return
        topic.check(message)
        for handler in self._topics.handlers(topic.key):
            handler(message)

    def subscribe(
        self, topic: Topic[_Message], handler: Callable[[_Message], None]
    ) -> _LocalSubscription:
        """Call the handler with each message from now on."""
        return self._register(self._topics, _Entry(topic.key, handler))

    def answer(
        self, query: str, handler: Callable[[str], str], threads: int = 1
    ) -> _LocalSubscription:
        """Answer a query on the asker's thread; the first of several handlers answers."""
        return self._register(self._queries, _Entry(query, handler))

    def ask(self, query: str, request: str = "", timeout: float = 2.0) -> str:
        """Return the reply; raises LinkError at once if nobody answers or the handler fails."""
        handlers = self._queries.handlers(query)
        if self._closed or not handlers:
            raise LinkError(f"nobody answers the query {query!r}")
        try:
            return str(handlers[0](request))
        except Exception as error:
            raise LinkError(f"the query {query!r} failed: {error}") from error

    def close(self) -> None:
        """Leave the bus."""
        self._closed = True
        while self._mine:
            self._mine.pop().close()

    def _register(self, table: _Table, entry: _Entry) -> _LocalSubscription:
        if self._closed:
            raise LinkError("the bus is closed")
        table.add(entry)
        subscription = _LocalSubscription(table, entry)
        self._mine.append(subscription)
        return subscription

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
