"""Fuzz target: the page of ``housefly new``, a draft that a browser changes."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Iterable
from functools import cache
from hashlib import blake2b
from pathlib import Path

from drafts import whole_draft
from fuzz_asgi import HOST, SECRET, TOKEN, http_status
from fuzz_target import DEEP, HUGE, FuzzTarget, scratch

from housefly.messages.words import UNSAID, Words
from housefly.room.draft.codec import draft_to_json
from housefly.room.draft.files import save_draft
from housefly.room.draft.model import DraftDrone, DraftTracking
from housefly.tracking.live_check import Heard, HeardBody
from housefly.web.access.session_auth import SessionAuth
from housefly.web.new_site.draft_answers import OpenedState, OpenedView
from housefly.web.new_site.draft_api import DraftApi
from housefly.web.new_site.draft_service import DraftService
from housefly.web.new_site.server import create_new_site_app
from housefly.web.new_site.uploads import Uploads

_SVG = (
    b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 400" width="6m" height="4m">'
    b'<rect x="0" y="0" width="600" height="400"/><line x1="100" y1="100" x2="300" y2="100"/></svg>'
)
_PLY = (
    b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    b"property float z\nend_header\n0 0 0\n4 0 0\n4 3 2\n"
)
_DXF = (
    b"0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nwalls\n10\n0\n20\n0\n11\n6\n21\n0\n"
    b"0\nLINE\n8\nwalls\n10\n6\n20\n0\n11\n6\n21\n4\n0\nENDSEC\n0\nEOF\n"
)


@cache
def _loop() -> asyncio.AbstractEventLoop:
    return asyncio.new_event_loop()


def _hear(tracking: DraftTracking, seconds: float) -> Heard:
    body = HeardBody(tracking.body, (1.5, 2.5, 0.05), 0.0, 100.0, 0.001)
    return Heard(tracking.address, 100.0, (body,), UNSAID)


def _check_drone(drone: DraftDrone) -> tuple[Words, ...]:
    return (Words("no report came from {name}", name=drone.address),)


class _NoRoom:
    """Starts nothing."""

    def open(self, site: Path) -> None:
        assert site.is_file()

    def view(self) -> OpenedView:
        return OpenedView(OpenedState.CLOSED)


def _new_page(data: bytes) -> None:
    """Requests after one another, a record separator between them, to a page of a whole draft."""
    folder, files = scratch() / "lab", scratch() / "uploads"
    for place in (folder, files):
        place.mkdir(exist_ok=True)
        for path in place.iterdir():
            path.unlink()
    save_draft(whole_draft(), folder)
    auth, room = SessionAuth(TOKEN, SECRET), _NoRoom()
    api = DraftApi(DraftService(folder), Uploads(files), auth, _hear, _check_drone, room)
    app = create_new_site_app(api, SessionAuth(TOKEN, SECRET))
    try:
        for request in data.split(b"\x1e")[:3]:
            assert http_status(app, _loop(), request) != 500
    finally:
        api.close()


def _post(path: str, **body: object) -> bytes:
    return f"POST {path}\n\n{json.dumps({'based_on': _version(), **body})}".encode()


@cache
def _version() -> str:
    return blake2b(draft_to_json(whole_draft()).encode(), digest_size=12).hexdigest()


def _seeds() -> Iterable[bytes]:
    for path in ("/", "/?token=a", "/draft", "/static/new.js"):
        yield f"GET {path}\nhost: {HOST}\n\n".encode()
    draft = {"name": "lab", "bounds": [0, 0, 5, 4], "pad": [1, 1], "drone": {}}
    tracking = {"kind": "vicon", "address": "10.0.0.1"}
    kept = _post("/draft", draft={**draft, "tracking": tracking, "hardware": True})
    yield kept
    yield kept + b"\x1e" + _post("/draft/undo") + b"\x1eGET /draft\n\n"
    yield _post("/draft/size", length=5.5, width=4, height=2.5)
    yield _post("/draft/erase", rectangle=[0, 0, 1, 1])
    for path in ("/draft/pad", "/draft/places", "/tracking/heard", "/drone/heard", "/site"):
        yield _post(path)
    for name, content in (("plan.svg", _SVG), ("scan.ply", _PLY), ("plan.dxf", _DXF)):
        put = f"PUT /files/{name}\n\n".encode() + content
        yield put + b"\x1e" + _post("/draft/import", file=name, unit=1.0, up="z")
    yield _post("/draft/import", file="..", layers=["a"])
    yield _post("/draft", draft={**draft, "bounds": [-1000, -1000, 1000, 1000]})
    yield b"PUT /files/..%2fa\n\na"
    yield b"POST /draft/size\n\n" + b'{"based_on": "", "length": ' + HUGE + b"}"
    yield b"POST /draft\n\n" + DEEP
    yield b"POST /draft\norigin: http://evil\n\n{}"


NEW_PAGE: dict[str, FuzzTarget] = {
    "new_page": FuzzTarget(
        _new_page, _seeds, (), 1536, (b"\x1e", b"POST /draft", b'"based_on"', b'"draft"', b"1e999")
    ),
}
