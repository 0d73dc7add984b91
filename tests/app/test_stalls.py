"""The simulated room stands still for moments, as a link or a busy machine does."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from housefly.record.replay import read_steps
from housefly.record.truth import read_truth

pytestmark = [
    pytest.mark.wire,
    pytest.mark.realtime,
    pytest.mark.interop,
    pytest.mark.timeout(240),
]

STALL, STALLS, EVERY = 0.22, 8, 0.7
"""So long and so often it stands still, from 1 s after take-off on [s]."""


def twin_of(launcher: int) -> int:
    """Return the process of the simulated room that a run started."""
    children = Path(f"/proc/{launcher}/task/{launcher}/children").read_text().split()
    words = {int(pid): Path(f"/proc/{pid}/cmdline").read_text() for pid in children}
    return next(pid for pid, command in words.items() if "twin" in command)


def test_a_room_that_stands_still_for_moments_is_no_tracking_that_drifts(tmp_path: Path) -> None:
    out = tmp_path / "flight"
    command = [sys.executable, "-m", "housefly.cli", "fly", "tv", "--headless", "--out", str(out)]
    log = tmp_path / "flight.log"
    with log.open("w") as file:
        flight = subprocess.Popen(command, stdout=file, stderr=subprocess.STDOUT)
    deadline = time.monotonic() + 100.0
    while "in the air" not in log.read_text():
        assert time.monotonic() < deadline and flight.poll() is None, log.read_text()
        time.sleep(0.05)
    twin = twin_of(flight.pid)
    time.sleep(1.0)
    for _ in range(STALLS):
        os.kill(twin, signal.SIGSTOP)
        time.sleep(STALL)
        os.kill(twin, signal.SIGCONT)
        time.sleep(EVERY - STALL)
    flight.wait(120.0)
    told = {event.code for step in read_steps(out) for event in step.outputs.events}
    assert not told & {"tracking_drift", "contact", "blown_about"}, log.read_text()
    truth = read_truth(out / "truth.jsonl")
    assert truth is not None and not truth.contacts
    assert re.search("completed|landed", log.read_text())
