"""The interface of a bus; ``bus.local`` (in process) and ``bus.zenoh_bus`` implement it."""

from __future__ import annotations

from collections.abc import Callable
from types import TracebackType
from typing import Protocol, Self, TypeVar

from housefly.bus.topics import Topic

_Message = TypeVar("_Message")


class Subscription(Protocol):
    """A running subscription; closing it twice does no harm."""

    def close(self) -> None:
        """Stop receiving."""
        ...


class Bus(Protocol):
    """Publish, subscribe, ask, answer; thread-safe.

    Handlers run on the transport's thread (local: the caller's); they must be quick and must not
    raise.
    """

    def publish(self, topic: Topic[_Message], message: _Message) -> None:
        """Send one message; never blocks for a LATEST topic."""
        ...

    def subscribe(
        self, topic: Topic[_Message], handler: Callable[[_Message], None]
    ) -> Subscription:
        """Call the handler with each message; a slow one misses messages of LATEST topics."""
        ...

    def answer(self, query: str, handler: Callable[[str], str], threads: int = 1) -> Subscription:
        """Answer a query: the handler maps the request text to the reply text.

        With several threads a question that takes long holds up no other.
        """
        ...

    def ask(self, query: str, request: str = "", timeout: float = 2.0) -> str:
        """Ask a query and return the reply text; raises LinkError if nobody answers in time."""
        ...

    def close(self) -> None:
        """Leave the bus."""
        ...

    def __enter__(self) -> Self: ...

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None: ...
