"""The draft over real HTTP: what is asked, kept, refused in words, and by whom."""

from __future__ import annotations

import asyncio
import json
from pathlib import Path
from typing import Any

import pytest

from housefly.room.draft.files import load_draft
from housefly.sites.loaded_site import load_site
from housefly.web.new_site.draft_actions import ACTIONS
from housefly.web.new_site.draft_api import DRAFT_SIZE_MAX

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]

TABLE = {"name": "table", "x": 2.0, "y": 2.0, "length": 1.6, "width": 0.8, "top": 0.75}


async def sized(drawer: Any, length: float = 8.0, width: float = 5.0) -> Any:
    status, view = await drawer.post("/draft/size", length=length, width=width, height=2.5)
    assert status == 200, view
    return view


async def test_from_nothing_to_a_site_that_loads(drawer: Any) -> None:
    status, view = await drawer.get()
    assert status == 200 and view["missing"][0]["step"] == "room"
    view = await sized(drawer)
    assert view["draft"]["bounds"] == [0.0, 0.0, 8.0, 5.0] and len(view["draft"]["walls"]) == 4
    status, view = await drawer.post(
        "/draft", draft={**view["draft"], "pad": [1.0, 1.0], "furniture": [TABLE]}
    )
    assert status == 200 and [one["step"] for one in view["missing"]] == ["places"]
    status, refused = await drawer.post("/site")
    assert status == 422 and "no place to fly to" in refused["error"]
    status, view = await drawer.post("/draft/places")
    assert status == 200 and view["missing"] == []
    status, written = await drawer.post("/site")
    assert status == 200
    assert [Path(one["path"]).name for one in written["files"]] == ["room.toml", "site.toml"]
    loaded = load_site(drawer.folder)
    assert loaded.room.home == (1.0, 1.0) and loaded.grid.is_free(loaded.grid.cell_of((1.0, 1.0)))


async def test_every_change_is_on_disk_before_it_is_answered(drawer: Any) -> None:
    view = await sized(drawer)
    await drawer.post("/draft", draft={**view["draft"], "furniture": [TABLE]})
    kept = load_draft(drawer.folder)
    assert kept is not None and [box.name for box in kept.furniture] == ["table"]


async def test_undo_and_redo_go_over_every_kind_of_change(drawer: Any) -> None:
    view = await sized(drawer)
    await drawer.post("/draft", draft={**view["draft"], "furniture": [TABLE]})
    await drawer.post("/draft/pad")
    _, view = await drawer.post("/draft/undo")
    assert view["draft"]["pad"] is None and len(view["draft"]["furniture"]) == 1
    _, view = await drawer.post("/draft/undo")
    assert view["draft"]["furniture"] == [] and view["redoable"]
    _, view = await drawer.post("/draft/undo")
    assert view["draft"]["bounds"] is None and not view["undoable"]
    for _ in range(3):
        _, view = await drawer.post("/draft/redo")
    assert view["draft"]["pad"] is not None and not view["redoable"]


async def test_letters_of_one_field_are_undone_as_one(drawer: Any) -> None:
    view = await sized(drawer)
    for merges, name in ((False, "m"), (True, "my"), (True, "my l")):
        status, _ = await drawer.post(
            "/draft", draft={**view["draft"], "name": name}, merges=merges
        )
        assert status == 200
    _, view = await drawer.post("/draft/undo")
    assert view["draft"]["name"] == "mylab"


