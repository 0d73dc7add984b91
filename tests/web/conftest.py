"""A console served on a loopback address, with a fake pilot, and real Chromium to open it."""

from __future__ import annotations

import asyncio
import contextlib
import http.client
import json
import ssl
from collections.abc import AsyncIterator, Callable, Iterator
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import urlencode

import pytest
import pytest_asyncio
import uvicorn
from fake_pilot import FakePilot
from fake_room import example_room
from playwright.async_api import Browser, Page, expect
from websockets.asyncio.client import ClientConnection, connect

from housefly.app.certificates import CertificateFiles
from housefly.bus.local import LocalBus
from housefly.config.web import WebConfig
from housefly.hub.api.pilot_queries import RoomView
from housefly.messages.words import from_tree
from housefly.web.access.tls import load_certificate
from housefly.web.access.users import UserBook
from housefly.web.api.coverage_layer import CoverageView
from housefly.web.api.edit_service import EditService
from housefly.web.console_port import listening
from housefly.web.process import make_server
from housefly.web.server import create_app

TOKEN = "a-token-for-tests-only"
SECRET = "a-secret-for-tests-only"


_WORDS = {
    *("reason", "text", "headline", "detail", "banner", "place", "words", "mend", "title"),
    *("fault", "value", "limit", "why", "if_contact_lost"),
}
"""Keys of a message of the console under which words are."""


def in_english(told: Any) -> Any:
    """Return a message with the English sentences of its words, as a page in English shows it."""
    if isinstance(told, list):
        return [in_english(one) for one in told]
    if not isinstance(told, dict):
        return told
    shown = {key: from_tree(one) if key in _WORDS else in_english(one) for key, one in told.items()}
    if "known" in shown:
        shown["known"] = [from_tree(one) for one in told["known"]]
    return shown


@dataclass
class Talk:
    """A browser's socket without the browser."""

    socket: ClientConnection
    heard: list[dict[str, Any]] = field(default_factory=list)
    _waiting: list[dict[str, Any]] = field(default_factory=list)

    async def say(self, **message: Any) -> None:
        await self.socket.send(json.dumps(message))

    async def hear(self, kind: str, **expected: Any) -> dict[str, Any]:
        """Return the first message, not returned before, of a kind that has the expected values."""
        wanted = {"type": kind, **expected}.items()
        async with asyncio.timeout(5):
            while True:
                for message in self._waiting:
                    if all(message.get(key) == value for key, value in wanted):
                        self._waiting.remove(message)
                        return message
                message = in_english(json.loads(await self.socket.recv()))
                self.heard.append(message)
                self._waiting.append(message)


@dataclass
class Served:
    """A running console."""

    host: str
    port: int
    bus: LocalBus
    pilot: FakePilot
    stops: list[float]
    proofs: dict[str, str] = field(default_factory=dict)
    trust: ssl.SSLContext | None = None

    @property
    def origin(self) -> str:
        return f"http{'s' if self.trust else ''}://{self.host}:{self.port}"

    @property
    def link(self) -> str:
        return f"{self.origin}/?token={TOKEN}"

    async def request(
        self, method: str, path: str, body: str = "", **headers: str
    ) -> tuple[int, dict[str, str], str]:
        """Return status, headers in lower case, and text of one request."""
        return await asyncio.to_thread(self._request, method, path, body, headers)

    def _request(
        self, method: str, path: str, body: str, headers: dict[str, str]
    ) -> tuple[int, dict[str, str], str]:
        connection = (
            http.client.HTTPSConnection(self.host, self.port, timeout=5, context=self.trust)
            if self.trust
            else http.client.HTTPConnection(self.host, self.port, timeout=5)
        )
        try:
            connection.request(method, path, body or None, headers=self.proved(headers))
            answer = connection.getresponse()
            return (
                answer.status,
                {k.lower(): v for k, v in answer.getheaders()},
                answer.read().decode(errors="replace"),
            )
        finally:
            connection.close()

    async def session(self) -> str:
        """Return a fresh session's cookie, made through an invitation or the first link."""
        _, headers, _ = await self.request("GET", f"/?token={TOKEN}")
        return self.opened(headers)

    async def login(self, name: str, password: str, **headers: str) -> tuple[int, str]:
        """Return the status of a try to log in, and the cookie of the session, or ""."""
        form = urlencode({"name": name, "password": password})
        given = {"Origin": self.origin, **headers}
        status, found, _ = await self.request("POST", "/login", form, **given)
        return status, self.opened(found) if status == 303 else ""

    def opened(self, headers: dict[str, str]) -> str:
        """Return the cookie of an answer that opens a session, and remember its proof."""
        cookie = headers["set-cookie"].partition(";")[0]
        self.proofs[cookie] = headers["location"].partition("?proof=")[2]
        return cookie

    def proved(self, headers: dict[str, str]) -> dict[str, str]:
        """Return headers with the proof that the page of a session sends beside its cookie."""
        proof = self.proofs.get(headers.get("Cookie", ""), "")
        return {"X-Housefly-Proof": proof, **headers} if proof else headers

    @contextlib.asynccontextmanager
    async def talk(
        self, cookie: str, tab: str = "tab-number-one", name: str = "", **headers: str
    ) -> AsyncIterator[Talk]:
        """Open a console's socket as a browser does, and say hello."""
        given = {"Cookie": cookie, **headers}
        async with connect(
            f"{self.origin.replace('http', 'ws')}/socket",
            ssl=self.trust,
            origin=self.origin,
            additional_headers=self.proved(given),
            close_timeout=0.2,
        ) as one:
            talk = Talk(one)
            await talk.say(type="hello", tab=tab, name=name)
            yield talk


