"""A real broker, and a driver that listens to it."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from mqtt_broker import Broker, running_broker, until

from housefly.config.devices import MqttConfig
from housefly.messages import Observation, RoomEvent
from housefly.sensors.contracts import SensorHealth
from housefly.sensors.mqtt import MqttSensors


@dataclass
class Listening:
    """A driver at work and what it told."""

    sensors: MqttSensors
    told: list[Observation | RoomEvent] = field(default_factory=list)

    @property
    def observations(self) -> list[Observation]:
        return [value for value in self.told if isinstance(value, Observation)]

    @property
    def events(self) -> list[RoomEvent]:
        return [value for value in self.told if isinstance(value, RoomEvent)]

    def health(self, name: str) -> SensorHealth:
        return next(row for row in self.sensors.health() if row.id == name)

    def counts(self, name: str) -> dict[str, int]:
        return dict(self.health(name).counts)

    def knows(self, name: str) -> bool:
        return any(row.id == name for row in self.sensors.health())


@pytest.fixture(name="until")
def until_fixture() -> Callable[..., object]:
    return until


@pytest.fixture
async def broker(tmp_path: Path) -> AsyncIterator[Broker]:
    async with running_broker(tmp_path) as started:
        yield started


Listen = Callable[..., AbstractAsyncContextManager[Listening]]


@pytest.fixture
def listen() -> Listen:
    """Return a context manager in which a driver listens at a port; keywords are keys of the site's
    [mqtt].
    """

    @asynccontextmanager
    async def listening(port: int, wait: bool = True, **keys: object) -> AsyncIterator[Listening]:
        at_work = Listening(MqttSensors(MqttConfig(broker="127.0.0.1", port=port, **keys)))  # type: ignore[arg-type]
        task = asyncio.create_task(at_work.sensors.run(at_work.told.append))
        try:
            if wait:
                await until(lambda: at_work.sensors.connected)
            yield at_work
        finally:
            task.cancel()
            await asyncio.gather(task, return_exceptions=True)

    return listening