REFUSED: list[tuple[str, dict[str, Any], str, str]] = [
    ("/draft/size", {"length": 0.2, "width": 5, "height": 2.5}, "length", "1 to 200 m"),
    ("/draft/size", {"length": 8, "width": 5, "height": 900}, "height", "1.5 to 100 m"),
    ("/draft/size", {"length": "x", "width": 5, "height": 2}, "length", "number"),
    ("/draft", {"draft": {"furniture": [{**TABLE, "length": -1}]}}, "furniture.0.length", "0"),
    ("/draft", {"draft": {"pad_yaw": 7}}, "pad_yaw", "6.3"),
    ("/draft", {"draft": {"pad": [1e9, 0]}}, "pad.0", "1000"),
    ("/draft", {"draft": {"sofa": 1}}, "sofa", ""),
    ("/draft", {}, "draft", ""),
    ("/draft/erase", {"rectangle": [1, 2, 3]}, "rectangle.3", ""),
    ("/draft/import", {"file": "room.ply", "unit": -1}, "unit", "0"),
    ("/draft/import", {"file": "room.ply"}, "", "did not arrive"),
    ("/draft/import", {"file": "../../etc/passwd"}, "", "letter or digit first"),
    ("/draft/pad", {}, "bounds", "no size yet"),
    ("/draft/pad", {"based_on": 5}, "based_on", "string"),
    ("/tracking/heard", {}, "tracking", "which system"),
    ("/drone/heard", {}, "drone", "where the drone answers"),
    ("/site", {}, "room", "no size yet"),
]
"""Path, body, the key that is wrong, and what the words must hold."""


async def test_what_is_not_allowed_is_refused_in_words_with_its_key(drawer: Any) -> None:
    before = drawer.version
    for path, body, key, words in REFUSED:
        status, refused = await drawer.post(path, **body)
        assert (status, refused["key"]) == (422, key), (path, body, refused)
        assert words in refused["error"] and key in refused["error"]
    assert (await drawer.get())[1]["version"] == before


async def test_who_draws_in_an_old_tab_is_told_and_changes_nothing(drawer: Any) -> None:
    old = drawer.version
    view = await sized(drawer)
    status, refused = await drawer.post("/draft", based_on=old, draft={"name": "lost"})
    assert status == 409 and "changed elsewhere" in refused["error"]
    assert (await drawer.get())[1]["draft"] == view["draft"]


async def test_a_plan_is_brought_as_a_file_and_read(drawer: Any) -> None:
    lines = "".join(
        f'<line x1="{a}" y1="{b}" x2="{c}" y2="{d}" stroke="black"/>'
        for a, b, c, d in ((0, 0, 600, 0), (600, 0, 600, 400), (600, 400, 0, 400), (0, 400, 0, 0))
    )
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 400">{lines}</svg>'
    status, kept = await drawer.put("/files/plan.svg", svg.encode())
    assert (status, kept["bytes"]) == (200, len(svg))
    status, view = await drawer.post("/draft/import", file="plan.svg", unit=0.01)
    assert status == 200, view
    x0, y0, x1, y1 = view["draft"]["bounds"]
    assert x1 - x0 == pytest.approx(6.0, abs=0.3) and y1 - y0 == pytest.approx(4.0, abs=0.3)
    assert view["notes"] and view["draft"]["source"] == "plan.svg"
    assert view["draft"]["name"] == "mylab"


@pytest.mark.parametrize("name", ["..%2Fdraft.json", ".hidden.svg", "a%00b.svg", "a" * 120])
async def test_a_file_with_an_odd_name_is_not_kept(drawer: Any, name: str) -> None:
    status, _, _ = await drawer.request("PUT", f"/files/{name}", b"x")
    assert status in (404, 422)


async def test_scanned_boxes_stay_when_the_page_sends_what_was_drawn(drawer: Any) -> None:
    drawer.folder.mkdir(exist_ok=True)
    await sized(drawer)
    path = drawer.folder / "draft.json"
    tree = json.loads(path.read_text())
    box = {"length": 0.1, "width": 0.1, "top": 2.0, "thing": "wall"}
    tree["scanned"] = [{"name": f"s{n}", "x": 2.0 + n, "y": 2.0, **box} for n in range(3)]
    path.write_text(json.dumps(tree))
    _, view = await drawer.get()
    assert view["scanned"] == 3 and view["draft"]["scanned"] == [] and view["scan"] is not None
    _, view = await drawer.post("/draft", draft={**view["draft"], "name": "scan"})
    assert view["scanned"] == 3
    _, view = await drawer.post("/draft/erase", rectangle=[2.5, 0.0, 8.0, 5.0])
    assert view["scanned"] == 1
    _, view = await drawer.post("/draft/undo")
    assert view["scanned"] == 3


