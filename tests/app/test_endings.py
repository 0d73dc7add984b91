"""Every way to end a flying run lands the drone: real processes and signals, scored on the truth.

The room is outside of the run, so that it outlives whatever is done to the run.
"""

from __future__ import annotations

import os
import pty
import re
import select
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import psutil
import pytest
from outside_room import OutsideRoom, Run, running_outside, wait_for

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow, pytest.mark.timeout(240)]

_LANDING = 90.0
_DRIVER, _PILOT = "housefly.app.driver_main", "housefly.app.pilot_main"
_TWIN = "housefly.twin.process"


def assert_landed_and_gone(room: OutsideRoom, run: Run) -> None:
    """The drone stands, was never left to its own watchdog, and no process is left."""
    with suppress(AssertionError):
        wait_for(lambda: run.process.poll() is not None and not run.current_parts(), _LANDING, "")
    left = [part.name() + str(part.cmdline()[-3:]) for part in run.current_parts()]
    assert run.process.poll() is not None and not left, f"after {_LANDING:.0f} s there is {left}"
    assert room.is_standing(), f"{room.height:.2f} m above the floor"
    assert not room.was_left_alone
    assert room.world.truth().contacts == 0


def assert_for_this_user_alone(run: Run, store: Path) -> None:
    """What the run wrote so far, over real wires, nobody else may read: sockets, logs, memory."""
    hub = run.part("housefly.hub.process").cmdline()
    logs = Path(hub[hub.index("--site") + 1]).parent
    sockets = Path(hub[hub.index("--socket") + 1]).parent
    kept = list(store.parent.glob(f"{store.stem}*"))
    assert {"site.json", "web.log", "pilot.log", "hub.log"} <= {
        path.name for path in logs.iterdir()
    }
    assert {"bus", "room"} <= {path.name for path in sockets.iterdir()} and store in kept
    written = [path for folder in (logs, sockets, *kept) for path in (folder, *folder.rglob("*"))]
    is_open = [path for path in written if path.exists() and path.lstat().st_mode & 0o077]
    assert is_open == []


def signal_all(run: Run, number: int) -> None:
    for part in run.current_parts():
        with suppress(psutil.NoSuchProcess):
            part.send_signal(number)
    with suppress(ProcessLookupError):
        os.kill(run.process.pid, number)


class Terminal:
    """A terminal window in which a run is started; ``hang_up`` closes it."""

    def __init__(self, log: Path) -> None:
        self._master, self._slave = pty.openpty()
        self._log = log.open("wb")
        self._is_open = True
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    @property
    def popen(self) -> dict[str, Any]:
        def take_terminal() -> None:
            import fcntl
            import termios

            os.setsid()
            signal.signal(signal.SIGHUP, signal.SIG_DFL)  # who runs the tests may ignore it
            fcntl.ioctl(0, termios.TIOCSCTTY, 0)

        ends = {"stdin": self._slave, "stdout": self._slave, "stderr": self._slave}
        return {**ends, "preexec_fn": take_terminal}

    def type(self, keys: bytes) -> None:
        os.write(self._master, keys)

    def hang_up(self) -> None:
        self._is_open = False
        self._reader.join()  # a pending read would keep the terminal open
        os.close(self._slave)
        os.close(self._master)

    def _read(self) -> None:
        while self._is_open:
            if select.select([self._master], [], [], 0.1)[0]:
                self._log.write(os.read(self._master, 4096))
                self._log.flush()


def test_a_killed_launcher_leaves_a_drone_that_lands_and_no_process(
    tmp_path: Path, write_site: Any
) -> None:
    assert os.umask(0o022) == 0o022, "the run must not owe its modes to whoever starts it"
    with running_outside(write_site(), tmp_path / "log") as (room, run):
        run.fly_off(room)
        assert_for_this_user_alone(run, tmp_path / "room1.db")
        run.process.kill()
        assert_landed_and_gone(room, run)


@pytest.mark.interop
def test_a_closed_terminal_lands_first(tmp_path: Path, write_site: Any) -> None:
    terminal = Terminal(tmp_path / "log")
    with running_outside(write_site(), tmp_path / "log", **terminal.popen) as (room, run):
        run.fly_off(room)
        terminal.hang_up()
        assert_landed_and_gone(room, run)


def test_a_second_typed_ctrl_c_does_not_wait_and_the_drone_is_landed_all_the_same(
    tmp_path: Path, write_site: Any
) -> None:
    terminal = Terminal(tmp_path / "log")
    with running_outside(write_site(), tmp_path / "log", **terminal.popen) as (room, run):
        run.fly_off(room)
        terminal.type(b"\x03")
        time.sleep(1.0)
        assert run.process.poll() is None, "it did not wait after the first"
        terminal.type(b"\x03")
        wait_for(lambda: run.process.poll() is not None, 10.0, "the launcher's end")
        assert not room.is_standing()
        assert_landed_and_gone(room, run)
        words = re.sub(r"\s+", " ", (tmp_path / "log").read_text())
        assert "lands the drone and ends when it is down" in words
    terminal.hang_up()


