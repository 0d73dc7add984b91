"""Whoever sees a clip is written down once, whatever part of it they ask for."""

from __future__ import annotations

import asyncio
import io
import json
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.applications import Starlette

from housefly.config.tasks import TasksConfig
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_result import ClipOrigin
from housefly.evidence.clip_store import new_clip_row
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.roles import Role, role_for_path
from housefly.web.access.session_auth import SessionAuth
from housefly.web.api.clip_files import ClipFiles

KEY = "a-key-for-tests"


class Show:
    """One clip behind HTTP, and a clock that the test turns."""

    def __init__(self, folder: Path) -> None:
        self.now = 100.0
        self.index = ClipIndex(folder, TasksConfig())
        row = new_clip_row("clip", 1_790_000_000.0, ClipOrigin())
        (folder / f"{row.id}.mp4").write_bytes(bytes(1000))
        self.index.finish(row)
        self.clip = row.id
        auth = SessionAuth("first", "secret")
        snap = new_clip_row("snapshot", 1_790_000_001.0, ClipOrigin())
        (folder / f"{snap.id}.jpg").write_bytes(bytes(100))
        self.index.finish(snap)
        self.snapshot = snap.id
        self.log = folder / "commands.jsonl"
        self.audit = AuditLog(self.log)
        files = ClipFiles(self.index, auth, KEY, str, self.audit, clock=lambda: self.now)
        self._app = Starlette(routes=files.routes())

    async def ask(
        self, asked: str = "", query: str = "", method: str = "GET", path: str = "", key: str = KEY
    ) -> int:
        """Return the status of a request for a part of the clip, or for another path."""
        headers = [(b"authorization", f"Bearer {key}".encode())]
        headers += [(b"range", asked.encode())] if asked else []
        path = path or f"/clips/{self.clip}"
        scope = {"type": "http", "method": method, "path": path, "query_string": query.encode()}
        sent: list[dict[str, Any]] = []

        async def receive() -> dict[str, Any]:
            await asyncio.Event().wait()  # it stays to the end
            return {"type": "http.disconnect"}

        async def send(message: dict[str, Any]) -> None:
            sent.append(message)

        await self._app({**scope, "headers": headers, "root_path": ""}, receive, send)  # type: ignore[arg-type]
        self.body = b"".join(message.get("body", b"") for message in sent[1:])
        return int(sent[0]["status"])

    def told(self) -> list[tuple[str, str]]:
        """Return who did what by the audit log, which ends here."""
        self.audit.close()
        lines = map(json.loads, self.log.read_text().splitlines()) if self.log.exists() else ()
        return [(line["who"], line["what"]) for line in lines]

    @property
    def seen(self) -> list[str]:
        return [view.what for view in self.index.audit_log(self.clip)]


@pytest.fixture
def show(tmp_path: Path) -> Iterator[Show]:
    made = Show(tmp_path)
    yield made
    made.index.close()


@pytest.mark.parametrize(
    "asked", ["", "bytes=0-", "bytes=1-", "bytes=00-", "Bytes=0-", "bytes=-99999999", "bytes=500-"]
)
async def test_whatever_part_is_asked_for_first_is_written_down(show: Show, asked: str) -> None:
    assert await show.ask(asked) in (200, 206)
    assert show.seen == ["watched"]


async def test_a_player_that_asks_often_is_written_down_once_in_ten_minutes(show: Show) -> None:
    for asked in ("", "", "bytes=0-", "bytes=200-"):
        assert await show.ask(asked) in (200, 206)
    assert await show.ask(method="HEAD") == 200
    assert show.seen == ["watched"]
    await show.ask(query="download=1")
    assert show.seen == ["watched", "exported"]
    show.now += 601.0
    await show.ask("bytes=200-")
    assert show.seen == ["watched", "exported", "watched"]


async def test_who_played_a_clip_looked_at_a_snapshot_and_took_both_away_is_in_the_audit_log(
    show: Show,
) -> None:
    assert await show.ask() == 200
    assert await show.ask(path=f"/clips/{show.snapshot}") == 200
    assert await show.ask(query="download=1") == 200
    both = f"clip={show.clip}&clip={show.snapshot}"
    assert await show.ask(query=both, path="/clips.zip") == 200
    with zipfile.ZipFile(io.BytesIO(show.body)) as archive:
        assert archive.testzip() is None
        assert set(archive.namelist()) == {
            *(f"{show.clip}.mp4", f"{show.snapshot}.jpg", "clips.json", "SHA256SUMS")
        }
    assert show.seen == ["watched", "exported", "exported"]
    assert [view.what for view in show.index.audit_log(show.snapshot)] == ["watched", "exported"]
    assert show.told() == [
        ("a program", f"watched the clip {show.clip}"),
        ("a program", f"watched the clip {show.snapshot}"),
        ("a program", f"downloaded the clip {show.clip}"),
        ("a program", f"exported the clips {show.clip}, {show.snapshot}"),
    ]


@pytest.mark.parametrize(
    ("query", "key", "status"),
    [
        ("", KEY, 404),
        ("clip=nothing", KEY, 404),
        ("&".join(f"clip=c{n}" for n in range(201)), KEY, 404),
        ("clip=nothing", "a guess", 401),
    ],
)
async def test_an_export_of_nothing_too_much_or_by_nobody_is_refused_and_not_written_down(
    show: Show, query: str, key: str, status: int
) -> None:
    assert await show.ask(query=query, path="/clips.zip", key=key) == status
    assert show.told() == []


def test_who_only_watches_takes_away_no_list_of_those_who_watched() -> None:
    assert role_for_path("/api/v1/clips/20260921-1", changes=False) is Role.WATCH
    assert role_for_path("/api/v1/clips.zip", changes=False) is Role.FLY
