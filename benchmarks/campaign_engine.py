"""The campaign engine beside that of the release before, in the same run, fleet by fleet in turn.

``python benchmarks/campaign_engine.py [REVISION]`` compares with any revision of this repository.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

from _run import table

ROOT = Path(__file__).resolve().parents[1]
PROBE = Path(__file__).with_name("_engine_probe.py")
PREVIOUS_RELEASE = "d929f4e"
"""The last commit in which live pilot and batch were two assemblies (0.1.0)."""
DRONES, REPEATS = 2_000, 5
FLEETS = ("default, 100 Hz", "default, 30 Hz", "paper, 100 Hz", "paper, 30 Hz")


class Engine:
    """The engine of one source tree in a process of its own."""

    def __init__(self, source: Path) -> None:
        environment = os.environ | {"PYTHONPATH": str(source)}
        self._process = subprocess.Popen(
            [sys.executable, str(PROBE), str(DRONES)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=environment,
        )
        self._answer()

    def fly(self, fleet: str) -> tuple[float, str]:
        """Return drone-seconds per core-second and a digest of all outcomes."""
        assert self._process.stdin is not None
        self._process.stdin.write(fleet + "\n")
        self._process.stdin.flush()
        answer = json.loads(self._answer())
        return answer["rate"], answer["digest"]

    def close(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.wait()

    def _answer(self) -> str:
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        return line or sys.exit("an engine did not start")


def main() -> None:
    revision = sys.argv[1] if len(sys.argv) > 1 else PREVIOUS_RELEASE
    with tempfile.TemporaryDirectory() as folder:
        archive = subprocess.run(
            ["git", "archive", revision, "src"], cwd=ROOT, stdout=subprocess.PIPE, check=True
        )
        subprocess.run(["tar", "-x", "-C", folder], input=archive.stdout, check=True)
        ours, theirs = Engine(ROOT / "src"), Engine(Path(folder) / "src")
        try:
            rows = [_compared(ours, theirs, fleet) for fleet in FLEETS]
        finally:
            ours.close()
            theirs.close()
    print("### The campaign engine: drone-seconds per core-second, double precision\n")
    headings = ("fleet", "ours", f"revision {revision}", "ratio (limit 0.95)", "outcomes")
    print(table(headings, rows))
    print(
        f"\n{DRONES:,} drones on one thread, pilot at 100 Hz, noise, jitter, 5 % of frames lost,"
        f" 20 s each; median of {REPEATS} rounds in turn."
    )


def _compared(ours: Engine, theirs: Engine, fleet: str) -> tuple[str, ...]:
    pairs = [(ours.fly(fleet), theirs.fly(fleet)) for _ in range(REPEATS)]
    ratio = median(a[0] / b[0] for a, b in pairs)
    same = "the same, bit for bit" if pairs[0][0][1] == pairs[0][1][1] else "not the same"
    rates = (median(pair[side][0] for pair in pairs) for side in (0, 1))
    return (fleet, *(f"{rate:,.0f}" for rate in rates), f"{ratio:.2f}", same)


if __name__ == "__main__":
    main()
