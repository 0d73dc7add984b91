"""Whatever stands in a site file is either flown or refused in words, and quickly."""

from __future__ import annotations

import json
import os
import random
from pathlib import Path
from typing import Any

import pytest
from nasty import VALUES, WHOLE_FILES, keys_of, tree_with

from housefly.app.ports import port_needs
from housefly.cli import main
from housefly.config.site import Site
from housefly.errors import HouseflyError
from housefly.hub.store.lock import refuse_shared_store
from housefly.sites.loaded_site import open_site, read_site

KEYS = tuple(keys_of(Site))
LONGEST_WORDS = 2000


@pytest.fixture(autouse=True)
def own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


def refused_or_read(file: Path) -> None:
    """Do what a start does before the first process; anything but our own errors passes on."""
    try:
        site = read_site(str(file))
        site.model_dump_json()
        refuse_shared_store(site)
        port_needs(site, web=True)
        open_site(site)
    except HouseflyError as error:
        assert len(str(error)) < LONGEST_WORDS, str(error)[:200]


def try_key(file: Path, key: tuple[str, ...], value: Any) -> None:
    file.write_text(json.dumps(tree_with(key, value)), encoding="utf-8")
    try:
        refused_or_read(file)
    except Exception as error:
        raise AssertionError(f"{'.'.join(key)} = {value!r:.60}") from error


def test_each_key_with_some_nasty_values(tmp_path: Path) -> None:
    draw = random.Random(10)
    for key in KEYS:
        for value in draw.sample(VALUES, 3):
            try_key(tmp_path / "site.json", key, value)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("room.model", "/dev/zero"),
        ("room.model", "x\0y"),
        ("room.model", "a" * 300),
        ("drone.address", "x\0y"),
        ("drone.profile", "/dev/zero"),
        ("drone.profile", "a/" * 3000),
        ("hub.store", "/"),
        ("hub.store", "a" * 300),
        ("hub.store", "~nobody-of-that-name/x"),
        ("mqtt.broker", "127.0.0.1\nallow_anonymous true"),
        ("twin.scene", "a" * 300),
        ("name", "\ud800"),
    ],
)
def test_what_once_gave_a_traceback(tmp_path: Path, key: str, value: str) -> None:
    try_key(tmp_path / "site.json", tuple(key.split(".")), value)


@pytest.mark.safety
@pytest.mark.timeout(900)
@pytest.mark.parametrize("value", range(len(VALUES)))
def test_each_key_with_each_nasty_value(tmp_path: Path, value: int) -> None:
    for key in KEYS:
        try_key(tmp_path / "site.json", key, VALUES[value])


@pytest.mark.parametrize("content", WHOLE_FILES)
@pytest.mark.parametrize("ending", ["toml", "json"])
def test_a_file_that_is_no_site(
    tmp_path: Path, content: bytes, ending: str, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / f"site.{ending}"
    file.write_bytes(content)
    if content == b"" and ending == "toml":
        refused_or_read(file)  # an empty site file is the shipped room
        return
    assert main(["plan", "--site", str(file), "--to", "entrance"]) == 2
    assert capsys.readouterr().err.startswith("housefly: ")


def test_a_pipe_is_no_site_and_nobody_waits_for_it(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert main(["plan", "--site", str(tmp_path / "pipe"), "--to", "entrance"]) == 2
