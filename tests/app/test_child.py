"""When the processes of a run end: with their launcher, in order, and not for a stray signal."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import psutil
import pytest

# It starts one that lands (slowly) and one that follows, as a launcher does, and prints their ids.
LAUNCHER = """
import sys, time
from pathlib import Path
from threading import Thread
from types import SimpleNamespace
from housefly.app.launcher import Landing, Launcher, ProcessSpec
import os
runtime = SimpleNamespace(environment=lambda: dict(os.environ))
launcher = Launcher(runtime, Path(sys.argv[1]), (
    ProcessSpec("lander", "slow_lander", lands=Landing.LAST), ProcessSpec("twin", "follower")))
launcher.__enter__()
while not all((Path(sys.argv[1]) / f"{n}.log").read_text() for n in ("lander", "twin")):
    time.sleep(0.02)
print(launcher.pid("lander"), launcher.pid("twin"), flush=True)
time.sleep(100)
"""
LANDER = """
import asyncio, signal
async def main():
    leaving = asyncio.Event()
    asyncio.get_running_loop().add_signal_handler(signal.SIGTERM, leaving.set)
    print("ready", flush=True)
    await leaving.wait()
    print("landing", flush=True)
    await asyncio.sleep(1.5)
    print("down", flush=True)
asyncio.run(main())
"""
FOLLOWER = """
import asyncio, signal
async def main():
    leaving = asyncio.Event()
    asyncio.get_running_loop().add_signal_handler(signal.SIGTERM, leaving.set)
    print("ready", flush=True)
    await leaving.wait()
    print("told", flush=True)
asyncio.run(main())
"""


class Family:
    def __init__(self, folder: Path) -> None:
        self.folder = folder
        for name, code in (("slow_lander", LANDER), ("follower", FOLLOWER), ("start", LAUNCHER)):
            (folder / f"{name}.py").write_text(textwrap.dedent(code))
        path = os.pathsep.join(filter(None, (str(folder), os.environ.get("PYTHONPATH"))))
        self.launcher = subprocess.Popen(
            [sys.executable, str(folder / "start.py"), str(folder)],
            env={**os.environ, "PYTHONPATH": path},
            stdout=subprocess.PIPE,
            text=True,
        )
        assert self.launcher.stdout is not None
        lander, twin = map(int, self.launcher.stdout.readline().split())
        self.lander, self.twin = psutil.Process(lander), psutil.Process(twin)

    def log(self, name: str) -> str:
        return (self.folder / f"{name}.log").read_text()

    def wait_for_the_end(self) -> None:
        assert psutil.wait_procs([self.lander, self.twin], timeout=30)[1] == []


@pytest.fixture
def family(tmp_path: Path) -> Iterator[Family]:
    found = Family(tmp_path)
    yield found
    for process in (found.launcher, found.lander, found.twin):
        with suppress(psutil.NoSuchProcess):
            process.kill()
    found.launcher.wait()


def test_who_lands_ends_when_the_launcher_is_killed_and_the_others_after_him(
    family: Family,
) -> None:
    family.launcher.kill()
    family.launcher.wait()
    deadline = time.monotonic() + 30.0
    while "told" not in (twin := family.log("twin")) and time.monotonic() < deadline:
        time.sleep(0.02)
    assert "told" in twin
    assert family.log("lander").split() == ["ready", "landing", "down"], "it did not wait"
    family.wait_for_the_end()
    assert family.log("twin").split() == ["ready", "told"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_signals_again_and_again_are_one_wish_to_land(family: Family, number: int) -> None:
    for _ in range(4):
        with suppress(psutil.NoSuchProcess):
            family.lander.send_signal(number)
        time.sleep(0.1)
    family.launcher.kill()
    family.wait_for_the_end()
    assert family.log("lander").split() == ["ready", "landing", "down"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_stray_signal_does_not_take_the_room_away(family: Family, number: int) -> None:
    family.twin.send_signal(number)
    time.sleep(1.0)
    assert family.twin.status() != psutil.STATUS_ZOMBIE
    assert family.log("twin").split() == ["ready"]
