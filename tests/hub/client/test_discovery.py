"""Runs find each other through files that only their user can read."""

from __future__ import annotations

import json
import os
import stat
from pathlib import Path

import pytest

from housefly.errors import LinkError
from housefly.hub.client.discovery import RoomAddress, announced, find, folder, running


@pytest.fixture(autouse=True)
def _own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))


def place(site: str = "B-sen") -> RoomAddress:
    return RoomAddress(site, "http://127.0.0.1:8080", "key", os.getpid())


def test_a_run_is_found_while_it_lasts() -> None:
    with announced(place()):
        assert find() == place()
        assert find("b-SEN") == place()
    assert running() == ()


def test_nobody_else_may_read_the_key() -> None:
    with announced(place()):
        (file,) = folder().glob("*.json")
        assert stat.S_IMODE(file.stat().st_mode) == 0o600
        assert stat.S_IMODE(folder().stat().st_mode) == 0o700


def test_no_run_and_another_run_are_told_with_what_to_do() -> None:
    with pytest.raises(LinkError, match="housefly demo"):
        find()
    with announced(place()), pytest.raises(LinkError, match="running: B-sen"):
        find("elsewhere")


def test_files_of_runs_that_are_gone_and_garbage_are_removed() -> None:
    (folder() / "1.json").write_text("not JSON")
    for number, pid in enumerate((999999999, 2**40), 2):
        entry = json.dumps({"site": "a", "address": "b", "key": "c", "pid": pid})
        (folder() / f"{number}.json").write_text(entry)
    assert running() == ()
    assert list(folder().glob("*.json")) == []
