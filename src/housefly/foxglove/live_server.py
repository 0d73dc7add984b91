"""The WebSocket server of ``foxglove-sdk``: channels go out, nothing comes in."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from types import TracebackType
from typing import Any, Self

from housefly.bus.interfaces import type_store
from housefly.errors import ConfigError, MissingPartError
from housefly.foxglove.channels import LiveChannel
from housefly.record.ros_messages import nanoseconds

_BACKLOG = 256
"""Messages that wait for one viewer; of more the oldest are dropped."""


class LiveServer:
    """Serves channels to any number of viewers; thread-safe.

    It takes neither messages nor parameters nor calls of services: no such capability is offered.

    Args:
        name: shown in Foxglove.
        host: address to listen on.
        port: 0 takes a free one.
        channels: that are offered from the beginning.
        on_change: called on a thread of the server when a viewer subscribes (topic, True) or leaves
            (topic, False); it must return at once.

    Attributes:
        host: where it listens.

    Raises:
        MissingPartError: without ``foxglove-sdk``.
        ConfigError: the address cannot be had.
    """

    def __init__(
        self,
        name: str,
        host: str,
        port: int,
        channels: Iterable[LiveChannel],
        on_change: Callable[[str, bool], None],
    ) -> None:
        sdk = _sdk()
        # Channels hold their context weakly: who drops it offers nothing.
        self._context = context = sdk.Context()
        self._lock, self.host = threading.Lock(), host
        self._latest: dict[str, tuple[int, bytes]] = {}
        known = tuple(channels)
        self._latched = {channel.topic for channel in known if channel.latched}
        self._channels = {channel.topic: _opened(sdk, channel, context) for channel in known}
        try:
            self._server = sdk.start_server(
                name=name,
                host=host,
                port=port,
                capabilities=[],
                server_listener=_Listener(on_change),
                context=context,
                message_backlog_size=_BACKLOG,
            )
        except RuntimeError as error:
            raise ConfigError(
                "foxglove.port", f"cannot listen on {host} port {port} ({error})"
            ) from error

    @property
    def port(self) -> int:
        """Where it listens."""
        return int(self._server.port)

    def is_wanted(self, topic: str) -> bool:
        """Return whether anybody has subscribed to a channel."""
        channel = self._channels.get(topic)
        return channel is not None and bool(channel.has_sinks())

    def send(self, topic: str, at: float, message: Any) -> None:
        """Send a ROS 2 message of a Unix time [s]; one that nobody wants costs nothing."""
        if topic in self._channels and (topic in self._latched or self.is_wanted(topic)):
            kind = message.__msgtype__
            self.send_bytes(topic, at, bytes(type_store().serialize_cdr(message, kind)))

    def send_bytes(self, topic: str, at: float, data: bytes) -> None:
        """Send bytes in the encoding of the channel; the last ones of a latched one are kept."""
        stamp = nanoseconds(at)
        if topic in self._latched:
            with self._lock:
                self._latest[topic] = (stamp, data)
        self._channels[topic].log(data, log_time=stamp)

    def send_again(self, topic: str) -> None:
        """Send what is kept of a latched channel, for whoever has just come."""
        with self._lock:
            kept = self._latest.get(topic)
        if kept is not None:
            stamp, data = kept
            self._channels[topic].log(data, log_time=stamp)

    def forget(self, topics: Iterable[str]) -> None:
        """Keep nothing of channels that are no longer fed."""
        with self._lock:
            for topic in topics:
                self._latest.pop(topic, None)

    def close(self) -> None:
        """Leave every viewer."""
        self._server.stop()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


class _Listener:
    """What the SDK calls; it asks for these two methods only where nothing may come in."""

    def __init__(self, on_change: Callable[[str, bool], None]) -> None:
        self._on_change = on_change

    def on_subscribe(self, client: Any, channel: Any) -> None:
        self._on_change(channel.topic, True)

    def on_unsubscribe(self, client: Any, channel: Any) -> None:
        self._on_change(channel.topic, False)


def _opened(sdk: Any, channel: LiveChannel, context: Any) -> Any:
    encoding, schema_encoding = channel.encoding.value
    schema = sdk.Schema(
        name=channel.schema_name, encoding=schema_encoding, data=channel.schema.encode()
    )
    return sdk.Channel(channel.topic, schema=schema, message_encoding=encoding, context=context)


def _sdk() -> Any:
    """Return the SDK; raises MissingPartError without it."""
    try:
        import foxglove
    except ModuleNotFoundError as error:
        raise MissingPartError("foxglove-sdk", "pip install 'housefly[foxglove]'") from error
    return foxglove