@pytest.mark.interop
def test_signals_to_everybody_twice_after_the_pilot_was_killed_land_the_drone(
    tmp_path: Path, write_site: Any
) -> None:
    with running_outside(write_site(), tmp_path / "log") as (room, run):
        run.fly_off(room)
        run.part("pilot_main").kill()
        wait_for(lambda: "pilot died" in run.log.read_text(), 30.0, "a new pilot")
        signal_all(run, signal.SIGTERM)
        time.sleep(0.2)
        signal_all(run, signal.SIGTERM)
        assert_landed_and_gone(room, run)


def _twice(number: int) -> Callable[[Run], None]:
    def send(run: Run) -> None:
        run.process.send_signal(number)
        time.sleep(0.05)
        run.process.send_signal(number)
        time.sleep(0.7)
        with suppress(ProcessLookupError):
            os.kill(run.process.pid, number)

    return send


def _everybody(number: int) -> Callable[[Run], None]:
    def send(run: Run) -> None:
        for _ in range(3):
            signal_all(run, number)
            time.sleep(0.2)

    return send


def _hung_pilot(run: Run) -> None:
    run.part("pilot_main").suspend()
    run.process.kill()


def _hung_pilot_and_ctrl_c(run: Run) -> None:
    run.part("pilot_main").suspend()
    run.process.send_signal(signal.SIGINT)


def _restarted_pilot(delay: float) -> Callable[[Run], None]:
    def send(run: Run) -> None:
        run.part("pilot_main").kill()
        time.sleep(delay)
        run.process.send_signal(signal.SIGINT)

    return send


_ENDINGS: dict[str, Callable[[Run], None]] = {
    "SIGTERM, three times": _twice(signal.SIGTERM),
    "SIGHUP, three times": _twice(signal.SIGHUP),
    "SIGINT, three times, not typed": _twice(signal.SIGINT),
    "SIGTERM to everybody": _everybody(signal.SIGTERM),
    "SIGINT to everybody": _everybody(signal.SIGINT),
    "SIGHUP to everybody": _everybody(signal.SIGHUP),
    "Ctrl-C as the pilot dies": _restarted_pilot(0.0),
    "Ctrl-C as a new pilot starts": _restarted_pilot(1.0),
    "Ctrl-C after a new pilot started": _restarted_pilot(4.0),
    "the launcher killed, the pilot hung": _hung_pilot,
    "Ctrl-C while the pilot hangs": _hung_pilot_and_ctrl_c,
}


@pytest.mark.safety
@pytest.mark.parametrize("ending", _ENDINGS)
def test_every_ending_lands_first(tmp_path: Path, write_site: Any, ending: str) -> None:
    with running_outside(write_site(), tmp_path / "log") as (room, run):
        run.fly_off(room)
        _ENDINGS[ending](run)
        assert_landed_and_gone(room, run)


@pytest.mark.safety
@pytest.mark.parametrize("delay", [0.3, 1.0, 2.0, 3.0])
def test_a_launcher_killed_during_take_off_leaves_no_drone_in_the_air(
    tmp_path: Path, write_site: Any, delay: float
) -> None:
    with running_outside(write_site(), tmp_path / "log") as (room, run):
        run.order_take_off()
        time.sleep(delay)
        run.process.kill()
        assert_landed_and_gone(room, run)


@pytest.mark.interop
def test_the_simulated_room_of_a_killed_run_stays_until_the_drone_is_down(
    tmp_path: Path, write_site: Any
) -> None:
    """Not flown: that the room waits for those who land is the same on the ground."""
    log = (tmp_path / "log").open("wb")
    command = [*("-m", "housefly.cli", "run", "--site"), str(write_site())]
    process = subprocess.Popen([sys.executable, *command], stdout=log, stderr=subprocess.STDOUT)
    parts: list[psutil.Process] = []
    try:
        log_file = tmp_path / "log"
        wait_for(lambda: "ready after" in log_file.read_text(), 150.0, "a run that is ready")
        parts = psutil.Process(process.pid).children(recursive=True)
        named = {part.cmdline()[7]: part for part in parts if len(part.cmdline()) > 7}
        named[_DRIVER].suspend()
        process.kill()
        process.wait()
        # Whether the system wakes the driver now depends on who takes the orphans over.
        _watch_who_lives(named, 1.0, lambda _: False)
        with suppress(psutil.NoSuchProcess):
            named[_DRIVER].resume()
        left = _watch_who_lives(named, _LANDING, lambda living: not living)
        assert not left, f"still alive after {_LANDING:.0f} s: {', '.join(sorted(left))}"
    finally:
        process.terminate()
        process.wait(_LANDING)
        for part in parts:
            with suppress(psutil.NoSuchProcess):
                part.kill()


def _watch_who_lives(
    named: dict[str, psutil.Process], seconds: float, until: Callable[[set[str]], bool]
) -> set[str]:
    """Return who lives in the end; the room must not be gone before those who land."""
    deadline = time.monotonic() + seconds
    while True:
        # The room first: whoever is seen alive after it was seen gone has outlived it.
        room_lives = _lives(named[_TWIN])
        living = {name for name, part in named.items() if _lives(part)}
        outlived = living & {_DRIVER, _PILOT}
        assert room_lives or not outlived, f"the room is gone, still alive: {sorted(outlived)}"
        if until(living) or time.monotonic() > deadline:
            return living
        time.sleep(0.005)


def _lives(part: psutil.Process) -> bool:
    with suppress(psutil.NoSuchProcess):
        return part.is_running() and part.status() != psutil.STATUS_ZOMBIE
    return False
