"""The tasks over HTTP: who may ask, what the server fills in, what is refused and how."""

from __future__ import annotations

import asyncio
import http.client
import json
import threading
from collections.abc import AsyncIterator, Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from stand_in_tasks import StandInTasks
from starlette.applications import Starlette
from starlette.requests import HTTPConnection
from starlette.routing import Mount

from housefly.bus.local import LocalBus
from housefly.clock import RealClock
from housefly.tasks.api.endpoints import TASK_ENDPOINTS
from housefly.tasks.api.questions import BoardQuestion
from housefly.tasks.api.values import ReasonCode, TaskStage
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.roles import Role, role_for_path
from housefly.web.access.session import Session
from housefly.web.access.session_auth import PROOF_HEADER, SessionAuth, api_key
from housefly.web.access.users import UserBook
from housefly.web.access.webhook_key import webhook_key
from housefly.web.api.tasks_api import MAX_TASK_BODY, TasksApi
from housefly.web.api.tasks_endpoints import status_of_reason

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]

PASSWORD = "correct horse battery"
KEY = {"Authorization": f"Bearer {api_key('a-secret-for-tests-only')}"}
HOOK_KEY = "a-key-of-webhooks-for-tests"
WATCH, ASK, FLY, ADMIN = Role


@dataclass
class Home:
    """A console with one user a role, and tasks that fly nothing."""

    console: Any
    tasks: StandInTasks
    audit: Path
    cookies: dict[Role, str] = field(default_factory=dict)

    async def ask(
        self, method: str, path: str, body: Any = None, role: Role | None = FLY, **headers: Any
    ) -> tuple[int, Any]:
        """Return status and answer of a request by a user of a role, or by nobody."""
        own = {"Cookie": self.cookies[role], "Origin": self.console.origin} if role else {}
        text = body if isinstance(body, str) else "" if body is None else json.dumps(body)
        given = {name: value for name, value in {**own, **headers}.items() if value}
        status, _, answer = await self.console.request(method, f"/api/v1{path}", text, **given)
        return status, json.loads(answer) if answer else None


@pytest_asyncio.fixture(loop_scope="session", scope="module")
async def running(
    serving: Callable[..., Any], tmp_path_factory: pytest.TempPathFactory, cheap_passwords: None
) -> AsyncIterator[Home]:
    folder = tmp_path_factory.mktemp("state")
    book = UserBook(folder / "users.json")
    for role in Role:
        book.put(f"user-{role.value}", role, PASSWORD)
    audit = folder / "commands.jsonl"
    async with serving(
        "127.66.0.2", users=book, hook_key=HOOK_KEY, audit=AuditLog(audit)
    ) as console:
        home = Home(console, StandInTasks(console.bus.join()), audit)
        for role in Role:
            _, home.cookies[role] = await console.login(f"user-{role.value}", PASSWORD)
        yield home


@pytest.fixture
def home(running: Home) -> Home:
    running.tasks.tasks.clear()
    running.tasks.asked.clear()
    return running


async def test_a_request_becomes_a_task_of_the_one_who_asked(home: Home) -> None:
    status, answer = await home.ask(
        "POST", "/tasks", {"service": "look", "parameters": {"dwell": 3}}
    )
    assert status == 200
    (task,) = answer["tasks"]
    assert (task["asked_by"], task["surface"], task["state"]) == ("user-fly", "console", "queued")
    status, board = await home.ask("GET", "/tasks", role=WATCH)
    assert status == 200 and [one["id"] for one in board["tasks"]] == [task["id"]]
    for path in ("/services", "/tasks/history?since=5", "/rules", "/clips?task=1"):
        assert (await home.ask("GET", path, role=WATCH))[0] == 200
    assert (await home.ask("GET", "/rules/dry-run?since=0", role=ASK))[0] == 200


async def test_nobody_says_for_somebody_else_that_he_asked(home: Home) -> None:
    look, words = ("/tasks", {"service": "look"}), ("/sentence", {"text": "look at the door"})
    for (path, body), name, value in (
        (look, "by", "user-admin"),
        (look, "surface", "rule"),
        (look, "cause", "rule:bell"),
        (look, "ask", "mode"),
        (words, "may_fly", True),
    ):
        status, answer = await home.ask("POST", path, {**body, name: value})
        assert status == 422 and answer["error"].startswith(f"{name}: no such parameter")
    assert not home.tasks.tasks


