"""What is started anew, what is not, and that whoever refuses leaves everything as it is."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import psutil
import pytest

from housefly.app.launcher import Landing, Launcher, ProcessSpec
from housefly.app.new_runtime import new_runtime
from housefly.app.room_renewal import RoomRenewal
from housefly.app.runtime import Runtime
from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.config.edits import Edits, NoFlyZone
from housefly.config.state import edits_folder
from housefly.room.edit_versions import EditVersions
from housefly.sites.loaded_site import read_site

TOPICS = DroneTopics()

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]

STEADY = """
import os, signal, sys, time
signal.signal(signal.SIGTERM, lambda *_: (print("told to end", flush=True), sys.exit(0)))
print("ready", os.environ.get("HOUSEFLY_SITE", ""), flush=True)
time.sleep(100)
"""
ZONE = NoFlyZone(rectangle=(5.0, 3.0, 6.0, 4.0), reason="wet floor")


class Run:
    """Steady processes instead of a house, with a real launcher, and a pilot that gives its word.

    Attributes:
        word: what the pilot says when it is asked to stand down.
    """

    def __init__(self, folder: Path, runtime: Runtime) -> None:
        self.folder, self.runtime, self.word = folder, runtime, ""
        self.bus = LocalBus()
        self.bus.answer(TOPICS.stand_down, lambda _: self.word)
        parts = (
            ProcessSpec("pilot", "steady", lands=Landing.FIRST),
            ProcessSpec("driver", "steady", lands=Landing.LAST),
            ProcessSpec("hub", "steady"),
            ProcessSpec("web", "steady"),
        )
        self.launcher = Launcher(runtime, folder, parts)

    def renewal(self, **more: Any) -> RoomRenewal:
        return RoomRenewal(self.launcher, self.bus, is_recorded=False, **more)

    def pids(self) -> dict[str, int]:
        return {name: self.launcher.pid(name) for name in ("pilot", "driver", "hub", "web")}

    def site(self) -> str:
        return self.runtime.site_file.read_text()


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    (tmp_path / "steady.py").write_text(STEADY)
    path = os.pathsep.join(filter(None, (str(tmp_path), os.environ.get("PYTHONPATH"))))
    monkeypatch.setenv("PYTHONPATH", path)
    site = read_site("bsen", hub__store=str(tmp_path / "room.db"))
    run = Run(tmp_path, new_runtime(site, tmp_path))
    EditVersions(edits_folder(site)).save(Edits(zones=(ZONE,)), 0)
    return run


def wait_for(condition: Callable[[], object], timeout: float = 30.0) -> None:
    deadline = time.monotonic() + timeout
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.02)


def ready(run: Run) -> None:
    for name in run.pids():
        wait_for(lambda name=name: "ready" in (run.folder / f"{name}.log").read_text())


def test_who_reads_the_room_is_ended_in_order_and_started_anew_and_the_others_live_on(
    run: Run,
) -> None:
    with run.launcher:
        ready(run)
        before = run.pids()
        assert run.renewal().answer("1") == ""
        assert run.renewal().answer("1") == "that is being done already"
        wait_for(lambda: not run.launcher.is_renewing)
        now = run.pids()
        assert {name for name in now if now[name] != before[name]} == {"pilot", "hub"}
        assert all(psutil.pid_exists(pid) for pid in now.values())
        assert "told to end" in (run.folder / "hub.log").read_text(), "it closes what it has open"
        assert "wet floor" in run.site() and run.launcher.deaths == ()


@pytest.mark.parametrize("word", ["the drone is about to fly", "the pilot does not answer"])
def test_without_the_pilots_word_nothing_is_ended_and_the_old_edits_stay(
    run: Run, word: str
) -> None:
    run.word = word
    with run.launcher:
        ready(run)
        before = run.pids(), run.site()
        assert run.renewal().answer("1") == word
        time.sleep(1.0)
        assert (run.pids(), run.site()) == before and not run.launcher.is_renewing
        assert not list(run.folder.glob("*.next"))


def test_a_word_that_has_grown_too_old_is_not_relied_on(run: Run) -> None:
    with run.launcher:
        ready(run)
        before = run.pids(), run.site()
        seconds = iter(range(0, 1000, 10))
        assert run.renewal(clock=lambda: float(next(seconds))).answer("1") == ""
        wait_for(lambda: not run.launcher.is_renewing)
        assert (run.pids(), run.site()) == before


@pytest.mark.parametrize("what", ["room", "version", "newer", "recorded", "rubbish"])
def test_what_is_broken_or_old_on_the_disk_leaves_the_old_pilot(run: Run, what: str) -> None:
    site = run.runtime.site()
    versions = EditVersions(edits_folder(site))
    asked, recorded = "1", what == "recorded"
    if what == "room":
        run.runtime.site_file.write_text(
            site.model_copy(
                update={"room": site.room.model_copy(update={"model": broken_room(run.folder)})}
            ).model_dump_json()
        )
    elif what == "version":
        (versions.folder / "0001.json").write_text("{")
    elif what == "newer":
        versions.save(Edits(), 1)
    elif what == "rubbish":
        asked = "one"
    with run.launcher:
        ready(run)
        before = run.pids(), run.site()
        renewal = RoomRenewal(run.launcher, run.bus, is_recorded=recorded)
        assert renewal.answer(asked) != ""
        time.sleep(1.0)
        assert (run.pids(), run.site()) == before


def broken_room(folder: Path) -> str:
    room = folder / "broken"
    room.mkdir()
    (room / "room.toml").write_text("[[")
    return str(room)
