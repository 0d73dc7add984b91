"""What Home Assistant would show: everything that is on a broker, and a site that is shown."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

import aiomqtt
from mqtt_broker import Broker, until

from housefly.config.site import Site, site_from_tree


def site_at(port: int, **home: Any) -> Site:
    """Return a site that is shown in Home Assistant by a broker on a port of loopback."""
    mqtt = {"broker": "127.0.0.1", "port": port, "site": "home"}
    return site_from_tree({"mqtt": mqtt, "homeassistant": {"enabled": True} | home})


class Screen:
    """What Home Assistant would have: the newest of each topic, and what was said once."""

    def __init__(self, client: aiomqtt.Client) -> None:
        self.client = client
        self.held: dict[str, bytes] = {}
        self.once: list[tuple[str, bytes]] = []

    async def read(self) -> None:
        async for message in self.client.messages:
            payload = message.payload if isinstance(message.payload, bytes) else b""
            self.held[message.topic.value] = payload
            self.once.append((message.topic.value, payload))

    async def holds(self, topic: str, payload: bytes) -> None:
        await until(lambda: self.held.get(topic) == payload)


@asynccontextmanager
async def watching(broker: Broker) -> AsyncIterator[Screen]:
    """Look at everything on a broker."""
    async with broker.client() as client:
        await client.subscribe("#", qos=1)
        screen = Screen(client)
        reading = asyncio.create_task(screen.read())
        try:
            yield screen
        finally:
            reading.cancel()
            await asyncio.gather(reading, return_exceptions=True)
