"""The console as a process of its own: started, killed, started again, told to leave."""

from __future__ import annotations

import asyncio
import os
import re
import signal
import socket
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from fake_pilot import FakePilot
from fake_room import example_room
from websockets.asyncio.client import ClientConnection, connect

from housefly.bus.endpoint import endpoint_in
from housefly.bus.stop import StopListener
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.messages import OrderKind
from housefly.web.process import main, run_web

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]
SECRET = "00112233445566778899aabbccddeeff"
TIMEOUT = 20.0


def free_port(kind: socket.SocketKind) -> int:
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


NOWHERE = "unixsock-stream/nowhere/bus"


class Meeting:
    """A fake pilot on a real bus, and what it takes to start consoles for it."""

    def __init__(self, bus: ZenohBus, endpoint: str, stop_port: int, site: Path) -> None:
        self.pilot = FakePilot(bus, example_room())
        self.stops = 0
        self.endpoint, self.stop_port, self.site = endpoint, stop_port, site

    def stop(self) -> None:
        self.stops += 1

    @asynccontextmanager
    async def console(self, port: int) -> AsyncIterator[tuple[asyncio.subprocess.Process, str]]:
        mine = {
            "XDG_STATE_HOME": str(self.site.parent),
            "HOUSEFLY_TOKEN": "the-token",
            "HOUSEFLY_SECRET": SECRET,
            "HOUSEFLY_STOP_PORTS": f"drone={self.stop_port}",
        }
        arguments = ["--site", str(self.site), "--bus", self.endpoint, "--port", str(port)]
        process = await asyncio.create_subprocess_exec(
            *(sys.executable, "-m", "housefly.web.process", *arguments),
            env={**os.environ, **mine},
            stdout=asyncio.subprocess.PIPE,
        )
        try:
            assert process.stdout is not None
            line = (await asyncio.wait_for(process.stdout.readline(), TIMEOUT)).decode()
            found = re.search(r"console ready: (http://127\.0\.0\.1:\d+)$", line.strip())
            assert found, f"{line}: the token belongs into no log"
            yield process, found[1]
        finally:
            if process.returncode is None:
                process.kill()
            await process.wait()


@pytest_asyncio.fixture
async def meeting(tmp_path: Path) -> AsyncIterator[Meeting]:
    site = tmp_path / "site.json"
    site.write_text(Site().model_dump_json(), encoding="utf-8")
    sockets = tmp_path / "s"
    sockets.mkdir(mode=0o700)
    endpoint = endpoint_in(sockets)
    with ZenohBus(listen=endpoint) as bus:
        found = Meeting(bus, endpoint, free_port(socket.SOCK_DGRAM), site)
        listener = StopListener("127.0.0.1", found.stop_port, SECRET, found.stop)
        await listener.start()
        flying = asyncio.create_task(found.pilot.run())
        yield found
        flying.cancel()
        listener.close()


async def credentials_of(address: str) -> tuple[str, str]:
    host, _, port = address.removeprefix("http://").partition(":")
    reader, writer = await asyncio.open_connection(host, int(port))
    lines = ("GET /?token=the-token HTTP/1.1", f"Host: {host}:{port}", "Connection: close", "", "")
    writer.write("\r\n".join(lines).encode())
    answer = (await reader.read()).decode()
    writer.close()
    found = re.search(r"\?proof=(\w+).*set-cookie: ([^;]+)", answer, re.DOTALL)
    assert found, answer
    return found[2], found[1]


def open_socket(address: str, credentials: tuple[str, str]) -> Any:
    headers = {"Cookie": credentials[0], "X-Housefly-Proof": credentials[1]}
    return connect(
        address.replace("http", "ws") + "/socket",
        origin=address,
        additional_headers=headers,
        close_timeout=0.2,
    )  # type: ignore[arg-type]


async def hear(one: ClientConnection, text: str) -> None:
    async with asyncio.timeout(TIMEOUT):
        while text not in await one.recv(decode=True):
            pass


async def test_a_console_stops_on_two_paths_leaves_at_once_and_its_browsers_outlive_a_kill(
    meeting: Meeting,
) -> None:
    port = free_port(socket.SOCK_STREAM)
    async with meeting.console(port) as (process, address):
        credentials = await credentials_of(address)
        async with open_socket(address, credentials) as one:
            await one.send('{"type":"hello","tab":"a-tab-of-mine"}')
            await hear(one, '"type":"room"')
            await hear(one, '"type":"state"')
            await one.send('{"type":"stop","id":1}')
            async with asyncio.timeout(TIMEOUT):
                while not (meeting.stops and meeting.pilot.orders):
                    await asyncio.sleep(0.01)
            assert meeting.stops == 1
            assert meeting.pilot.orders[0].kind is OrderKind.STOP
        process.kill()
        await process.wait()
    async with (
        meeting.console(port) as (process, address),
        open_socket(address, credentials) as one,
    ):
        await one.send('{"type":"hello","tab":"a-tab-of-mine"}')
        await hear(one, '"type":"room"')
        process.send_signal(signal.SIGTERM)
        async with asyncio.timeout(5):
            assert await process.wait() == 0


async def test_an_address_that_others_reach_is_refused() -> None:
    with pytest.raises(ConfigError, match=r"web\.host"):
        await run_web(changed(Site(), web__host="0.0.0.0"), NOWHERE)


def test_a_console_that_nobody_launched_says_how_to_launch_it(
    tmp_path: Path, capsys: Any, monkeypatch: Any
) -> None:
    monkeypatch.delenv("HOUSEFLY_STOP_PORTS", raising=False)
    before = signal.getsignal(signal.SIGTERM)
    site = tmp_path / "site.toml"
    site.write_text("", encoding="utf-8")
    assert main(["--site", str(site), "--bus", NOWHERE]) == 1
    assert "housefly demo" in capsys.readouterr().err
    signal.signal(signal.SIGTERM, before)
