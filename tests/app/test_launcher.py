"""How a run ends: in order, at once, or because its launcher is gone."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import psutil
import pytest

pytestmark = [pytest.mark.wire, pytest.mark.slow]


def start(site: Path, log: Path) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "housefly.cli", "run", "--site", str(site)]
    process = subprocess.Popen(command, stdout=log.open("w"), stderr=subprocess.STDOUT)
    deadline = time.monotonic() + 60.0
    while "ready after" not in log.read_text():
        assert time.monotonic() < deadline, log.read_text()
        time.sleep(0.1)
    return process


def children_of(process: subprocess.Popen[bytes]) -> list[psutil.Process]:
    return psutil.Process(process.pid).children(recursive=True)


def test_ctrl_c_ends_every_process_and_gives_exit_code_0(tmp_path: Path, write_site: Any) -> None:
    process = start(write_site(), tmp_path / "log")
    children = children_of(process)
    assert len(children) >= 3
    process.send_signal(signal.SIGINT)
    assert process.wait(40) == 0
    assert psutil.wait_procs(children, timeout=5)[1] == []


def test_no_process_outlives_a_launcher_that_was_killed(tmp_path: Path, write_site: Any) -> None:
    process = start(write_site(), tmp_path / "log")
    children = children_of(process)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    assert psutil.wait_procs(children, timeout=30)[1] == []


def test_a_killed_part_is_started_again_and_said(tmp_path: Path, write_site: Any) -> None:
    process = start(write_site(), tmp_path / "log")
    try:
        twin = next(
            child
            for child in children_of(process)
            if "housefly.twin.process" in " ".join(child.cmdline())
        )
        twin.kill()
        deadline = time.monotonic() + 20.0
        while "twin died and was started again" not in (tmp_path / "log").read_text():
            assert time.monotonic() < deadline
            time.sleep(0.1)
    finally:
        process.send_signal(signal.SIGINT)
        assert process.wait(40) == 0
