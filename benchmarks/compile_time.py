"""The first compile of everything, and the start of each command that uses compiled code once it is
kept.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from _run import table

ROOT = Path(__file__).resolve().parents[1]
HOUSEFLY = str(Path(sys.executable).with_name("housefly"))
FIRST_LIMIT, START_LIMIT = 60.0, 1.5
CORES = 2
STARTS = 5
FLY_ONE = """
from housefly.config.site import Site
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.flight_plan import FlightPlan, Task
fly_many(cases(Site()), FlightPlan(Task.PATH, ((0.0, 0.0), (1.0, 0.0)), 3.0), threads=1)
"""
STEP_A_PILOT = """
from housefly.sites.loaded_site import open_site, read_site
from housefly.pilot.assembly import warm_up
loaded = open_site(read_site("bsen"))
warm_up(loaded.site, loaded.room, loaded.grid)
"""
COMMANDS: dict[str, list[str]] = {
    "help of the command line": [HOUSEFLY, "--help"],
    "`housefly plan --to entrance`": [HOUSEFLY, "plan", "--to", "entrance"],
    "`housefly campaign SPEC --dry-run` (flies a probe)": [
        HOUSEFLY, "campaign", str(ROOT / "examples" / "08_tracking_rate.toml"), "--dry-run",
    ],
    "`housefly gains --alpha 4 --beta 4` (the whole answer)": (
        f"{HOUSEFLY} gains --alpha 4 --beta 4".split()
    ),
    "a pilot and its first 50 steps, from Python": [sys.executable, "-c", STEP_A_PILOT],
    "one flight of the engine, from Python": [sys.executable, "-c", FLY_ONE],
}  # fmt: skip


def timed(command: list[str], environment: dict[str, str]) -> float:
    """Return how long a command takes from start to end [s]."""
    start = time.perf_counter()
    done = subprocess.run(
        command, capture_output=True, text=True, check=False, env=environment, cwd=ROOT
    )
    if done.returncode:
        sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
    return time.perf_counter() - start


def main() -> None:
    os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:CORES])
    with tempfile.TemporaryDirectory() as cache:
        environment = {**os.environ, "NUMBA_CACHE_DIR": cache}
        first = timed([sys.executable, "-m", "housefly.app.warm_up"], environment)
        rows = []
        for name, command in COMMANDS.items():
            timed(command, environment)
            took = [timed(command, environment) for _ in range(STARTS)]
            rows.append(
                (
                    name,
                    f"{statistics.median(took):.2f}",
                    f"{max(took):.2f}",
                    f"{max(took) / START_LIMIT:.2f}",
                )
            )
    print("### Compiling, and starting without it\n")
    print(
        f"First compile of control loop and campaign engine on {CORES} cores: {first:.1f} s, "
        f"{first / FIRST_LIMIT:.2f} of the limit ({FIRST_LIMIT:.0f} s).\n"
    )
    print(
        table(
            ("cached start, whole command", "median [s]", "longest [s]", "longest / limit (1.5 s)"),
            rows,
        )
    )
    print(f"\n{STARTS} starts each, new processes.")


if __name__ == "__main__":
    main()