async def test_who_may_only_ask_waits_for_the_yes_of_somebody_who_may_fly(home: Home) -> None:
    body = {"service": "look", "confirm": "auto", "priority": "alarm"}
    status, answer = await home.ask("POST", "/tasks", body, role=ASK)
    (task,) = answer["tasks"]
    assert (status, task["state"], task["priority"]) == (200, "waiting for a yes", "person")
    reply = {"question": "confirm", "choice": "yes"}
    status, refused = await home.ask("POST", f"/tasks/{task['id']}/reply", reply, role=ASK)
    assert status == 403 and "your role is 'ask'" in refused["error"]
    assert home.tasks.tasks[task["id"]].state is TaskStage.WAITING
    status, answer = await home.ask("POST", f"/tasks/{task['id']}/reply", reply, role=FLY)
    assert status == 200 and answer["tasks"][0]["state"] == "queued"
    assert answer["tasks"][0]["words"] == "user-fly said yes"


async def test_a_sentence_of_who_may_only_ask_flies_nothing_by_itself(home: Home) -> None:
    status, answer = await home.ask("POST", "/sentence", {"text": "look at the door"}, role=ASK)
    assert status == 200 and answer["task"]["state"] == "waiting for a yes"
    status, answer = await home.ask("POST", "/sentence", {"text": "where is the cup"}, role=ASK)
    assert (status, answer["task"]) == (200, None)
    status, answer = await home.ask("POST", "/sentence", {"text": "look at the door"})
    assert status == 200 and answer["task"]["state"] == "queued"


async def test_who_asked_ends_it_and_nobody_else_of_that_role_does(home: Home) -> None:
    mine = (await home.ask("POST", "/tasks", {"service": "look"}, role=ASK))[1]["tasks"][0]["id"]
    other = (await home.ask("POST", "/tasks", {"service": "look"}, role=FLY))[1]["tasks"][0]["id"]
    status, answer = await home.ask("POST", f"/tasks/{other}/cancel", {}, role=ASK)
    assert (status, answer["code"]) == (403, "not_allowed") and "STOP is for all" in answer["error"]
    status, answer = await home.ask("POST", f"/tasks/{mine}/cancel", role=ASK)
    assert status == 200 and answer["tasks"][0]["words"] == "user-ask ended it"
    status, answer = await home.ask("POST", "/tasks/0/cancel", role=FLY)
    assert status == 200 and [one["id"] for one in answer["tasks"]] == [other]


async def test_stop_in_words_waits_behind_nothing_that_takes_long(home: Home) -> None:
    home.tasks.rehearses.clear()
    slow = [
        asyncio.create_task(home.ask("POST", "/tasks/rehearse", {"service": "look"}))
        for _ in range(4)
    ]
    try:
        while len(home.tasks.asked) < 4:
            await asyncio.sleep(0.01)
        status, _ = await asyncio.wait_for(home.ask("POST", "/sentence", {"text": "stop"}), 5.0)
        assert status == 200
    finally:
        home.tasks.rehearses.set()
        await asyncio.gather(*slow)


async def test_a_flood_of_webhooks_is_cut_and_people_go_on(home: Home) -> None:
    ring = {"Authorization": f"Bearer {HOOK_KEY}"}
    found = [
        (await home.ask("POST", "/webhook/bell", {}, role=None, **ring))[0] for _ in range(120)
    ]
    assert found[0] == 200 and 429 in found
    assert (await home.ask("POST", "/tasks", {"service": "look"}))[0] == 200


async def test_pause_and_continue(home: Home) -> None:
    task = (await home.ask("POST", "/tasks", {"service": "look"}))[1]["tasks"][0]["id"]
    status, answer = await home.ask("POST", f"/tasks/{task}/pause", {})
    assert (status, answer["tasks"][0]["state"]) == (200, "paused")
    status, answer = await home.ask("POST", f"/tasks/{task}/continue", {})
    assert (status, answer["tasks"][0]["state"]) == (200, "running")


