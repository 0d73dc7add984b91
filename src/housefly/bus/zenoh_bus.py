"""The bus between processes of one user: zenoh sessions on a Unix socket, nothing else.

The socket lies in a folder that only its user may enter, so the kernel asks who you are.

One process listens (the room's), the others connect to it and keep trying; there is no scouting
and no other endpoint. A process may die and come back without a restart of the others.
"""

from __future__ import annotations

import atexit
import json
import logging
import threading
import time
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from types import TracebackType
from typing import Any, Self, TypeVar

import zenoh

from housefly.bus.codec import decoded, encoded
from housefly.bus.endpoint import check_endpoint
from housefly.bus.topics import Delivery, Topic
from housefly.errors import LinkError, WireError

_Message = TypeVar("_Message")

_log = logging.getLogger(__name__)

_EVERY_DEPTH = 256
"""Unread messages of an EVERY topic before its sender has to wait."""
_MAX_QUESTION = 64 * 1024
"""Longest question [bytes]."""
_MAX_MESSAGE = 32 * 2**20
"""zenoh itself takes no longer message [bytes]."""
_COMPLAINT_PERIOD = 1.0
"""Messages that are ignored make at most one line of the log in this time [s]."""
_ASK_AGAIN = 0.05
"""Pause between two attempts to find an answerer [s]."""


class _Reader:
    """A thread that reads a zenoh channel, so that a slow handler never blocks zenoh's threads."""

    def __init__(self, source: Any, name: str, work: Callable[[Any], None]) -> None:
        self._source = source
        self._work = work
        self._name = name
        self._open = True
        self.on_close: Callable[[], None] = lambda: None
        self._complained_at = float("-inf")
        self._thread = threading.Thread(
            target=self._run, args=(source.handler,), name=f"bus {name}", daemon=True
        )
        self._thread.start()

    def _run(self, channel: Iterable[Any]) -> None:
        for item in channel:
            if not self._open:
                return
            try:
                self._work(item)
            except WireError as error:
                self._complain(error)
            except Exception:
                _log.exception("a handler of %s failed", self._name)

    def _complain(self, error: WireError) -> None:
        now = time.monotonic()
        if now - self._complained_at >= _COMPLAINT_PERIOD:
            self._complained_at = now
            _log.warning("ignored a message on %s: %s", self._name, error)

    def close(self) -> None:
        """Stop receiving; waits for a running handler, unless the handler itself calls it."""
        if self._open:
            self._open = False
            self._source.undeclare()
            self.on_close()
        if self._thread is not threading.current_thread():
            self._thread.join(timeout=1.0)