async def test_tracking_and_drone_are_asked_from_the_page(drawer: Any) -> None:
    tracking = {"kind": "vicon", "address": "10.0.0.5", "body": "fly"}
    await drawer.post(
        "/draft",
        draft={"tracking": tracking, "drone": {"address": "192.168.1.1"}, "hardware": True},
    )
    status, heard = await drawer.post("/tracking/heard")
    assert status == 200 and heard["bodies"] == [{"name": "fly", "position": [1.5, 2.5, 0.05]}]
    status, heard = await drawer.post("/drone/heard")
    assert status == 200 and heard["words"] == [["no report came from {name}", "192.168.1.1"]]


FORGED: tuple[dict[str, str], ...] = (
    {"Origin": "http://evil.example"},
    {"Origin": ""},
    {"X_Housefly_Proof": ""},
    {"Cookie": ""},
)


async def test_nobody_but_the_page_may_ask(drawer: Any) -> None:
    before = drawer.version
    body = json.dumps({"based_on": before, "draft": {"name": "stolen"}}).encode()
    for path in (*ACTIONS, "/tracking/heard", "/drone/heard", "/site"):
        for headers in FORGED:
            status, _, text = await drawer.request("POST", path, body, **headers)
            assert status == 403, (path, headers, text)
    assert (await drawer.get())[1]["version"] == before


async def test_a_stranger_sees_neither_page_nor_draft(page_of_nothing: Any) -> None:
    status, _, text = await page_of_nothing.request("GET", "/draft")
    assert status == 401 and "walls" not in text
    status, _, text = await page_of_nothing.request("GET", "/")
    assert status == 403 and "housefly new" in text
    status, _, _ = await page_of_nothing.request("PUT", "/files/a.svg", b"x")
    assert status == 403


async def test_the_link_is_good_once_and_other_hosts_are_turned_away(drawer: Any) -> None:
    cookie, drawer.cookie = drawer.cookie, ""
    status, headers, _ = await drawer.request("GET", "/?token=a-token-for-tests-only")
    assert status == 303 and "set-cookie" not in headers
    drawer.cookie = cookie
    status, headers, text = await drawer.request("GET", "/")
    assert status == 200 and "/static/new.js" in text
    assert "frame-ancestors 'none'" in headers["content-security-policy"]
    status, _, _ = await drawer.request("GET", "/", Host="evil.example")
    assert status == 421


async def test_a_request_without_end_is_cut(drawer: Any) -> None:
    status, _, text = await drawer.request("POST", "/draft", b" " * (DRAFT_SIZE_MAX + 1))
    assert status == 413 and "MiB" in text


async def test_a_file_whose_browser_left_is_not_read_as_a_whole_one(drawer: Any) -> None:
    lines = (
        f"PUT /files/plan.svg HTTP/1.1\r\nHost: {drawer.host}:{drawer.port}\r\n"
        f"Cookie: {drawer.cookie}\r\nOrigin: {drawer.origin}\r\n"
        f"X-Housefly-Proof: {drawer.proof}\r\nContent-Length: 1000\r\n\r\n<svg>"
    )
    _, writer = await asyncio.open_connection(drawer.host, drawer.port)
    writer.write(lines.encode())
    await writer.drain()
    await asyncio.sleep(0.2)
    writer.close()
    await writer.wait_closed()
    await asyncio.sleep(0.2)
    status, refused = await drawer.post("/draft/import", file="plan.svg")
    assert status == 422 and "did not arrive" in refused["error"]


async def test_a_file_that_holds_what_no_draft_may_is_refused_and_the_page_lives_on(
    drawer: Any,
) -> None:
    svg = '<svg xmlns="http://www.w3.org/2000/svg"><rect width="6" height="4"/></svg>'
    await drawer.put("/files/plan.svg", svg.encode())
    status, refused = await drawer.post("/draft/import", file="plan.svg", unit=300.0)
    assert status == 422 and "unit" in refused["error"]
    assert (await drawer.get())[0] == 200
