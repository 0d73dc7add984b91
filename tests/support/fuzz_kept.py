"""Fuzz targets: what the house kept for itself, and what people write beside their site."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

from drafts import whole_draft
from fuzz_target import DEEP, HUGE, FuzzTarget, as_file, scratch

from housefly.config.frame_check import frames_known, read_frame_check
from housefly.config.site import Site, changed
from housefly.errors import ConfigError, HouseflyError, RecordingError, RoomError
from housefly.lab.campaigns.spec import load_spec
from housefly.messages import Phase, SafetyMode, Severity
from housefly.room.draft.codec import draft_from_json, draft_to_json
from housefly.room.draft.files import load_draft, write_site
from housefly.web.access.users import UserBook
from housefly.web.flights.flight_book import FlightBook
from housefly.web.flights.flight_log import (
    FlightEnd,
    FlightHead,
    FlightNote,
    FlightPath,
    LoggedPose,
    LoggedStage,
    line_text,
)
from housefly.web.new_site.draft_view import fit_view, flyable, missing_views, scan_view
from housefly.web.status.console_memory import ConsoleMemory

_FLIGHT = "20251122T120000000Z"
_HASH = "$scrypt$ln=15,r=8,p=3$" + "a" * 22 + "$" + "b" * 43


def _folder(name: str) -> Path:
    """Return an empty folder of this process."""
    folder = scratch() / name
    folder.mkdir(exist_ok=True)
    for path in folder.iterdir():
        path.unlink()
    return folder


def _users(data: bytes) -> None:
    path = _folder("users") / "users.json"
    path.write_bytes(data)
    path.chmod(0o600)
    UserBook(path).find("anna")
    UserBook(path).all()


def _user_seeds() -> Iterable[bytes]:
    anna = {"name": "anna", "role": "fly", "password": _HASH}
    yield json.dumps({"users": [anna, {**anna, "name": "kim", "role": "watch"}]}).encode()
    yield b'{"users": [{"name": "anna", "role": ' + HUGE + b', "password": ""}]}'
    yield b'{"users": ' + DEEP


def _console_memory(data: bytes) -> None:
    folder = _folder("console")
    (folder / "console.jsonl").write_bytes(data)
    memory = ConsoleMemory(folder)
    memory.read(10.0)
    memory.close()


def _console_memory_seeds() -> Iterable[bytes]:
    tab = {"owner": "a", "tab": "tab-number-one", "number": 1, "name": "Kim"}
    control = {"holder": 1, "tabs": [tab], "stop_holds": True, "stop_by": "Kim"}
    event = {"at": 5.0, "severity": "info", "code": "stop", "text": "STOP"}
    yield f"{json.dumps({'event': event})}\n{json.dumps({'control': control})}\n".encode()
    yield b'{"event": {"at": ' + HUGE + b"}}\n5\nnull\n"
    yield b'{"control": ' + DEEP


def _flight_log(data: bytes) -> None:
    folder = _folder("flights")
    (folder / f"{_FLIGHT}.jsonl").write_bytes(data)
    book = FlightBook(folder)
    book.flights()
    book.replay(_FLIGHT)


def _flight_log_seeds() -> Iterable[bytes]:
    lines = (
        FlightHead(1, "B-sen", 1.7e9),
        LoggedStage(0.0, next(iter(Phase)), next(iter(SafetyMode)), "sofa"),
        LoggedPose(0.1, (1.0, 2.0, 1.1), 0.5, 0.3, 0.9),
        FlightPath(0.2, ((1.0, 2.0), (3.0, 4.0)), (1.0, 1.1), (0.0, 2.0), (0.0, 0.0)),
        FlightNote(0.3, Severity.WARNING, "wind", "a draught"),
        FlightEnd(5.0, "sofa", Severity.WARNING),
    )
    yield "".join(map(line_text, lines)).encode()
    yield line_text(lines[0]).encode() + b'{"note":{"t":' + HUGE + b"}}\n"
    yield b'{"flight":{"version":' + DEEP + b"}}\n"


def _frame_check(data: bytes) -> None:
    with as_file(data, "frames.toml"):
        store = str(scratch() / "room.db")
        site = changed(Site(), hub__store=store, twin__enabled=False)
        frames_known(site)
        read_frame_check(site)


def _frame_check_seeds() -> Iterable[bytes]:
    yield (
        b'checked_at = "2025-11-22T12:00:00+00:00"\ntracking = "aa"\nfindings = ["turned"]\n'
        b"notes = []\n[measured]\ndelay_ms = 20.5\nbodies = 2\ntrusted = true\n"
    )
    yield b'tracking = "a"\nfindings = [1, {}]\n[measured]\na = nan\nb = ' + HUGE
    yield b"tracking = " + DEEP


def _campaign(data: bytes) -> None:
    with as_file(data, "campaign.toml") as path:
        spec = load_spec(path)
    _ = spec.drones


def _campaign_seeds() -> Iterable[bytes]:
    yield (
        b'name = "wind"\nseeds = 5\nplot = ["stable"]\n[mission]\ngoal = "entrance"\n'
        b"duration_s = 40\n[fixed]\nspeed = 0.5\n[grid]\nmode = ['default', 'paper']\n"
        b"[draw.wind_x]\nuniform = [0.0, 0.5]\n[draw.estimator]\nchoice = ['on_arrival']\n"
    )
    yield (
        b'name = "b"\n[mission]\ntask = "step"\nwaypoints = [[0, 0], [1, 2]]\n[draw]\n'
        b"alpha = {normal = [3.6, 0.5]}\nbeta = {loguniform = [0.5, 3.0]}\n"
    )
    yield b'name = "a"\nseeds = ' + HUGE
    yield b'name = "a"\nmission.goal = "a"\nfixed.speed = ' + HUGE
    yield b'name = "a"\nmission.goal = "a"\ngrid.speed = ' + DEEP


def _draft(data: bytes) -> None:
    """A draft of a folder, what its page shows of it, and the files that become of it."""
    folder = _folder("draft")
    (folder / "draft.json").write_bytes(data)
    draft = load_draft(folder)
    assert draft is not None
    assert draft_from_json(draft_to_json(draft)) == draft
    views = flyable(draft), scan_view(draft), missing_views(draft), fit_view(draft)
    assert len(views) == 4
    try:
        write_site(draft, folder)
    except HouseflyError as error:
        assert len(str(error)) > 10


def _draft_seeds() -> Iterable[bytes]:
    whole = draft_to_json(whole_draft()).encode()
    yield b" ".join(whole.split())
    box = {"name": "a", "x": 1, "y": 2, "length": 1, "width": 1, "top": 1}
    point = {"name": "a", "on_map": [1, 2, 0], "seen": [2, 1, 0]}
    other = {"name": "b", "on_map": [4, 2, 0], "seen": [5, 1, 0]}
    yield json.dumps(
        {
            "name": "lab", "bounds": [0, 0, 6, 4], "pad": [1, 1], "scanned": [box],
            "furniture": [box], "zones": [{"rectangle": [1, 1, 2, 2], "reason": "mine"}],
            "tracking": {"kind": "vicon", "address": "10.0.0.1"}, "hardware": True,
            "frame_points": [point, other], "drone": {"profile": "drone.toml"},
        }
    ).encode()  # fmt: skip
    yield json.dumps({"bounds": [-1000, -1000, 1000, 1000], "height": 100, "pad": [0, 0]}).encode()
    yield b'{"bounds": [1, 1, 0, 0], "pad": [5, 5]}'
    yield b'{"height": ' + HUGE + b"}"
    yield b'{"walls": ' + DEEP


KEPT: dict[str, FuzzTarget] = {
    "users": FuzzTarget(_users, _user_seeds, (ConfigError,), 512, (b'"users"', _HASH.encode())),
    "console_memory": FuzzTarget(
        _console_memory, _console_memory_seeds, length_max=1024, words=(b'{"event"', b'{"control"')
    ),
    "flight_log": FuzzTarget(
        _flight_log, _flight_log_seeds, (RecordingError,), words=(b'"sample"', b'"note"', b'"end"')
    ),
    "frame_check": FuzzTarget(
        _frame_check, _frame_check_seeds, (ConfigError,), 1024, (b"[measured]", b"tracking =")
    ),
    "campaign_toml": FuzzTarget(
        _campaign, _campaign_seeds, (ConfigError,), words=(b"[grid]", b"[draw]", b"nan", b"1e400")
    ),
    "room_draft": FuzzTarget(
        _draft, _draft_seeds, (ConfigError, RoomError), 1536, (b'"walls"', b'"bounds"', b"1e400")
    ),
}
