"""Whoever sees a clip is written down once, whatever part of it they ask for."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.applications import Starlette

from housefly.config.tasks import TasksConfig
from housefly.tasks.evidence.clip_index import ClipIndex
from housefly.tasks.evidence.clip_news import ClipOrigin
from housefly.tasks.evidence.clip_store import new_clip_row
from housefly.web.clip_files import ClipFiles
from housefly.web.session_auth import SessionAuth

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
        files = ClipFiles(self.index, auth, KEY, str, clock=lambda: self.now)
        self._app = Starlette(routes=files.routes())

    async def ask(self, asked: str = "", query: str = "", method: str = "GET") -> int:
        """Return the status of a request for a part of the clip."""
        headers = [(b"authorization", f"Bearer {KEY}".encode())]
        headers += [(b"range", asked.encode())] if asked else []
        path = f"/clips/{self.clip}"
        scope = {"type": "http", "method": method, "path": path, "query_string": query.encode()}
        sent: list[dict[str, Any]] = []

        async def receive() -> dict[str, Any]:
            return {"type": "http.disconnect"}

        async def send(message: dict[str, Any]) -> None:
            sent.append(message)

        await self._app({**scope, "headers": headers, "root_path": ""}, receive, send)  # type: ignore[arg-type]
        return int(sent[0]["status"])

    @property
    def seen(self) -> list[str]:
        return [view.what for view in self.index.views(self.clip)]


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
