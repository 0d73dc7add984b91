"""The page of ``housefly new`` on a loopback address, for one folder."""

from __future__ import annotations

import asyncio
import http.client
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest_asyncio

from housefly.app.new_site.page import serve_draft
from housefly.messages.words import UNSAID, Words, from_tree
from housefly.room.draft.model import DraftDrone, DraftTracking
from housefly.tracking.live_check import Heard, HeardBody
from housefly.web.new_site.draft_answers import OpenedState, OpenedView

TOKEN = "a-token-for-tests-only"


@dataclass
class Drawer:
    """A browser without the browser, before the page."""

    host: str
    port: int
    folder: Path
    cookie: str = ""
    proof: str = ""
    version: str = ""
    headers: dict[str, str] = field(default_factory=dict)

    @property
    def origin(self) -> str:
        return f"http://{self.host}:{self.port}"

    @property
    def link(self) -> str:
        return f"{self.origin}/?token={TOKEN}"

    async def open(self) -> None:
        """Exchange the link for a session."""
        _, headers, _ = await self.request("GET", f"/?token={TOKEN}")
        self.cookie = headers["set-cookie"].partition(";")[0]
        self.proof = headers["location"].partition("?proof=")[2]
        await self.get()

    async def get(self) -> tuple[int, Any]:
        return await self._noted("GET", "/draft", b"")

    async def post(self, path: str, **body: Any) -> tuple[int, Any]:
        """Ask for a change that is based on the newest version, unless the body says another."""
        based = {"based_on": self.version, **body}
        return await self._noted("POST", path, json.dumps(based).encode())

    async def put(self, path: str, content: bytes) -> tuple[int, Any]:
        return await self._noted("PUT", path, content)

    async def _noted(self, method: str, path: str, body: bytes) -> tuple[int, Any]:
        status, _, text = await self.request(method, path, body)
        tree = json.loads(text)
        if status != 200:
            tree["error"] = from_tree(tree["error"])
        if status == 200 and "version" in tree:
            self.version = tree["version"]
            if not tree["settled"]:
                await asyncio.sleep(0.05)
                return status, {**(await self.get())[1], "words": tree["words"]}
        return status, tree

    async def request(
        self, method: str, path: str, body: bytes = b"", **headers: str
    ) -> tuple[int, dict[str, str], str]:
        """Return status, headers and text; an empty header is left out."""
        given = {
            "Cookie": self.cookie,
            "Origin": self.origin,
            "X-Housefly-Proof": self.proof,
            **{name.replace("_", "-"): value for name, value in headers.items()},
        }
        return await asyncio.to_thread(self._request, method, path, body, given)

    def _request(
        self, method: str, path: str, body: bytes, headers: dict[str, str]
    ) -> tuple[int, dict[str, str], str]:
        connection = http.client.HTTPConnection(self.host, self.port, timeout=20)
        try:
            sent = {name: value for name, value in headers.items() if value}
            connection.request(method, path, body or None, sent)
            answer = connection.getresponse()
            found = {name.lower(): value for name, value in answer.getheaders()}
            return answer.status, found, answer.read().decode()
        finally:
            connection.close()


def hear(tracking: DraftTracking, seconds: float) -> Heard:
    """Hear a drone that lies still, wherever it is asked."""
    body = HeardBody(tracking.body, (1.5, 2.5, 0.05), 0.0, 100.0, 0.001)
    return Heard(tracking.address, 100.0, (body,), UNSAID)


def check_drone(drone: DraftDrone) -> tuple[Words, ...]:
    return (Words("no report came from {name}", name=drone.address),)


class StandInRoom:
    """A room that is ready at the second look."""

    def __init__(self) -> None:
        self.site: Path | None = None
        self._looks = 0

    def open(self, site: Path) -> None:
        self.site = site

    def view(self) -> OpenedView:
        if self.site is None:
            return OpenedView(OpenedState.CLOSED)
        self._looks += 1
        if self._looks < 3:
            return OpenedView(OpenedState.STARTING, "compiling the control loop")
        return OpenedView(OpenedState.READY, "", f"http://127.0.0.1:1/{self.site.name}")


@asynccontextmanager
async def drawing(host: str, folder: Path) -> AsyncIterator[Drawer]:
    """Serve the page for a folder."""
    port: asyncio.Future[int] = asyncio.get_running_loop().create_future()
    serving = asyncio.create_task(
        serve_draft(
            folder, TOKEN, hear, check_drone, port.set_result, room=StandInRoom(), host=host
        )
    )
    try:
        yield Drawer(host, await port, folder)
    finally:
        serving.cancel()
        with suppress(asyncio.CancelledError):
            await serving


@pytest_asyncio.fixture(loop_scope="session")
async def page_of_nothing(loopback: str, tmp_path: Path) -> AsyncIterator[Drawer]:
    """Yield the page of a folder that does not exist yet."""
    async with drawing(loopback, tmp_path / "mylab") as drawer:
        yield drawer


@pytest_asyncio.fixture(loop_scope="session")
async def drawer(page_of_nothing: Drawer) -> Drawer:
    """Return a browser with the session of that page."""
    await page_of_nothing.open()
    return page_of_nothing
