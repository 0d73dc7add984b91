"""Processes whose logs lie on a full disk start and stay: what is printed is no reason to end."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from housefly.app.launcher import processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime
from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY, TASKS_QUERY
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import changed
from housefly.errors import LinkError
from housefly.sites.loaded_site import read_site

pytestmark = [
    pytest.mark.wire,
    pytest.mark.realtime,
    pytest.mark.interop,
    pytest.mark.slow,
    pytest.mark.timeout(240),
]

LASER = {"name": "eye", "x": 13.9, "y": 3.3, "z": 1.1, "yaw": -2.6}


@contextmanager
def running_on_a_full_disk(runtime: Runtime) -> Iterator[dict[str, subprocess.Popen[bytes]]]:
    """Run what a launcher runs, but once each, and without logs that can be read."""
    running = {}
    # A user's Python keeps what could not be written, and tries again; one under test may not.
    environment = {**runtime.environment(), "PYTHONUNBUFFERED": ""}
    with Path("/dev/full").open("wb", buffering=0) as full:
        for spec in processes_of(runtime):
            running[spec.name] = subprocess.Popen(
                [sys.executable, "-m", spec.module, *spec.arguments],
                env=environment,
                pass_fds=spec.inherited,
                stdin=subprocess.DEVNULL,
                stdout=full,
                stderr=full,
            )
    try:
        yield running
    finally:
        for process in running.values():
            process.terminate()
        for process in running.values():
            try:
                process.wait(20.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def answers(bus: Bus, query: str) -> bool:
    try:
        return bus.ask(query, "", 1.0) != ""
    except LinkError:
        return False


def wait_until(holds: Callable[[], bool], limit: float) -> None:
    deadline = time.monotonic() + limit
    while not holds() and time.monotonic() < deadline:
        time.sleep(0.2)


def test_every_process_whose_log_takes_no_more_starts_and_stays(
    tmp_path: Path, write_site: Callable[..., Path]
) -> None:
    site = read_site(str(write_site()))
    site = changed(site, lasers=[{**LASER, "address": site.drone.address}])
    runtime = new_runtime(site, tmp_path, web=True)
    with (
        running_on_a_full_disk(runtime) as running,
        ZenohBus(connect=runtime.bus) as bus,
    ):
        assert set(running) == {
            "room",
            "pilot",
            "driver",
            "twin",
            "hub",
            "perception",
            "tasks",
            "web",
        }

        def ended() -> list[str]:
            return [name for name, process in running.items() if process.poll() is not None]

        ready = Readiness(site, bus, web=True, video=False)
        missing = ready.wait(90.0, is_hopeless=lambda: len(ended()) >= len(running) - 1)
        wait_until(lambda: answers(bus, HUB_QUERY) and answers(bus, TASKS_QUERY), 30.0)
        time.sleep(3.0)  # who answers may end right after
        assert (ended(), missing) == ([], "")