CHANGES = [one for one in TASK_ENDPOINTS if one.method == "POST" and "webhook" not in one.path]
NEEDED = {
    "/tasks": ASK,
    "/tasks/rehearse": ASK,
    "/tasks/{task}/reply": FLY,
    "/tasks/{task}/cancel": ASK,
    "/tasks/{task}/pause": FLY,
    "/tasks/{task}/continue": FLY,
    "/sentence": ASK,
    "/mode": FLY,
    "/photo": FLY,
    "/rules/{rule}/change": ADMIN,
    "/clips/{clip}/keep": FLY,
    "/clips/{clip}/delete": ADMIN,
}
"""Written down a second time, by hand."""


@pytest.mark.parametrize("role", Role)
@pytest.mark.parametrize("path", NEEDED)
async def test_each_change_needs_its_role(home: Home, path: str, role: Role) -> None:
    status, answer = await home.ask(
        "POST", path.format(task=7, clip="a", rule="bell"), {}, role=role
    )
    refused = status == 403 and "your role is" in answer["error"] and "needs" in answer["error"]
    assert refused is not role.includes(NEEDED[path])


async def test_every_path_of_the_tasks_has_a_role_of_its_own() -> None:
    assert {one.path for one in CHANGES} == set(NEEDED)
    for one in TASK_ENDPOINTS:
        if NEEDED.get(one.path) is not ADMIN and "webhook" not in one.path:
            path = "/api/v1" + one.path.format(task=3, clip="a")
            assert role_for_path(path, changes=one.method == "POST") is not ADMIN, path


async def test_another_site_and_a_page_without_proof_change_nothing(home: Home) -> None:
    body = {"service": "look"}
    for headers in ({"Origin": "http://evil.example"}, {"Origin": ""}, {"X-Housefly-Proof": "no"}):
        for one in CHANGES:
            path = one.path.format(task=1, clip="a", rule="bell")
            status, _ = await home.ask("POST", path, body, role=FLY, **headers)
            assert status in (401, 403), (path, headers)
    assert not [one for one in home.tasks.asked if not isinstance(one, BoardQuestion)]


async def test_nobody_is_answered_without_session_or_key(home: Home) -> None:
    for one in TASK_ENDPOINTS:
        for headers in ({}, {"Authorization": "Bearer wrong"}):
            status, answer = await home.ask(
                one.method,
                one.path.format(task=1, clip="a", name="bell", rule="bell"),
                {},
                role=None,
                **headers,
            )
            assert (status, answer["code"]) == (401, "not_allowed"), one.path
    assert (await home.ask("GET", "/clips/any", role=None))[0] == 401


async def test_a_program_with_the_key_says_what_it_is(home: Home) -> None:
    body = {"service": "look", "by": "anna's shell", "surface": "command line", "cause": "cron"}
    status, answer = await home.ask("POST", "/tasks", body, role=None, **KEY)
    (task,) = answer["tasks"]
    assert status == 200 and task["state"] == "queued"
    told = (task["asked_by"], task["surface"], task["cause"])
    assert told == ("anna's shell", "command line", "cron")
    assert (await home.ask("POST", "/tasks", {**body, "cause": 3}, role=None, **KEY))[0] == 422
    status, answer = await home.ask("POST", "/tasks", {"service": "look"}, role=None, **KEY)
    assert (answer["tasks"][0]["asked_by"], answer["tasks"][0]["surface"]) == ("a program", "http")
    for surface in ("console", "rule", "webhook", 3):
        wrong = {"service": "look", "surface": surface}
        assert (await home.ask("POST", "/tasks", wrong, role=None, **KEY))[0] == 422


@dataclass
class Alone:
    """The API without its server: something can happen before a body comes."""

    book: UserBook
    tasks: StandInTasks
    auth: SessionAuth
    api: TasksApi

    async def post(self, path: str, body: bytes, before: Callable[[Session], object]) -> int:
        """Return the status of a change by the user anna."""
        user = self.book.find("anna")
        assert user is not None
        cookie = self.auth.log_in(user)
        headers = {
            "host": "here",
            "origin": "http://here",
            "cookie": f"housefly_default={cookie}",
            PROOF_HEADER: self.auth.proof(cookie.partition(".")[0]),
        }
        scope = {
            "type": "http",
            "method": "POST",
            "scheme": "http",
            "server": ("here", 80),
            "path": f"/api/v1{path}",
            "query_string": b"",
            "headers": [(key.encode(), value.encode()) for key, value in headers.items()],
        }
        sent: list[Any] = []

        async def receive() -> Any:
            session = self.auth.session_of(HTTPConnection(scope))
            assert session is not None
            before(session)
            return {"type": "http.request", "body": body, "more_body": False}

        async def send(message: Any) -> None:
            sent.append(message)

        await Starlette(routes=[Mount("/api/v1", routes=self.api.routes())])(scope, receive, send)
        return int(sent[0]["status"])


