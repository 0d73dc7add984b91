"""A real broker, and a driver that listens to it."""

from __future__ import annotations

import asyncio
import getpass
import shutil
import socket
import sys
import time
from asyncio.subprocess import DEVNULL, Process
from collections.abc import AsyncIterator, Callable
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path

import aiomqtt
import pytest

from housefly.config.devices import MqttConfig
from housefly.messages import Observation, RoomEvent
from housefly.sensors.contracts import SensorHealth
from housefly.sensors.mqtt import MqttSensors

MOSQUITTO = shutil.which("mosquitto") or shutil.which("mosquitto", path="/usr/sbin:/usr/local/sbin")


_DOOMED = """
import sys, time
import paho.mqtt.client as mqtt
client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2)
client.will_set(sys.argv[3], b"offline", retain=True)
client.connect("127.0.0.1", int(sys.argv[1]))
client.loop_start()
client.publish(sys.argv[3], b"online", retain=True)
client.publish(sys.argv[2] + "/state", b'{"open": false}')
time.sleep(60)
"""


class Broker:
    """A mosquitto on a free port of loopback that can be killed and started again."""

    def __init__(self, folder: Path) -> None:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port: int = probe.getsockname()[1]
        self._file = folder / "mosquitto.conf"
        self._file.write_text(
            f"listener {self.port} 127.0.0.1\nallow_anonymous true\npersistence false\nuser"
            f" {getpass.getuser()}\n"
        )
        self._process: Process | None = None

    async def start(self) -> None:
        assert MOSQUITTO is not None
        self._process = await asyncio.create_subprocess_exec(
            MOSQUITTO, "-c", str(self._file), stdout=DEVNULL, stderr=DEVNULL
        )
        await until(self._answers)

    async def kill(self) -> None:
        if self._process is not None and self._process.returncode is None:
            self._process.kill()
            await self._process.wait()

    def signal(self, number: int) -> None:
        assert self._process is not None
        self._process.send_signal(number)

    async def protect(self, name: str, password: str) -> None:
        """Ask everybody for this name and password from the next start on."""
        users = self._file.with_name("users")
        made = await asyncio.create_subprocess_exec(
            "mosquitto_passwd", "-b", "-c", str(users), name, password
        )
        assert await made.wait() == 0
        text = self._file.read_text().replace(
            "allow_anonymous true", f"allow_anonymous false\npassword_file {users}"
        )
        self._file.write_text(text)

    def doomed(self, topic: str, will: aiomqtt.Will) -> list[str]:
        """Return the command of a device that speaks once, and then only through its last will."""
        return [sys.executable, "-c", _DOOMED, str(self.port), topic, will.topic]

    async def _answers(self) -> bool:
        try:
            _, writer = await asyncio.open_connection("127.0.0.1", self.port)
        except OSError:
            return False
        writer.close()
        return True

    def client(self, **options: object) -> aiomqtt.Client:
        return aiomqtt.Client("127.0.0.1", self.port, **options)  # type: ignore[arg-type]


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


async def until(condition: Callable[[], object], seconds: float = 15.0) -> None:
    """Wait until a condition, which may be a coroutine, holds."""
    end = time.monotonic() + seconds
    while True:
        result = condition()
        if await result if asyncio.iscoroutine(result) else result:
            return
        assert time.monotonic() < end, "waited in vain"
        await asyncio.sleep(0.01)


@pytest.fixture(name="until")
def until_fixture() -> Callable[..., object]:
    return until


@pytest.fixture
async def broker(tmp_path: Path) -> AsyncIterator[Broker]:
    """Start a broker, or skip where Debian's package mosquitto is absent."""
    if MOSQUITTO is None:
        pytest.skip("the package mosquitto is absent: apt-get install mosquitto")
    broker = Broker(tmp_path)
    await broker.start()
    yield broker
    await broker.kill()


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
