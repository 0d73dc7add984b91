"""What each test costs in processor time: ``pytest -p cpu_per_test`` writes ``test-cost.csv``.

One line for each test: seconds of processor time with set-up, tear-down and ended children, seconds
on the clock, and its name. Children that live on (a browser for all tests) show on the clock only.
``python tests/support/cpu_per_test.py test-cost.csv`` sums it up by file.
"""

from __future__ import annotations

import csv
import os
import resource
import sys
import time
from collections import Counter
from collections.abc import Generator
from pathlib import Path

import pytest

FILE = "test-cost.csv"


def _spent() -> float:
    usages = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


def pytest_sessionstart(session: pytest.Session) -> None:
    """Begin a new file; workers only add to it."""
    if "PYTEST_XDIST_WORKER" not in os.environ:
        session.config.rootpath.joinpath(FILE).write_text("", encoding="utf-8")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    """Measure one test with its fixtures; one short line is written at once by the system."""
    cost, clock = _spent(), time.monotonic()
    result = yield
    line = f"{_spent() - cost:.3f},{time.monotonic() - clock:.3f},{item.nodeid.replace(',', ';')}\n"
    with item.config.rootpath.joinpath(FILE).open("a", encoding="utf-8") as file:
        file.write(line)
    return result


def main(path: str) -> None:
    """Print the total, and the files that cost most."""
    cost: Counter[str] = Counter()
    clock: Counter[str] = Counter()
    with Path(path).open(encoding="utf-8", newline="") as lines:
        for processor, seconds, name in csv.reader(lines):
            file = name.split("::")[0]
            cost[file] += float(processor)
            clock[file] += float(seconds)
    print(f"{sum(cost.values()):9.1f} s of processor, {sum(clock.values()):.1f} s on the clock")
    for file, seconds in cost.most_common(60):
        print(f"{seconds:9.1f} {clock[file]:9.1f}  {file}")


if __name__ == "__main__":
    main(sys.argv[1])