@pytest.fixture
def alone(tmp_path: Path, cheap_passwords: None) -> Iterator[Alone]:
    book, bus = UserBook(tmp_path / "users.json"), LocalBus()
    book.put("anna", FLY, PASSWORD)
    auth = SessionAuth("first", "secret", book)
    api = TasksApi(bus.join(), auth, RealClock(), key="key")
    yield Alone(book, StandInTasks(bus.join()), auth, api)
    api.close()


async def test_whose_session_ends_before_the_body_comes_asks_for_nothing(alone: Alone) -> None:
    body = b'{"service": "look", "by": "somebody else"}'
    assert await alone.post("/tasks", b'{"service": "look"}', lambda _: None) == 200
    alone.tasks.asked.clear()
    assert await alone.post("/tasks", body, alone.auth.log_out) == 401
    watching = alone.post("/tasks", body, lambda _: alone.book.set_role("anna", WATCH))
    assert await watching == 403
    alone.book.set_role("anna", FLY)
    assert await alone.post("/tasks", body, lambda _: alone.book.remove("anna")) == 401
    assert not alone.tasks.asked


async def test_who_may_only_ask_ends_his_own_task_while_all_else_is_busy(alone: Alone) -> None:
    alone.book.set_role("anna", ASK)
    assert await alone.post("/tasks", b'{"service": "look"}', lambda _: None) == 200
    done = threading.Event()
    for _ in range(4):
        alone.api._threads.submit(done.wait, 20.0)
    try:
        async with asyncio.timeout(10.0):
            assert await alone.post("/tasks/1/cancel", b"", lambda _: None) == 200
    finally:
        done.set()


async def test_an_assistant_never_flies_without_a_yes(home: Home) -> None:
    for path, body in (
        ("/tasks", {"service": "look", "confirm": "auto", "priority": "alarm"}),
        ("/sentence", {"text": "look at the door", "confirm": "never"}),
    ):
        given = {**body, "surface": "assistant"}
        status, answer = await home.ask("POST", path, given, role=None, **KEY)
        task = answer["tasks"][0] if path == "/tasks" else answer["task"]
        assert (status, task["state"]) == (200, "waiting for a yes")


async def test_a_webhook_needs_its_own_key(home: Home, tmp_path: Path) -> None:
    ring = {"Authorization": f"Bearer {HOOK_KEY}"}
    assert (await home.ask("POST", "/webhook/bell", {}, role=None, **ring))[0] == 200
    assert home.tasks.asked[-1].by == "a webhook"
    for headers in (KEY, {}, {"Authorization": "Bearer x"}):
        assert (await home.ask("POST", "/webhook/bell", {}, role=None, **headers))[0] == 401
    assert (await home.ask("POST", "/tasks", {"service": "look"}, role=None, **ring))[0] == 401
    key = webhook_key(tmp_path / "tasks" / "webhook-key")
    assert len(key) > 30 and webhook_key(tmp_path / "tasks" / "webhook-key") == key
    assert (tmp_path / "tasks" / "webhook-key").stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize(
    ("path", "body", "named"),
    [
        ("/tasks", "{", "the body is not JSON"),
        ("/tasks", "[]", "the body is a JSON object"),
        ("/tasks", "[" * 9000, "the body is not JSON"),
        ("/tasks", {}, "service"),
        ("/tasks", {"service": "look", "colour": 1}, "colour"),
        ("/tasks", {"service": "look", "parameters": {"x": [1]}}, "parameters"),
        ("/tasks", '{"service": "look", "parameters": {"x": NaN}}', "the body is not JSON"),
        ("/tasks", {"service": "a" * 81}, "service"),
        ("/tasks", {"service": "a\nb"}, "service"),
        ("/tasks/x/cancel", {}, "task"),
        ("/tasks/1/reply", {"question": "confirm"}, "choice"),
        ("/sentence", {"text": "x" * 501}, "text"),
        ("/mode", {"mode": "party"}, "mode"),
    ],
)
async def test_what_is_wrong_is_named(home: Home, path: str, body: Any, named: str) -> None:
    status, answer = await home.ask("POST", path, body, role=ADMIN)
    assert status == 422 and answer["error"].startswith(named)
    assert answer["code"] == "bad_parameter"