async def until(condition: Callable[[], Any], patience: float = 5.0) -> Any:
    """Wait for a condition to become true and return its value."""
    async with asyncio.timeout(patience):
        while not (value := condition()):
            await asyncio.sleep(0.005)
    return value


@pytest.fixture(name="until")
def until_fixture() -> Callable[..., Any]:
    return until


@contextlib.asynccontextmanager
async def ready_page(chromium: Browser, console: Any, **options: Any) -> AsyncIterator[Page]:
    """Open a console that is ready on the pad; fails on errors of the page."""
    context = await chromium.new_context(**options)
    page = await context.new_page()
    troubles: list[str] = []
    page.on("pageerror", lambda error: troubles.append(str(error)))
    await page.goto(console.link)
    await expect(page.locator(".headline")).to_contain_text("Your drone is home")
    try:
        yield page
    finally:
        await context.close()
    assert troubles == []


@pytest.fixture(name="ready_page")
def ready_page_fixture() -> Callable[..., Any]:
    return ready_page


def contexts_of(
    files: CertificateFiles | None,
) -> tuple[ssl.SSLContext | None, ssl.SSLContext | None]:
    """Return the server's and a client's side of a certificate."""
    if files is None:
        return None, None
    web = WebConfig(tls_certificate=str(files.certificate), tls_key=str(files.key))
    loaded = load_certificate(web)
    assert loaded is not None
    return loaded.context, ssl.create_default_context(cafile=str(files.authority))


@contextlib.asynccontextmanager
async def serve(
    host: str,
    port: int = 0,
    stops: list[float] | None = None,
    coverage: Callable[[], CoverageView] | None = None,
    edits: EditService | None = None,
    view: RoomView | None = None,
    users: UserBook | None = None,
    certificate: CertificateFiles | None = None,
    **more: Any,
) -> AsyncIterator[Served]:
    with listening(host, port) as listener:
        bus, stops = LocalBus(), [] if stops is None else stops
        loop = asyncio.get_running_loop()
        pilot = FakePilot(bus.join(), view or example_room())
        app = create_app(
            bus,
            TOKEN,
            lambda: stops.append(loop.time()),
            hosts=frozenset({host}),
            secret=SECRET,
            coverage=coverage,
            edits=edits,
            users=users,
            **more,
        )
        tls, trust = contexts_of(certificate)
        server: uvicorn.Server = make_server(app, tls)
        serving = asyncio.create_task(server.serve([listener]))
        flying = asyncio.create_task(pilot.run())
        await until(lambda: server.started)
        try:
            yield Served(host, listener.getsockname()[1], bus, pilot, stops, trust=trust)
        finally:
            flying.cancel()
            server.should_exit = True
            await serving


@pytest_asyncio.fixture(loop_scope="session")
async def console(loopback: str) -> AsyncIterator[Served]:
    """Yield a running console with a fake pilot in real time."""
    async with serve(loopback) as served:
        yield served


@pytest.fixture(scope="module")
def cheap_passwords() -> Iterator[None]:
    """Make hashes of passwords cost next to nothing."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("housefly.web.access.passwords.COST_LOG2", 4)
        yield


@pytest.fixture(scope="session")
def serving() -> Callable[..., contextlib.AbstractAsyncContextManager[Served]]:
    """Return what starts a console, for tests that start it more than once."""
    return serve


@pytest_asyncio.fixture(loop_scope="session")
async def page(console: Any, chromium: Browser) -> AsyncIterator[Page]:
    """Yield the console that is ready on the pad; fails on errors of the page."""
    async with ready_page(chromium, console) as page:
        yield page
