"""The table of roles, cell by cell: every role sends every message and asks for every path."""

from __future__ import annotations

import asyncio
import contextlib
import http.client
import typing
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from starlette.routing import Mount, Route, WebSocketRoute
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidStatus

from housefly.bus.local import LocalBus
from housefly.messages import OrderKind
from housefly.sites.loaded_site import load_site
from housefly.web.access.roles import (
    OPEN_FOLDERS,
    OPEN_PATHS,
    ROLE_OF_CHANGE,
    ROLE_OF_CLIP_CHANGE,
    ROLE_OF_FOLDER,
    ROLE_OF_MESSAGE,
    ROLE_OF_ORDER,
    ROLE_OF_PATH,
    ROLE_OF_RULE_CHANGE,
    ROLE_OF_TASK_CHANGE,
    Role,
)
from housefly.web.access.users import UserBook
from housefly.web.messages.client_messages import ClientMessage
from housefly.web.rosbridge.bridge_room import BridgeRoom
from housefly.web.server import create_app

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]
PASSWORD = "correct horse battery"
WATCH, ASK, FLY, ADMIN = Role

ORDERS: dict[str, Role] = {
    "stop": WATCH, "land": WATCH,
    "take_off": FLY, "hover": FLY, "go": FLY, "service": FLY, "home": FLY, "resume": FLY,
    "cut": FLY, "reset": FLY, "nudge": FLY,
}  # fmt: skip
"""Written down a second time, by hand: who changes the table of the server changes this one."""
TARGETS: dict[str, dict[str, Any]] = {"go": {"goal": [2, 2]}, "service": {"place": "entrance"}}
MESSAGES: dict[str, tuple[Role, dict[str, Any]]] = {
    "hello": (WATCH, {"tab": "a-tab-of-mine"}),
    "ping": (WATCH, {"sent": 1.0}),
    "stop": (WATCH, {}),
    "plan": (ASK, {"place": "entrance"}),
    "lease": (FLY, {"action": "take", "held": True}),
    "invite": (ADMIN, {}),
    **{
        f"order {order}": (needed, {"order": order, **TARGETS.get(order, {})})
        for order, needed in ORDERS.items()
    },
}
ENDLESS = ("GET", "/video.mjpeg")
PATHS: dict[tuple[str, str], Role] = {
    ("POST", "/stop"): WATCH,
    ENDLESS: WATCH,
    ("GET", "/coverage"): WATCH,
    ("GET", "/flights"): WATCH,
    ("GET", "/flights/20270115T080000250Z"): WATCH,
    ("GET", "/edits"): WATCH,
    ("POST", "/edits"): ADMIN,
    ("POST", "/edits/undo"): ADMIN,
    ("GET", "/api/v1/picture"): WATCH,
    ("GET", "/api/v1/things"): WATCH,
    ("GET", "/api/v1/events"): WATCH,
    ("GET", "/api/v1/feed"): WATCH,
    ("GET", "/api/v1/sensors"): WATCH,
    ("GET", "/api/v1/where/cup"): ASK,
    ("GET", "/api/v1/near?thing=cup"): ASK,
    ("GET", "/api/v1/contents/shelf"): ASK,
    ("GET", "/api/v1/trajectory/cup"): ASK,
    ("GET", "/api/v1/tasks"): WATCH,
    ("GET", "/api/v1/tasks/history"): WATCH,
    ("GET", "/api/v1/services"): WATCH,
    ("GET", "/api/v1/rules"): WATCH,
    ("GET", "/api/v1/rules/dry-run?since=0"): ASK,
    ("GET", "/api/v1/clips"): WATCH,
    ("GET", "/api/v1/clips/a-clip"): WATCH,
    ("POST", "/api/v1/tasks"): ASK,
    ("POST", "/api/v1/tasks/rehearse"): ASK,
    ("POST", "/api/v1/tasks/7/cancel"): ASK,
    ("POST", "/api/v1/tasks/7/reply"): FLY,
    ("POST", "/api/v1/tasks/7/pause"): FLY,
    ("POST", "/api/v1/tasks/7/continue"): FLY,
    ("POST", "/api/v1/tasks/7/dance"): ADMIN,
    ("POST", "/api/v1/tasks//cancel"): ADMIN,
    ("POST", "/api/v1/sentence"): ASK,
    ("POST", "/api/v1/mode"): FLY,
    ("POST", "/api/v1/rules/bell/change"): ADMIN,
    ("POST", "/api/v1/clips/a-clip/keep"): FLY,
    ("POST", "/api/v1/clips/a-clip/delete"): ADMIN,
    ("DELETE", "/api/v1/clips/a-clip"): ADMIN,
    ("GET", "/a-path-that-nobody-thought-of"): ADMIN,
    ("POST", "/socket"): ADMIN,
    ("DELETE", "/edits"): ADMIN,
}
SOCKETS = {"/socket": WATCH, "/video": WATCH, "/api/v1/watch": WATCH}
KEY_ONLY = "/api/v1/webhook/{name}"
"""No session opens it, only a key of its own: tests/web/api/test_tasks_api.py."""
REFUSED = "your role is"


