"""A viewer that speaks Foxglove's protocol ``foxglove.sdk.v1`` by itself, without the SDK."""

from __future__ import annotations

import asyncio
import json
import struct
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from typing import Any, Self

import jsonschema
from mcap.records import Schema
from mcap_ros2.decoder import DecoderFactory
from websockets.asyncio.client import ClientConnection, connect
from websockets.typing import Origin, Subprotocol

PROTOCOL = Subprotocol("foxglove.sdk.v1")
_MESSAGE = struct.Struct("<BIQ")


@dataclass(frozen=True)
class Received:
    """One message: topic, Unix time [s], bytes, and what is in them."""

    topic: str
    at: float
    data: bytes
    value: Any


@dataclass
class Viewer:
    """A connection and what the server offers."""

    socket: ClientConnection
    server: dict[str, Any] = field(default_factory=dict)
    channels: dict[str, dict[str, Any]] = field(default_factory=dict)
    _ids: dict[int, str] = field(default_factory=dict)
    _decoders: dict[str, Any] = field(default_factory=dict)
    _factory: DecoderFactory = field(default_factory=DecoderFactory)

    async def meet(self, channels: int) -> Self:
        """Read what the server says of itself and until it has offered so many channels."""
        async with asyncio.timeout(20.0):
            while not self.server or len(self.channels) < channels:
                self._note(json.loads(await self.socket.recv()))
        return self

    def _note(self, told: dict[str, Any]) -> None:
        if told["op"] == "serverInfo":
            self.server = told
        elif told["op"] == "advertise":
            self.channels |= {one["topic"]: one for one in told["channels"]}

    async def subscribe(self, *topics: str) -> None:
        """Ask for channels."""
        asked = []
        for topic in topics:
            number = len(self._ids) + 1
            self._ids[number] = topic
            asked.append({"id": number, "channelId": self.channels[topic]["id"]})
        await self.socket.send(json.dumps({"op": "subscribe", "subscriptions": asked}))

    async def unsubscribe(self, *topics: str) -> None:
        """Ask for channels no longer."""
        gone = [number for number, topic in self._ids.items() if topic in topics]
        await self.socket.send(json.dumps({"op": "unsubscribe", "subscriptionIds": gone}))

    async def next(self) -> Received:
        """Return the next message, decoded by the schema that the server gave; JSON is checked."""
        while True:
            raw = await self.socket.recv()
            if isinstance(raw, str):
                self._note(json.loads(raw))
                continue
            kind, number, stamp = _MESSAGE.unpack_from(raw)
            assert kind == 1, kind
            topic, data = self._ids[number], raw[_MESSAGE.size :]
            return Received(topic, stamp / 1e9, data, self._decoded(topic, data))

    async def first_of(self, topics: Sequence[str], patience: float = 30.0) -> dict[str, Received]:
        """Return the first message of each channel."""
        found: dict[str, Received] = {}
        try:
            async with asyncio.timeout(patience):
                while missing := set(topics) - found.keys():
                    message = await self.next()
                    if message.topic in missing:
                        found[message.topic] = message
        except TimeoutError:
            raise AssertionError(f"nothing came on {sorted(set(topics) - found.keys())}") from None
        return found

    def _decoded(self, topic: str, data: bytes) -> Any:
        channel = self.channels[topic]
        if channel["encoding"] == "json":
            value = json.loads(data)
            jsonschema.validate(value, json.loads(channel["schema"]))
            return value
        assert (channel["encoding"], channel["schemaEncoding"]) == ("cdr", "ros2msg")
        name = channel["schemaName"]
        if name not in self._decoders:
            schema = Schema(len(self._decoders) + 1, channel["schema"].encode(), "ros2msg", name)
            self._decoders[name] = self._factory.decoder_for("cdr", schema)
        return self._decoders[name](data)


@asynccontextmanager
async def watching(
    port: int, *, origin: str | None = None, channels: int = 1
) -> AsyncIterator[Viewer]:
    """Yield a viewer that has met the server at a port of this machine."""
    address = f"ws://127.0.0.1:{port}"
    page = None if origin is None else Origin(origin)
    async with connect(
        address, subprotocols=[PROTOCOL], origin=page, max_size=2**24, compression=None
    ) as socket:
        yield await Viewer(socket).meet(channels)
