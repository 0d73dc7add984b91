"""Who asked for what is on disk, also what was refused, and a flood does not fill the disk."""

from __future__ import annotations

import json
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio

from housefly.config.edits import Edits
from housefly.config.site import Site
from housefly.room.bsen import bsen
from housefly.room.edit_versions import EditVersions
from housefly.web.access.audit_log import AuditLog
from housefly.web.api.edit_service import EditService

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]

TAB = "tab-number-one"


@dataclass
class Watched:
    """A console that writes down what it is asked for."""

    console: Any
    file: Path
    versions: EditVersions

    def lines(self, words: str, who: str = "") -> list[dict[str, Any]]:
        """Return the lines whose ``what`` has the words."""
        text = self.file.read_text(encoding="utf-8") if self.file.exists() else ""
        lines = [json.loads(line) for line in text.splitlines()]
        return [one for one in lines if words in one["what"] and who in one["who"]]

    async def edit(self, cookie: str, body: Any, path: str = "/edits") -> int:
        text = body if isinstance(body, str) else json.dumps(body)
        headers = {"Cookie": cookie, "Origin": self.console.origin}
        status: int = (await self.console.request("POST", path, text, **headers))[0]
        return status


@pytest_asyncio.fixture(loop_scope="session")
async def watched(
    serving: Callable[..., Any], loopback: str, tmp_path: Path
) -> AsyncIterator[Watched]:
    file, versions = tmp_path / "commands.jsonl", EditVersions(tmp_path / "edits")
    edits = EditService(bsen, Site(), versions)
    async with serving(loopback, audit=AuditLog(file), edits=edits) as console:
        yield Watched(console, file, versions)


async def a_guest(console: Any, host: Any, role: str) -> str:
    await host.say(type="invite", id=1, role=role)
    _, headers, _ = await console.request("GET", (await host.hear("invite", id=1))["path"])
    cookie: str = console.opened(headers)
    return cookie


async def test_a_take_off_a_stop_and_a_refused_order_are_written_down_with_who_asked(
    watched: Watched, until: Any
) -> None:
    console = watched.console
    cookie = await console.session()
    async with (
        console.talk(cookie, "tab-of-anna", "Anna") as anna,
        console.talk(cookie, "tab-of-ben", "Ben") as ben,
    ):
        await anna.hear("room")
        await anna.hear("state")
        await anna.say(type="order", id=1, order="take_off")
        await anna.hear("accepted", id=1)
        await ben.say(type="order", id=2, order="hover")
        await ben.hear("refused", id=2)
        await ben.say(type="stop", id=3)
        await ben.hear("accepted", id=3)
    (took_off,) = await until(lambda: watched.lines("take off", "Anna"))
    (refused,) = await until(lambda: watched.lines("hover refused: Anna has control", "Ben"))
    (stop,) = await until(lambda: watched.lines("STOP", "Ben"))
    assert took_off["at"] <= refused["at"] <= stop["at"]
    assert took_off["session"] == refused["session"] == stop["session"] != ""


async def test_what_a_role_or_nobodys_control_forbids_is_written_down_too(
    watched: Watched, until: Any
) -> None:
    console = watched.console
    async with console.talk(await console.session(), TAB, "Anna") as anna:
        watcher = await a_guest(console, anna, "watch")
        async with console.talk(watcher, "another-tab", "Wim") as wim:
            await wim.say(type="order", id=5, order="take_off")
            await wim.hear("refused", id=5)
        await anna.say(type="lease", id=6, action="give", to=999)
        await anna.hear("refused", id=6)
    assert await until(lambda: watched.lines("order refused: your role", "Wim"))
    assert await until(
        lambda: watched.lines("give control refused: that viewer is not here", "Anna")
    )


async def test_a_message_that_cannot_be_read_is_written_down_short(
    watched: Watched, until: Any
) -> None:
    console = watched.console
    async with console.talk(await console.session(), TAB, "Eve") as eve:
        await eve.say(type="order", id=1, order="explode")
        await eve.hear("refused")
        await eve.say(type="stop", id=2, **{"x" * 5000: 1})
        await eve.hear("refused")
        await eve.socket.send("no JSON")
        await eve.hear("refused")
    found = await until(lambda: len(lines := watched.lines("cannot be read", "Eve")) == 3 and lines)
    assert max(len(line["what"]) for line in found) < 500


async def test_edits_that_are_refused_are_written_down_with_the_reason(
    watched: Watched, until: Any
) -> None:
    console = watched.console
    cookie = await console.session()
    async with console.talk(cookie, TAB, "Ada") as ada:
        await ada.hear("viewers")
        watcher = await a_guest(console, ada, "watch")
        watched.versions.save(Edits(removed=("bed",)), 0, "Ben")
        stale = {"based_on": 0, "tab": TAB, "edits": {}}
        assert await watched.edit(cookie, stale) == 409
        assert await watched.edit(cookie, "no JSON") == 422
        assert await watched.edit(cookie, {**stale, "tab": "unknown"}, "/edits/undo") == 403
        assert await watched.edit(watcher, stale) == 403
        assert await watched.edit("", stale) in (401, 403)
        assert await until(lambda: watched.lines("POST /edits refused, 409", "Ada"))
        assert await until(
            lambda: watched.lines("POST /edits refused, 422: the body is not", "Ada")
        )
        assert await until(lambda: watched.lines("POST /edits/undo refused, 403", "Ada"))
        assert await until(lambda: watched.lines("refused, 403: your role is 'watch'"))
        assert await until(lambda: watched.lines("refused, 403", "somebody without a session"))


async def test_a_flood_of_commands_makes_a_line_a_second_with_its_number(
    watched: Watched, until: Any
) -> None:
    console = watched.console
    async with console.talk(await console.session(), TAB, "Mallory") as mallory:
        await mallory.hear("welcome")
        for number in range(200):
            await mallory.say(type="order", id=number, order="hover")
        await mallory.say(type="stop", id=1000)
        await mallory.hear("accepted", id=1000)
        last = await until(lambda: watched.lines("the last of"), 10.0)
    too_many = watched.lines("too many commands", "Mallory")
    assert 2 <= len(too_many) <= 5 and last
    assert watched.lines("STOP", "Mallory")


async def test_a_flood_of_refusals_does_not_fill_the_disk(watched: Watched, until: Any) -> None:
    console = watched.console
    cookie = await console.session()
    for _ in range(150):
        assert await watched.edit(cookie, "no JSON") == 422
    (*_, last) = await until(lambda: watched.lines("the last of"), 10.0)
    assert "POST /edits refused, 422" in last["what"]
    assert len(watched.lines("POST /edits refused")) <= 30
