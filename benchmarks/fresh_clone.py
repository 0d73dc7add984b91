"""From a fresh clone to a flying room: `make demo` in a new folder until it says that it is ready,
everything installed anew.

System packages that this machine has already are not installed again; on a bare Debian they add
what their download takes.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from _run import table

REPOSITORY = Path(__file__).resolve().parents[1]
GOAL_S, WARM_GOAL_S = 120.0, 8.0


def seconds_to_ready(folder: Path) -> float:
    """Run ``make demo`` until it is ready, end it by Ctrl-C, return how long it took [s]."""
    start = time.monotonic()
    demo = subprocess.Popen(
        ["make", "demo"],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        process_group=0,
    )
    assert demo.stdout is not None
    told = []
    for line in demo.stdout:
        told.append(line)
        if "ready after" in line:
            elapsed = time.monotonic() - start
            os.killpg(demo.pid, signal.SIGINT)
            demo.stdout.read()
            demo.wait()
            return elapsed
    sys.exit(f"make demo ended before it was ready:\n{''.join(told)}")


def main() -> None:
    """Clone, start twice, print both times."""
    with tempfile.TemporaryDirectory() as folder:
        clone = Path(folder) / "housefly"
        subprocess.run(["git", "clone", "-q", str(REPOSITORY), str(clone)], check=True)
        fresh, warm = seconds_to_ready(clone), seconds_to_ready(clone)
    print("### From `git clone` to ready\n")
    rows = [
        ("first `make demo`: install, compile, start", fresh, GOAL_S),
        ("second `make demo`", warm, WARM_GOAL_S),
    ]
    print(
        table(
            ["", "seconds", "goal [s]", "share of the goal"],
            [[n, f"{t:.1f}", f"{g:.0f}", f"{t / g:.2f}"] for n, t, g in rows],
        )
    )


if __name__ == "__main__":
    main()
