"""Five guards broken on purpose: which tests go red.

    python benchmarks/broken_guards.py             all five, about eight minutes
    python benchmarks/broken_guards.py watchdog    those whose name holds this

Each guard is left out in a process of its own, which then runs the tests named here. A guard that
nobody misses ends this command with 1.
"""

from __future__ import annotations

import multiprocessing
import os
import sys
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from _run import table

ROOT = Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class BrokenGuard:
    """A method that answers as if its guard were not there, and the tests to run."""

    name: str
    module: str
    method: str
    answer: Callable[..., Any]
    tests: tuple[str, ...]


GUARDS = (
    BrokenGuard(
        "gate: a landing is kept until the drone stands",
        "housefly.pilot.safety.gate",
        "Gate._land",
        lambda self, broken, context: broken,
        ("tests/pilot/safety/test_gate.py", "tests/pilot/test_faults.py"),
    ),
    BrokenGuard(
        "after a gap tracking is held against the drone's own motion",
        "housefly.pilot.estimation.tracking_monitor",
        "TrackingMonitor.agrees",
        lambda self, sighting, predicted: True,
        ("tests/pilot/estimation/test_pose_estimator.py",),
    ),
    BrokenGuard(
        "collision monitor",
        "housefly.pilot.behavior.collision_monitor",
        "CollisionMonitor._block",
        lambda self, vehicle, target: None,
        ("tests/pilot/test_obstacles.py",),
    ),
    BrokenGuard(
        "the landing column is watched",
        "housefly.pilot.behavior.landing_monitor",
        "LandingMonitor._column_fault",
        lambda self, vehicle: "",
        ("tests/pilot/test_people.py", "tests/pilot/test_obstacles.py"),
    ),
    BrokenGuard(
        "the driver's watchdog",
        "housefly.drones.failsafe",
        "Failsafe._is_silent",
        lambda self, now: False,
        ("tests/drones/ardrone/test_commands.py",),
    ),
)


class RedTests:
    """Collects the tests that failed."""

    def __init__(self) -> None:
        self.names: list[str] = []

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Take one test in."""
        if report.failed and report.when == "call":
            self.names.append(report.nodeid)


def red_without(number: int) -> list[str]:
    """Return the tests that fail without a guard; to be called in a fresh process."""
    guard, red = GUARDS[number], RedTests()
    owner, _, method = guard.method.partition(".")
    setattr(getattr(import_module(guard.module), owner), method, guard.answer)
    options = ["-q", "-p", "no:cacheprovider", "-p", "no:randomly", "--no-header", "--tb=no"]
    output = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    pytest.main([*options, *guard.tests], plugins=[red])
    os.dup2(output, 1)
    return red.names


def main() -> int:
    """Break the guards one after another, and print what went red."""
    os.chdir(ROOT)
    wanted = sys.argv[1] if len(sys.argv) > 1 else ""
    found: dict[str, list[str]] = {}
    fresh = multiprocessing.get_context("spawn")
    for number, guard in enumerate(GUARDS):
        if wanted not in guard.name:
            continue
        print(f"without: {guard.name} ...", file=sys.stderr)
        with fresh.Pool(1) as process:
            found[guard.name] = process.apply(red_without, (number,))
    print("## Guards left out, and the tests that miss them\n")
    rows = [
        (name, len(red), "<br>".join(f"`{test}`" for test in red[:5]) or "none")
        for name, red in found.items()
    ]
    print(table(["without", "red", "the first of them"], rows))
    return 0 if found and all(found.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
