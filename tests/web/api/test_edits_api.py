"""Places and zones over HTTP: who may change them, what is refused, and concurrent changes."""

from __future__ import annotations

import asyncio
import http.client
import json
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio

from housefly.config.edits import Edits, NoFlyZone
from housefly.config.site import Site, changed
from housefly.room.bsen import bsen
from housefly.room.edit_versions import EditVersions
from housefly.web.api.edit_service import EditService
from housefly.web.api.edits_api import MAX_BODY_SIZE

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]

TAB, OTHER = "tab-number-one", "tab-number-two"
PLACE = {
    "name": "corner",
    "title": "Reading corner",
    "viewpoint": [6.0, 4.25],
    "look_at": [5.0, 5.0, 1.0],
}
OVER_HOME = {"zones": [{"rectangle": [10.2, 1.0, 11.0, 1.6], "reason": "mine"}]}


@dataclass
class Editor:
    """A browser before a console whose room can be edited."""

    console: Any
    cookie: str
    versions: EditVersions

    async def get(self, **headers: str) -> tuple[int, Any]:
        return await self._request("GET", "/edits", None, {"Cookie": self.cookie, **headers})

    async def post(self, body: Any, path: str = "/edits", **headers: str) -> tuple[int, Any]:
        given = {"Cookie": self.cookie, "Origin": self.console.origin, **headers}
        return await self._request(
            "POST", path, body if isinstance(body, bytes) else json.dumps(body).encode(), given
        )

    async def save(self, edits: Any, based_on: int = 0, tab: str = TAB) -> tuple[int, Any]:
        return await self.post({"based_on": based_on, "tab": tab, "edits": edits})

    async def _request(
        self, method: str, path: str, body: bytes | None, headers: dict[str, str]
    ) -> tuple[int, Any]:
        def work() -> tuple[int, Any]:
            connection = http.client.HTTPConnection(
                self.console.host, self.console.port, timeout=20
            )
            try:
                given = {key: value for key, value in headers.items() if value}
                connection.request(method, path, body, self.console.proved(given))
                answer = connection.getresponse()
                return answer.status, json.loads(answer.read())
            finally:
                connection.close()

        return await asyncio.to_thread(work)


@pytest_asyncio.fixture(loop_scope="session")
async def editor(
    serving: Callable[..., Any], loopback: str, tmp_path: Path
) -> AsyncIterator[Editor]:
    versions = EditVersions(tmp_path / "edits")
    async with serving(loopback, edits=EditService(bsen, Site(), versions)) as console:
        cookie = await console.session()
        async with console.talk(cookie, TAB, "Ada") as talk:
            await talk.hear("viewers")
            yield Editor(console, cookie, versions)


async def test_a_place_is_saved_seen_and_undone(editor: Editor) -> None:
    status, view = await editor.get()
    assert (status, view["version"], view["undoable"], view["words"]) == (200, 0, False, "")
    assert [place["name"] for place in view["places"]] == [place.name for place in bsen().places]
    status, saved = await editor.save({"places": [PLACE], "removed": ["bed"]})
    assert (status, saved["version"], saved["by"], saved["undoable"]) == (200, 1, "Ada", True)
    assert "from the next start of Housefly on" in saved["words"]
    assert {place["name"] for place in saved["own"]} - {
        place["name"] for place in saved["places"]
    } == {"bed"}
    assert (await editor.get())[1] == saved
    status, undone = await editor.post({"based_on": 1, "tab": TAB}, "/edits/undo")
    assert (status, undone["version"], undone["places"], undone["undoable"]) == (
        200,
        2,
        view["places"],
        False,
    )
    status, answer = await editor.post({"based_on": 2, "tab": TAB}, "/edits/undo")
    assert status == 422 and "nothing to undo" in answer["error"]