async def test_what_is_too_large_is_refused_before_it_is_read(home: Home) -> None:
    status, _ = await home.ask("POST", "/tasks", "x" * (MAX_TASK_BODY + 1))
    assert status == 413


async def test_refusals_of_the_tasks_keep_their_code(home: Home) -> None:
    status, answer = await home.ask("POST", "/tasks", {"service": "dance"})
    assert (status, answer["code"]) == (404, "unknown_service")
    assert {status_of_reason(code.value) for code in ReasonCode} == {403, 404, 409, 422, 429, 503}


async def test_a_flood_is_slowed_and_cancel_and_pause_pass_it(home: Home) -> None:
    statuses = [
        (await home.ask("POST", "/sentence", {"text": "where is it"}, role=ADMIN))[0]
        for _ in range(60)
    ]
    assert 200 in statuses and 429 in statuses
    for _ in range(30):
        await home.ask("POST", "/mode", {"mode": "home"}, role=ADMIN)
    for path in ("/tasks/0/cancel", "/tasks/0/cancel"):
        assert (await home.ask("POST", path, {}, role=ADMIN))[0] == 200
    assert (await home.ask("POST", "/sentence", {"text": "where is it"}, role=ASK))[0] == 200


async def test_changes_are_written_down_with_who_and_what_became_of_it(
    home: Home, until: Callable[..., Any]
) -> None:
    await home.ask("POST", "/mode", {"mode": "night"}, role=FLY)
    await home.ask("POST", "/tasks", {"service": "dance"}, role=ASK)

    def told() -> dict[str, str]:
        by = {line["who"]: line["what"] for line in lines_of(home.audit, '"night"', '"dance"')}
        return by if {"user-fly", "user-ask"} <= set(by) else {}

    by = await until(told)
    assert '"mode":"night"' in by["user-fly"] and by["user-ask"].endswith("refused, 404")


def lines_of(file: Path, *words: str) -> list[Any]:
    """Return the lines that hold one of the words, or none while one is missing."""
    text = file.read_text() if file.exists() else ""
    quoted = [word.replace('"', '\\"') for word in words]
    if not all(word in text for word in quoted):
        return []
    return [json.loads(one) for one in text.splitlines() if any(word in one for word in quoted)]


async def test_browsers_hear_the_board_and_that_nobody_keeps_it(
    serving: Any, loopback: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("housefly.web.status.task_feed.SILENCE", 0.5)
    monkeypatch.setattr("housefly.web.sockets.broadcast.BOARD_PERIOD", 0.1)
    async with serving(loopback) as console:
        cookie = await console.session()
        async with console.talk(cookie) as talk:
            assert (await talk.hear("tasks"))["running"] is False
            tasks = StandInTasks(console.bus.join())
            told = await talk.hear("tasks", running=True)
            assert told["board"]["mode"] == "home" and told["board"]["tasks"] == []
            tasks.ring()
            told = await talk.hear("tasks", running=True)
            (task,) = told["board"]["tasks"]
            assert task["question"]["choices"] == ["look", "ignore"]
            tasks.close()
            while (told := await talk.hear("tasks", running=False))["board"] is None:
                """What was said before the first board."""
            assert told["board"]["tasks"] == [task], "the last that is known, said to be old"
        async with console.talk(cookie, "tab-number-two") as late:
            assert (await late.hear("tasks"))["running"] is False


async def test_without_anybody_who_keeps_tasks_it_is_503_in_words(
    serving: Any, loopback: str
) -> None:
    async with serving(loopback) as console:
        status, _, text = await console.request("GET", "/api/v1/tasks", **KEY)
        assert status == 503 and json.loads(text)["code"] == "not_ready"
        assert "the services do not answer" in text
        assert http.client.responses[status] == "Service Unavailable"