@pytest_asyncio.fixture(loop_scope="session", scope="module")
async def console(
    tmp_path_factory: pytest.TempPathFactory, cheap_passwords: None
) -> AsyncIterator[Any]:
    """Yield a console with one user a role, logged in; ``cookies`` has their sessions."""
    from web_conftest import serve

    book = UserBook(tmp_path_factory.mktemp("state") / "users.json")
    for role in Role:
        book.put(f"user-{role.value}", role, PASSWORD)
    async with serve("127.66.0.1", users=book) as served:
        served.cookies = {}
        for role in Role:
            status, served.cookies[role] = await served.login(f"user-{role.value}", PASSWORD)
            assert status == 303
        yield served


@pytest.mark.parametrize("role", Role)
@pytest.mark.parametrize("message", MESSAGES)
async def test_each_message_of_each_role(console: Any, role: Role, message: str) -> None:
    needed, fields = MESSAGES[message]
    stops = len(console.stops)
    async with console.talk(console.cookies[role], f"tab-of-{role.value}") as one:
        await one.hear("room")
        if role.includes(FLY) and message.startswith("order"):
            await one.say(type="lease", id=900, action="take", held=True)
            await one.hear("accepted", id=900)
        kind = message.split()[0]
        more = {} if kind in ("hello", "ping") else {"id": 901}
        await one.say(type=kind, **more, **fields)
        await one.say(type="ping", sent=902.0)
        await one.hear("pong", sent=902.0)
        refusals = [m["reason"] for m in one.heard if m["type"] == "refused"]
        assert any(REFUSED in reason for reason in refusals) is not role.includes(needed)
    if not role.includes(needed):
        assert len(console.stops) == stops
        mine = [one for one in console.pilot.orders if one.sender == f"user-{role.value}"]
        assert fields.get("order") not in {order.kind.value for order in mine}


@pytest.mark.parametrize("role", Role)
@pytest.mark.parametrize("asked", [path for path in PATHS if path != ENDLESS], ids=" ".join)
async def test_each_path_for_each_role(console: Any, role: Role, asked: tuple[str, str]) -> None:
    method, path = asked
    headers = {"Cookie": console.cookies[role], "Origin": console.origin}
    status, _, text = await console.request(method, path, **headers)
    assert (status == 403 and REFUSED in text) is not role.includes(PATHS[asked]), (status, text)


@pytest.mark.parametrize("role", [*Role, None])
async def test_the_picture_without_end_is_for_whoever_may_watch(
    console: Any, role: Role | None
) -> None:
    def status() -> int:
        connection = http.client.HTTPConnection(console.host, console.port, timeout=5)
        headers = console.proved({"Cookie": console.cookies[role]}) if role else {}
        with contextlib.closing(connection):
            connection.request(*ENDLESS, headers=headers)
            return connection.getresponse().status

    assert (await asyncio.to_thread(status) == 200) is (role is not None)


@pytest.mark.parametrize("role", Role)
@pytest.mark.parametrize("path", SOCKETS)
async def test_each_socket_for_each_role(console: Any, role: Role, path: str) -> None:
    headers = console.proved({"Cookie": console.cookies[role]})
    address = f"ws://{console.host}:{console.port}{path}"
    refused = True
    with contextlib.suppress(InvalidStatus, ConnectionClosed):
        async with connect(
            address, origin=console.origin, additional_headers=headers, close_timeout=0.1
        ) as one:
            await one.ping()
            refused = False
    assert refused is not role.includes(SOCKETS[path])


