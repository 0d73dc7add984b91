"""A small campaign, and a real Dask cluster of processes on loopback."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from housefly.config.site import Site
from housefly.lab.campaigns.plan import Plan, plan_campaign
from housefly.lab.campaigns.spec import spec_from_tree

SMALL: dict[str, Any] = {
    "name": "small",
    "seeds": 30,
    "mission": {"waypoints": [[0.0, 0.0], [1.0, 0.0]], "task": "step", "duration_s": 5},
    "grid": {"mode": ["default", "paper"], "mocap_rate_hz": [10, 100]},
    "draw": {"lag": {"normal": [7.0, 1.0]}},
}


Planner = Callable[..., Plan]


@pytest.fixture
def small() -> Planner:
    """Return a function that plans a campaign of 120 short flights in chunks of 25."""

    def plan(chunk: int = 25, site: Site | None = None, **keys: Any) -> Plan:
        return plan_campaign(spec_from_tree(SMALL | keys), site or Site(), chunk)

    return plan


class Cluster:
    """A scheduler and workers, each a process of its own."""

    def __init__(self, host: str, folder: Path) -> None:
        self.host, self.folder = host, folder
        told = folder / "scheduler.json"
        self.scheduler = self._start(
            "scheduler", "--host", host, "--port", "0", "--scheduler-file", str(told)
        )
        deadline = time.monotonic() + 30.0
        while not told.is_file() or not told.stat().st_size:
            assert time.monotonic() < deadline and self.scheduler.poll() is None, (
                "the scheduler did not start"
            )
            time.sleep(0.05)
        self.address: str = json.loads(told.read_text())["address"]
        self.workers: list[subprocess.Popen[bytes]] = []

    def add_worker(self, threads: int = 1) -> subprocess.Popen[bytes]:
        options = (
            "--no-nanny",
            "--nthreads",
            str(threads),
            "--host",
            self.host,
            "--local-directory",
            str(self.folder),
        )
        self.workers.append(self._start("worker", self.address, *options))
        return self.workers[-1]

    def stop(self) -> None:
        for process in (*self.workers, self.scheduler):
            process.kill()
            process.wait()

    def _start(self, *words: str) -> subprocess.Popen[bytes]:
        with (self.folder / "log").open("ab") as log:
            return subprocess.Popen(
                [sys.executable, "-m", "dask", *words, "--no-dashboard"], stdout=log, stderr=log
            )


@pytest.fixture
def cluster(loopback: str, tmp_path: Path) -> Iterator[Cluster]:
    folder = tmp_path / "cluster"
    folder.mkdir()
    made = Cluster(loopback, folder)
    try:
        yield made
    finally:
        made.stop()
