"""Processor share of the demo at rest, where somebody lives: the drone on its pad, a console open.

A client does what the page does (hello, a ping a second, every picture acknowledged); a browser's
own share is no part of it. ``SECONDS`` over which it is looked at (60 by default).
"""

from __future__ import annotations

import asyncio
import http.client
import json
import os
import shutil
import threading
import time
from contextlib import suppress
from urllib.parse import parse_qs, urlsplit

from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

from _run import bench_site, running, table
from demo import processes, seconds
from housefly.twin.demo_site import demo_site

SECONDS = float(os.environ.get("SECONDS", "60"))
CPU_GOAL = 0.8
_SETTLE = 20.0
"""Until what begins with the run has come to rest [s]."""


class Page:
    """The console as one browser has it open.

    Attributes:
        pictures, states: how many came.
    """

    def __init__(self, host: str, port: int, token: str) -> None:
        self.pictures = self.states = 0
        link = http.client.HTTPConnection(host, port)
        link.request("GET", f"/?token={token}")
        answer = link.getresponse()
        where, cookie = answer.headers["location"], answer.headers["set-cookie"]
        (proof,) = parse_qs(urlsplit(where).query)["proof"]
        self._address = f"{host}:{port}"
        self._cookie, self._protocols = cookie.split(";")[0], ["housefly", f"proof.{proof}"]

    async def look(self) -> None:
        """Keep both sockets until the console ends."""
        with suppress(ConnectionClosed):
            async with self._opened("socket") as socket, self._opened("video") as video:
                await asyncio.gather(self._read(socket), self._ping(socket), self._watch(video))

    def _opened(self, path: str) -> connect:
        return connect(
            f"ws://{self._address}/{path}",
            origin=f"http://{self._address}",  # type: ignore[arg-type]
            additional_headers={"Cookie": self._cookie},
            subprotocols=self._protocols,  # type: ignore[arg-type]
            max_size=None,
        )

    async def _read(self, socket: ClientConnection) -> None:
        await socket.send(json.dumps({"type": "hello", "tab": "benchmark", "name": "benchmark"}))
        async for text in socket:
            self.states += json.loads(text)["type"] == "state"

    async def _ping(self, socket: ClientConnection) -> None:
        while True:
            await asyncio.sleep(1.0)
            await socket.send(json.dumps({"type": "ping", "sent": 1e3 * time.time()}))

    async def _watch(self, video: ClientConnection) -> None:
        async for _ in video:
            self.pictures += 1
            await video.send("1")


def main() -> None:
    """Print what each process took."""
    site, _ = demo_site(bench_site("127.9.1.1"), shutil.which("mosquitto") is not None)
    with running(site) as state:
        web = state.runtime.site().web
        page = Page(web.host, web.port, state.runtime.token)
        threading.Thread(target=lambda: asyncio.run(page.look()), daemon=True).start()
        time.sleep(_SETTLE)
        parts = processes(state)
        before, start = {name: seconds(one) for name, one in parts.items()}, time.monotonic()
        seen = page.pictures, page.states
        time.sleep(SECONDS)
        elapsed = time.monotonic() - start
        shares = {name: (seconds(one) - before[name]) / elapsed for name, one in parts.items()}
        pictures, states = (page.pictures - seen[0]) / elapsed, (page.states - seen[1]) / elapsed
    print(f"### The demo at rest, a console open ({elapsed:.0f} s)\n")
    rows: list[list[object]] = [[name, f"{shares[name]:.2f}"] for name in sorted(shares)]
    rows.append(["**all**", f"**{sum(shares.values()):.2f}**"])
    print(table(["process", "cores"], rows))
    print(
        f"\n{pictures:.0f} pictures and {states:.0f} states a second came. Goal: under {CPU_GOAL}"
        f" cores in all; this is {sum(shares.values()) / CPU_GOAL:.2f} of it."
    )


if __name__ == "__main__":
    main()