async def test_no_message_no_order_and_no_path_is_without_a_role() -> None:
    kinds = set(typing.get_args(ClientMessage))
    assert {kind.__name__ for kind in kinds} - {"OrderRequest"} == {
        kind.__name__ for kind in ROLE_OF_MESSAGE
    }
    assert set(ROLE_OF_ORDER) == set(OrderKind) == {OrderKind(name) for name in ORDERS}
    assert {order.value: role for order, role in ROLE_OF_ORDER.items()} == ORDERS
    bridge = BridgeRoom(LocalBus(), lambda: load_site("bsen"))
    app = create_app(LocalBus(), "token", lambda: None, rosbridge=bridge)
    reading, changing = set(), set()
    for prefix, route in every_route(app.routes):
        path = prefix + route.path
        if path in OPEN_PATHS:
            continue
        if isinstance(route, WebSocketRoute) or not route.methods or "GET" in route.methods:
            reading.add(path.partition("{")[0])
        else:
            changing.add(path)
    assert reading == (set(ROLE_OF_PATH) - {"/stop"}) | set(ROLE_OF_FOLDER)
    of_a_task = {f"/api/v1/tasks/{{task}}/{change}" for change in ROLE_OF_TASK_CHANGE}
    of_a_clip = {f"/api/v1/clips/{{clip}}/{change}" for change in ROLE_OF_CLIP_CHANGE}
    of_a_rule = {f"/api/v1/rules/{{rule}}/{change}" for change in ROLE_OF_RULE_CHANGE}
    assert changing == set(ROLE_OF_CHANGE) | of_a_task | of_a_clip | of_a_rule | {KEY_ONLY}


def every_route(routes: Any, prefix: str = "") -> list[tuple[str, Any]]:
    found = []
    for route in routes:
        if isinstance(route, Mount) and route.path + "/" not in OPEN_FOLDERS:
            found += every_route(route.routes, prefix + route.path)
        elif isinstance(route, Route | WebSocketRoute):
            found.append((prefix, route))
    return found


@pytest.fixture
async def two(
    serving: Callable[..., Any], loopback: str, tmp_path: Path, cheap_passwords: None
) -> AsyncIterator[tuple[Any, UserBook]]:
    book = UserBook(tmp_path / "users.json")
    book.put("anna", FLY, PASSWORD)
    book.put("wim", WATCH, PASSWORD)
    async with serving(loopback, users=book) as served:
        yield served, book


@pytest.mark.asyncio(loop_scope="function")
async def test_a_role_that_is_taken_away_is_gone_at_once_and_with_it_control(two: Any) -> None:
    console, book = two
    _, cookie = await console.login("anna", PASSWORD)
    async with console.talk(cookie) as one:
        await one.hear("viewers", pilot=1)
        book.set_role("anna", WATCH)
        await one.say(type="order", id=1, order="take_off")
        assert "your role is 'watch'" in (await one.hear("refused", id=1))["reason"]
        assert console.pilot.orders == []
        await one.hear("viewers", pilot=None)
        await one.say(type="stop", id=2)
        await one.hear("accepted", id=2)
        assert len(console.stops) == 1, "STOP passes whatever the role"


@pytest.mark.asyncio(loop_scope="function")
async def test_who_only_watches_gets_no_control_by_being_first_or_by_being_given_it(
    two: Any,
) -> None:
    console, _ = two
    _, watcher = await console.login("wim", PASSWORD)
    _, pilot = await console.login("anna", PASSWORD)
    async with console.talk(watcher, "tab-of-wim") as wim:
        assert (await wim.hear("viewers"))["pilot"] is None, "not even for a moment"
        async with console.talk(pilot, "tab-of-anna") as anna:
            await anna.say(type="lease", id=1, action="take")
            await wim.hear("viewers", pilot=2)
            await anna.say(type="lease", id=2, action="give", to=1)
            assert "may not fly" in (await anna.hear("refused", id=2))["reason"]


@pytest.mark.asyncio(loop_scope="function")
async def test_a_watcher_who_names_the_pilots_tab_is_somebody_else(two: Any) -> None:
    console, _ = two
    _, watcher = await console.login("wim", PASSWORD)
    _, pilot = await console.login("anna", PASSWORD)
    async with console.talk(pilot, "tab-of-anna") as anna:
        await anna.hear("viewers", pilot=1)
        async with console.talk(watcher, "tab-of-anna", "anna") as wim:
            assert (await wim.hear("welcome"))["you"] == 2
            await anna.hear(
                "viewers", viewers=[{"id": 1, "name": "anna"}, {"id": 2, "name": "wim"}]
            )
            await anna.say(type="ping", sent=1.0)
            await anna.hear("pong", sent=1.0)
