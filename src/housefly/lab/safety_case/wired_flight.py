"""Flies one service as people fly it, in real processes and in real time, with a fault in it."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import TypeAdapter

from housefly.lab.safety_case.faulty_flight import (
    SAFETY_PLACE,
    SAFETY_SITE,
    needs_scanners,
    variant_of,
)
from housefly.lab.safety_case.plan import shared_out
from housefly.lab.safety_case.process_faults import PROCESS_FAULTS, wait_for_take_off
from housefly.lab.safety_case.wired_oracle import wired_violations
from housefly.record.truth import TRUTH_FILE, TrueFlight, read_truth
from housefly.sites.loaded_site import load_site, read_site
from housefly.twin.demo_site import demo_changes
from housefly.twin.faults.catalogue import FAULT_CATALOGUE
from housefly.twin.faults.fault_row import FaultRow
from housefly.twin.faults.vocabulary import Injection

_TIMEOUT = 240.0
"""A flight that is not over after this was not ended by its pilot [s]; it takes about 40."""
_BEGINS_FROM, _BEGINS_TO = 3.0, 30.0
"""A fault begins between these times of the simulated room [s]: from the pad to the way home."""
_STRUCK_UNTIL = 15.0
"""A process is struck within this time after take-off [s]."""
_LOOK_TIME = 3.0


@dataclass(frozen=True, slots=True, order=True)
class WiredKey:
    """One flight in real processes.

    Attributes:
        row: of the fault matrix, with its variant: ``F13/2cm``.
        seed: of the simulated noise, and of when the fault begins.
    """

    row: str
    seed: int


@dataclass(frozen=True, slots=True)
class WiredResult:
    """How one flight in real processes ended, on the truth.

    Attributes:
        key: which flight.
        began_at: when the fault began, on the clock of the room [s].
        violations: what must not happen and did, in words; none means safe.
        outcome: as ``summary.json`` has it.
    """

    key: WiredKey
    began_at: float
    violations: tuple[str, ...]
    outcome: str

    @property
    def unsafe(self) -> bool:
        """Whether something happened that must not."""
        return bool(self.violations)

    def to_json(self) -> dict[str, Any]:
        """Return the result as plain values."""
        return asdict(self)


_RESULT: TypeAdapter[WiredResult] = TypeAdapter(WiredResult)


def wired_result_from_json(text: str) -> WiredResult:
    """Return the result of what ``to_json`` gave; raises ValidationError for anything else."""
    return _RESULT.validate_json(text)


def wired_keys(flights: int, rows: tuple[str, ...] = ()) -> list[WiredKey]:
    """Return so many flights of each row that can be made on wires; of all rows without any."""
    wanted = [row for row in FAULT_CATALOGUE if not rows or row.number in rows]
    return [
        WiredKey(name, seed)
        for row in wanted
        for name, seed in shared_out(_variants_wired(row), flights)
    ]


def wired_rows() -> tuple[FaultRow, ...]:
    """Return the rows that can be flown in real processes."""
    return tuple(row for row in FAULT_CATALOGUE if _variants_wired(row))


def _variants_wired(row: FaultRow) -> tuple[str, ...]:
    processes = tuple(name for name in PROCESS_FAULTS if name.startswith(row.number))
    return processes + tuple(
        f"{row.number}/{variant.name}"
        for variant in row.variants
        if not variant.is_extreme
        and all(Injection.WIRES in fault.type.where for fault in variant.faults)
    )


def fly_wired(key: WiredKey, folder: Path, seat: int = 0) -> WiredResult:
    """Fly one flight, keep its record in a folder, and judge it.

    Args:
        key: which flight.
        folder: for its record.
        seat: flights at the same time have different ones, and with them different addresses.
    """
    rng = np.random.default_rng([key.seed, sum(map(ord, key.row))])
    struck = PROCESS_FAULTS.get(key.row)
    span = (0.0, _STRUCK_UNTIL) if struck else (_BEGINS_FROM, _BEGINS_TO)
    from_start = struck is None and variant_of(key.row).from_start
    begin = 0.0 if from_start else float(rng.uniform(*span))
    folder.mkdir(parents=True, exist_ok=True)
    site = write_own_site(folder, seat, scanned=not struck and needs_scanners(key.row))
    command = [
        *(sys.executable, "-m", "housefly.cli", "fly", SAFETY_PLACE, "--site", str(site)),
        *("--headless", "--look", str(_LOOK_TIME), "--seed", str(1 + key.seed)),
        *("--out", str(folder), *(() if struck else ("--fault", f"{key.row}@{begin:.1f}s"))),
    ]
    with (folder / "printed.txt").open("wb") as printed:
        process = subprocess.Popen(command, stdout=printed, stderr=subprocess.STDOUT)
        try:
            if struck is not None and wait_for_take_off(folder, _TIMEOUT):
                time.sleep(begin)
                struck.strike(process.pid)
            late = not _has_ended(process)
        finally:
            _end(process)
    outcome = _outcome(folder)
    truth = read_truth(folder / TRUTH_FILE)
    return WiredResult(key, round(begin, 1), _violations(key, truth, outcome, late), outcome)


def _has_ended(process: subprocess.Popen[bytes]) -> bool:
    """Wait for a flight; False when it had to be told to end."""
    try:
        process.wait(_TIMEOUT)
    except subprocess.TimeoutExpired:
        _end(process)
        return False
    return True


def _end(process: subprocess.Popen[bytes]) -> None:
    """Let a flight that still goes on land and end."""
    if process.poll() is None:
        process.send_signal(signal.SIGINT)
        process.wait()


def write_own_site(folder: Path, seat: int, *, scanned: bool) -> Path:
    """Write the site with addresses and a memory of its own; scanned, with the lively lasers."""
    lasers = demo_changes()["lasers"] if scanned else ()
    here = f"127.77.{seat}"
    site = read_site(
        SAFETY_SITE,
        drone__address=f"{here}.1",
        tracking__address=f"{here}.1",
        hub__store=str((folder / "room.db").resolve()),
        lasers=[{**laser, "address": f"{here}.{2 + n}"} for n, laser in enumerate(lasers)],
    )
    file = folder / "site.json"
    file.write_text(site.model_dump_json(), "utf-8")
    return file


def _outcome(folder: Path) -> str:
    try:
        return str(json.loads((folder / "summary.json").read_text("utf-8"))["outcome"])
    except (OSError, ValueError, KeyError):
        return ""


def _violations(
    key: WiredKey, truth: TrueFlight | None, outcome: str, late: bool
) -> tuple[str, ...]:
    if truth is None or not outcome:
        return ("no record of it",)
    loaded = load_site(SAFETY_SITE, hub__enabled=False)
    # A drone that stands and is silent for good never says so: its flight may end late.
    end = f"after {_TIMEOUT:.0f} s" if late else "when the flight ended"
    return wired_violations(
        truth,
        loaded.room.bounds,
        loaded.site.limits.speed,
        end,
        cannot_hover=key.row not in PROCESS_FAULTS and variant_of(key.row).cannot_hover,
    )