async def test_what_cannot_be_flown_is_422_in_words_and_says_which(editor: Editor) -> None:
    status, answer = await editor.save(OVER_HOME)
    assert status == 422 and answer["item"] == "zones.0"
    assert "covers the home pad" in answer["error"] and "0.40 m" in answer["error"]
    assert not editor.versions.folder.exists()


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"{",
        b"[" * 9000,
        b"[]",
        b'{"based_on": -1, "tab": "x"}',
        b'{"based_on": true, "tab": "x"}',
        b'{"based_on": 0}',
        b'{"based_on": 0, "tab": "tab-number-one", "edits": {"places": [{"name": 3}]}}',
        b'{"based_on": 0, "tab": "tab-number-one", "edits": [], "more": 1}',
        (
            b'{"based_on": 0, "tab": "tab-number-one", "edits": {"zones": [{"rectangle": [NaN, 0,'
            b' 1, 1], "reason": "x"}]}}'
        ),
    ],
)
async def test_a_body_that_is_no_wish_is_422(editor: Editor, body: bytes) -> None:
    status, answer = await editor.post(body)
    assert status == 422 and answer["error"]


async def test_too_large_a_body_is_413(editor: Editor) -> None:
    assert (await editor.post(b" " * (MAX_BODY_SIZE + 1)))[0] == 413


async def test_other_pages_strangers_and_watchers_may_not(editor: Editor) -> None:
    body = {"based_on": 0, "tab": TAB, "edits": {"removed": ["bed"]}}
    assert (await editor.post(body, Origin="http://elsewhere.example"))[0] == 403
    assert (await editor.post(body, Origin=""))[0] == 403
    assert (await editor.post(body, Cookie=""))[0] == 403
    assert (await editor.post(body, "/edits/undo", Cookie=""))[0] == 403
    assert (await editor.get(Cookie=""))[0] == 401
    status, answer = await editor.save({"removed": ["bed"]}, tab=OTHER)
    assert (status, answer["error"]) == (403, "Ada has control")
    async with editor.console.talk(editor.cookie, OTHER, "Bob") as talk:
        await talk.hear("viewers")
        assert (await editor.save({"removed": ["bed"]}, tab=OTHER))[0] == 403
        await talk.say(type="lease", id=1, action="take")
        await talk.hear("accepted")
        assert (await editor.save({"removed": ["bed"]}))[1]["error"] == "Bob has control"
        assert (await editor.save({"removed": ["bed"]}, tab=OTHER))[1]["by"] == "Bob"
        assert (await talk.hear("events"))["events"]
    assert editor.versions.newest().edits == Edits(removed=("bed",))


async def test_who_was_overtaken_is_409_and_nothing_is_overwritten(editor: Editor) -> None:
    answers = await asyncio.gather(
        *(editor.save({"removed": [name]}) for name in ("bed", "tv", "desk"))
    )
    assert sorted(status for status, _ in answers) == [200, 409, 409]
    assert "was saved by Ada in between" in next(
        answer["error"] for status, answer in answers if status == 409
    )
    assert (await editor.post({"based_on": 0, "tab": TAB}, "/edits/undo"))[0] == 409
    assert editor.versions.newest().number == 1


async def test_a_damaged_version_is_told(editor: Editor) -> None:
    await editor.save({"removed": ["bed"]})
    (editor.versions.folder / "0001.json").write_text("{")
    status, view = await editor.get()
    assert (status, view["version"]) == (200, 0) and "0001.json" in view["words"]


async def test_edits_that_are_in_force_need_no_words(editor: Editor, tmp_path: Path) -> None:
    edits = Edits(zones=(NoFlyZone(rectangle=(5.0, 3.0, 6.0, 4.0), reason="wet floor"),))
    versions = EditVersions(tmp_path / "others")
    versions.save(edits, 0)
    assert EditService(bsen, Site(edits=edits), versions).view().words == ""
    assert EditService(bsen, Site(), versions).view().words.startswith("The drone keeps the map")


@pytest.mark.parametrize("site", [changed(Site(), hub__edits=False), changed(Site(), mode="paper")])
async def test_where_nothing_can_be_edited_it_says_why(
    serving: Any, loopback: str, tmp_path: Path, site: Site
) -> None:
    async with serving(loopback, edits=EditService(bsen, site, EditVersions(tmp_path))) as console:
        there = Editor(console, await console.session(), EditVersions(tmp_path))
        status, answer = await there.get()
        assert status == 404 and ("hub.edits" in answer["error"] or "mode paper" in answer["error"])
