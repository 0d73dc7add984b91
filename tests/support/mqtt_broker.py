"""A real broker on a free port of loopback, and waiting for what it brings."""

from __future__ import annotations

import asyncio
import getpass
import shutil
import socket
import sys
import time
from asyncio.subprocess import DEVNULL, Process
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path

import aiomqtt
import pytest

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


def mosquitto_or_skip() -> str:
    """Return the program, or skip where Debian's package mosquitto is absent."""
    if MOSQUITTO is None:
        pytest.skip("the package mosquitto is absent: apt-get install mosquitto")
    return MOSQUITTO


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
        self._process = await asyncio.create_subprocess_exec(
            mosquitto_or_skip(), "-c", str(self._file), stdout=DEVNULL, stderr=DEVNULL
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


@asynccontextmanager
async def running_broker(folder: Path) -> AsyncIterator[Broker]:
    """Start a broker for a while, or skip where Debian's package mosquitto is absent."""
    mosquitto_or_skip()
    broker = Broker(folder)
    await broker.start()
    try:
        yield broker
    finally:
        await broker.kill()


async def until(condition: Callable[[], object], seconds: float = 60.0) -> None:
    """Wait until a condition, which may be a coroutine, holds."""
    end = time.monotonic() + seconds
    while True:
        result = condition()
        if await result if asyncio.iscoroutine(result) else result:
            return
        assert time.monotonic() < end, "waited in vain"
        await asyncio.sleep(0.01)
