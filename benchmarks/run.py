"""Runs every benchmark and writes docs/results.md.

``make bench`` runs them all; ``python benchmarks/run.py planner bus`` runs some and keeps the other
sections as they are. Each benchmark is a script that prints Markdown. Machines differ and are
shared: trust the ratios within one run.
"""

from __future__ import annotations

import os
import platform
import re
import subprocess
import sys
import time
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
RESULTS = FOLDER.parent / "docs" / "results.md"
TIMEOUT_S = 2400
HEAD = """# Results

Tables were printed by the command above them, on the day beside it; what was added by hand says so.
Machines are shared and noisy: trust the ratios inside a section, not the absolute figures, never
compare sections of different days, and run `make bench` on yours.
"""


def names() -> list[str]:
    """Return the benchmarks in alphabetical order."""
    return sorted(
        path.stem
        for path in FOLDER.glob("*.py")
        if path.stem != "run" and not path.stem.startswith("_")
    )


def measure(name: str) -> tuple[str, bool]:
    """Run one benchmark; return its section, and whether its limits were kept.

    One that prints figures and is red stands in the results with them.
    """
    print(f"{name} ...", flush=True)
    start = time.monotonic()
    done = subprocess.run(
        [sys.executable, str(FOLDER / f"{name}.py")],
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        check=False,
    )
    if done.returncode and not done.stdout.strip():
        sys.exit(f"{name} failed:\n{done.stdout}\n{done.stderr}")
    print(f"  {time.monotonic() - start:.0f} s", flush=True)
    command = f"`python benchmarks/{name}.py` ({time.strftime('%Y-%m-%d')})"
    section = f"<!-- {name} -->\n{command}\n\n{done.stdout.strip()}\n"
    return section, done.returncode == 0


def machine() -> str:
    """Return one line about this machine."""
    cpu = next(
        (
            line.split(":")[1].strip()
            for line in Path("/proc/cpuinfo").read_text().splitlines()
            if "model name" in line
        ),
        "?",
    )
    cores = len(os.sched_getaffinity(0))
    return (
        f"The last were measured on {time.strftime('%Y-%m-%d')}: {cpu}, {cores} cores, Python"
        f" {platform.python_version()}, no GPU."
    )


def kept_sections() -> dict[str, str]:
    """Return the sections of the page as it is, by benchmark."""
    if not RESULTS.is_file():
        return {}
    parts = re.split(r"(?m)^(?=<!-- \w+ -->$)", RESULTS.read_text(encoding="utf-8"))
    return {part.split(" ", 2)[1]: part.rstrip() + "\n" for part in parts[1:]}


def main() -> None:
    """Run the named benchmarks, or all."""
    wanted = sys.argv[1:] or names()
    unknown = set(wanted) - set(names())
    if unknown:
        sys.exit(
            f"no benchmark called {', '.join(sorted(unknown))}; there are: {', '.join(names())}"
        )
    kept = kept_sections()
    # A section without a benchmark holds dated figures of something that has left the tree.
    sections = kept if sys.argv[1:] else {name: kept[name] for name in set(kept) - set(names())}
    red = []
    for name in wanted:
        sections[name], is_kept = measure(name)
        red += [] if is_kept else [name]
        # At once: what was measured is not lost when a later one fails.
        body = "\n".join(sections[name] for name in sorted(sections))
        RESULTS.write_text(f"{HEAD}\n{machine()}\n\n{body}", encoding="utf-8")
    print(f"written: {RESULTS.relative_to(FOLDER.parent)}")
    if red:
        sys.exit(f"not within their limits: {', '.join(red)}")


if __name__ == "__main__":
    main()