class ZenohBus:
    """A member of the bus in this process.

    Args:
        listen: endpoint to listen on and route, as ``endpoint_in`` makes it, or None.
        connect: endpoint to connect to as soon as somebody listens there, or None.
        namespace: prefix of all keys, so that several rooms can share a network.

    Raises:
        LinkError: the endpoint cannot be listened on, or others than its user could reach it.
    """

    def __init__(
        self, listen: str | None = None, connect: str | None = None, namespace: str = "housefly"
    ) -> None:
        self._namespace = namespace
        self._lock = threading.Lock()
        self._publishers: dict[str, Any] = {}
        self._readers: list[_Reader] = []
        for endpoint in (listen, connect):
            if endpoint is not None:
                check_endpoint(endpoint)
        try:
            self._session = zenoh.open(_configuration(listen, connect))
        except zenoh.ZError as error:
            raise LinkError(
                f"the bus cannot be opened at {listen or connect}: {_words(error)}"
            ) from error
        # The others hear at once that we left, and zenoh does not run on into an interpreter that
        # shuts down.
        atexit.register(self.close)

    def publish(self, topic: Topic[_Message], message: _Message) -> None:
        """Send one message; does nothing after ``close``.

        A LATEST topic drops what the network cannot take at once, and costs next to nothing without
        subscribers. An EVERY topic waits for room, at most five seconds.
        """
        try:
            publisher = self._publisher(topic)
            if topic.delivery is Delivery.EVERY or publisher.matching_status.matching:
                publisher.put(encoded(topic, topic.check(message)))
        except zenoh.ZError as error:
            if not self._session.is_closed():
                raise LinkError(f"cannot publish {topic.key}: {_words(error)}") from error

    def subscribe(self, topic: Topic[_Message], handler: Callable[[_Message], None]) -> _Reader:
        """Call the handler with each message, on a thread of this subscription."""
        ring = topic.delivery is Delivery.LATEST
        channel: Any = (
            zenoh.handlers.RingChannel(topic.depth)
            if ring
            else zenoh.handlers.FifoChannel(_EVERY_DEPTH)
        )
        source = self._declare(self._session.declare_subscriber, self._key(topic.key), channel)
        return self._keep(
            _Reader(
                source,
                topic.key,
                lambda sample: handler(
                    topic.check(decoded(topic, _payload(sample, topic.max_size)))
                ),
            )
        )

    def answer(self, query: str, handler: Callable[[str], str], threads: int = 1) -> _Reader:
        """Answer a query; an exception becomes an error reply.

        Questions are answered one after the other on a thread of this subscription, or on several
        threads at once: then one that takes long holds up no other.
        """
        key = self._key(query)
        source = self._declare(
            self._session.declare_queryable, key, zenoh.handlers.FifoChannel(_EVERY_DEPTH)
        )

        def reply(asked: Any) -> None:
            # A query counts as answered only when it is dropped: leaving the block tells the asker
            # that no more comes.
            with asked:
                try:
                    question = _payload(asked, _MAX_QUESTION) if asked.payload else b""
                    asked.reply(key, handler(question.decode()).encode())
                except Exception as error:
                    asked.reply_err(f"{error}".encode())

        if threads == 1:
            return self._keep(_Reader(source, query, reply))
        pool = ThreadPoolExecutor(threads, thread_name_prefix=f"answers {query}")

        def hand_over(asked: Any) -> None:
            pool.submit(reply, asked)

        reader = _Reader(source, query, hand_over)
        reader.on_close = lambda: pool.shutdown(wait=False, cancel_futures=True)
        return self._keep(reader)

    def ask(self, query: str, request: str = "", timeout: float = 2.0) -> str:
        """Return the first reply; raises LinkError after the timeout [s] or on a failed handler."""
        deadline = time.monotonic() + timeout
        while (left := deadline - time.monotonic()) > 0:
            for reply in self._declare(
                self._session.get, self._key(query), payload=request.encode(), timeout=left
            ):
                if reply.ok is not None:
                    return str(reply.ok.payload.to_string())
                words = reply.err.payload.to_string()
                if words != _TIMED_OUT:
                    raise LinkError(f"the query {query!r} failed: {words}")
            time.sleep(min(_ASK_AGAIN, max(0.0, deadline - time.monotonic())))
        raise LinkError(f"nobody answered the query {query!r} within {timeout:g} s")

    def close(self) -> None:
        """Leave the bus; closing twice does no harm."""
        atexit.unregister(self.close)
        with self._lock:
            readers, self._readers = self._readers, []
            self._publishers.clear()
        for reader in readers:
            reader.close()
        self._session.close()  # type: ignore[no-untyped-call]

    def _key(self, key: str) -> str:
        return f"{self._namespace}/{key}"

    def _publisher(self, topic: Topic[Any]) -> Any:
        with self._lock:
            found = self._publishers.get(topic.key)
            if found is None:
                every = topic.delivery is Delivery.EVERY
                found = self._session.declare_publisher(
                    self._key(topic.key),
                    congestion_control=(
                        zenoh.CongestionControl.BLOCK if every else zenoh.CongestionControl.DROP
                    ),
                    priority=zenoh.Priority.REAL_TIME if every else zenoh.Priority.DATA,
                    express=True,
                )
                self._publishers[topic.key] = found
            return found

    def _declare(self, call: Callable[..., Any], *arguments: Any, **options: Any) -> Any:
        try:
            return call(*arguments, **options)
        except zenoh.ZError as error:
            raise LinkError(
                f"the bus is closed or refused {arguments[0]!r}: {_words(error)}"
            ) from error

    def _keep(self, reader: _Reader) -> _Reader:
        with self._lock:
            self._readers.append(reader)
        return reader

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


_TIMED_OUT = "Timeout"
"""What zenoh itself replies when time is up."""


def _payload(received: Any, limit: int) -> bytes:
    """Return the bytes of a sample or a query; raises WireError when there are too many."""
    size = len(received.payload)
    if size > limit:
        raise WireError(f"{size} bytes where at most {limit} are allowed")
    return bytes(received.payload.to_bytes())


def _words(error: zenoh.ZError) -> str:
    """Return the error without zenoh's source locations."""
    words = str(error).split(" at /")[0]
    return "it is in use" if "acquire lock" in words else words


def _configuration(listen: str | None, connect: str | None) -> zenoh.Config:
    """Return a configuration with exactly the given endpoints."""
    settings: dict[str, Any] = {
        # Routers pass messages on between processes that are not connected to each other; peers and
        # clients do not.
        "mode": "router",
        "listen/endpoints": [listen] if listen else [],
        "listen/exit_on_failure": True,
        "connect/endpoints": [connect] if connect else [],
        "connect/timeout_ms": -1,
        "connect/exit_on_failure": False,
        "connect/retry": {
            "period_init_ms": 50,
            "period_max_ms": 250,
            "period_increase_factor": 1.5,
        },
        "open/return_conditions": {"connect_scouted": False, "declares": False},
        "scouting/delay": 0,
        "scouting/multicast/enabled": False,
        "scouting/gossip/enabled": False,
        # Segments of a killed process would stay behind in /dev/shm, for a gain of 0.1 ms.
        "transport/shared_memory/enabled": False,
        # A LATEST topic must not hold up its sender: zenoh's own patience with a full queue is 1
        # ms, 50 ms for long messages.
        "transport/link/tx/queue/congestion_control/drop": {
            "wait_before_drop": 0,
            "max_wait_before_drop_fragments": 2000,
        },
        "transport/link/tx/queue/size/data": 16,
        "transport/link/rx/max_message_size": _MAX_MESSAGE,
    }
    configuration = zenoh.Config()
    for key, value in settings.items():
        configuration.insert_json5(key, json.dumps(value))
    return configuration
