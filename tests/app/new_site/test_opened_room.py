"""The room that the page of a new site opens: started once, told as it starts, landed."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from housefly.app.new_site.opened_room import OpenedRoom
from housefly.web.new_site.draft_answers import OpenedState

DEMO = """
import pathlib, signal, sys, time
log = pathlib.Path(sys.argv[sys.argv.index("--site") + 1]).with_suffix(".log")
def end(*_):
    log.write_text(log.read_text() + "landed ")
    sys.exit(0)
signal.signal(signal.SIGINT, end)
log.write_text((log.read_text() if log.exists() else "") + "began ")
print("compiling the control loop", flush=True)
time.sleep(0.3)
print("console:  http://127.0.0.1:1234/?token=abc#tasks  (works once)", flush=True)
print("ready after 0.3 s.", flush=True)
time.sleep(60)
"""


@pytest.fixture
def opened() -> Iterator[OpenedRoom]:
    room = OpenedRoom((sys.executable, "-c", DEMO))
    yield room
    room.close()


def wait_for(condition: Callable[[], bool]) -> None:
    ends = time.monotonic() + 20.0
    while not condition():
        assert time.monotonic() < ends
        time.sleep(0.02)


def test_it_is_started_once_tells_its_address_and_lands_before_it_ends(
    opened: OpenedRoom, tmp_path: Path
) -> None:
    site, log = tmp_path / "site.toml", tmp_path / "site.log"
    assert opened.view().state is OpenedState.CLOSED
    opened.open(site)
    wait_for(lambda: "compiling" in opened.view().line)
    assert opened.view().state is OpenedState.STARTING
    opened.open(site)
    wait_for(lambda: opened.view().state is OpenedState.READY)
    assert opened.view().address == "http://127.0.0.1:1234/?token=abc#tasks"
    opened.close()
    assert log.read_text() == "began landed "
    wait_for(lambda: opened.view().state is OpenedState.ENDED)
    opened.open(site)
    wait_for(lambda: log.read_text().endswith("began "))


def test_one_that_ends_says_what_it_said_last(tmp_path: Path) -> None:
    room = OpenedRoom((sys.executable, "-c", "print('the port is taken')"))
    room.open(tmp_path / "site.toml")
    wait_for(lambda: room.view().state is OpenedState.ENDED)
    assert room.view().line == "the port is taken"
    room.close()
