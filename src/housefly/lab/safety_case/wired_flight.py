"""Flies one service as people fly it, in real processes and in real time, with a fault in it."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import TypeAdapter

from housefly.geometry import stopping_distance
from housefly.lab.safety_case.faulty_flight import (
    SAFETY_PLACE,
    SAFETY_SITE,
    needs_scanners,
    variant_of,
)
from housefly.lab.safety_case.oracle import FALL_HEIGHT, HARD_LANDING, STANDING
from housefly.lab.safety_case.plan import shared_out
from housefly.lab.safety_case.process_faults import PROCESS_FAULTS, wait_for_take_off
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

_Bounds = tuple[float, float, float, float]
"""Smallest and largest x and y of a room, in the order of ``Room.bounds`` [m]."""
_FALL_TIME = 0.15
"""A fall is judged over at least this long: samples are 0.02 s apart [s]."""


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


def wired_violations(
    truth: TrueFlight, bounds: _Bounds, speed: float, end: str, *, cannot_hover: bool = False
) -> tuple[str, ...]:
    """Return what happened that must not, in words; none means safe.

    Args:
        truth: of the whole flight.
        bounds: of the room.
        speed: cruise speed of the site [m/s].
        end: when the flight was over, in words.
        cannot_hover: whether it has to fall by its fault, which is not judged then.
    """
    return (
        *sorted({f"I1: touched {c.kind} {c.name}" for c in truth.contacts if c.motors_turned}),
        *_outside(truth, bounds, stopping_distance(speed, 1.0, 0.3)),
        *_cut_in_the_air(truth),
        *_risen_again(truth),
        *(() if cannot_hover else _fallen(truth)),
        *_left_up(truth, end),
    )


def _outside(truth: TrueFlight, bounds: _Bounds, allowed: float) -> Iterator[str]:
    x_min, y_min, x_max, y_max = bounds
    x, y = truth.position[:, 0], truth.position[:, 1]
    outside = float(np.maximum.reduce([x_min - x, x - x_max, y_min - y, y - y_max]).max())
    if outside > allowed:
        yield f"I2: {outside:.1f} m outside the room"


def _cut_in_the_air(truth: TrueFlight) -> Iterator[str]:
    stopped = np.flatnonzero(truth.airborne[:-1] & ~truth.airborne[1:])
    heights = truth.position[stopped, 2]
    if len(heights) and heights.max() > FALL_HEIGHT:
        yield f"I4: the motors stopped at {heights.max():.1f} m"


def _risen_again(truth: TrueFlight) -> Iterator[str]:
    """One order is given: who stood after it and rises again does so without one."""
    if np.count_nonzero(~truth.airborne[:-1] & truth.airborne[1:]) > 1:
        yield "I8: took off again without an order"


def _fallen(truth: TrueFlight) -> Iterator[str]:
    height = truth.position[:, 2]
    later = np.searchsorted(truth.time, truth.time + _FALL_TIME)
    ends = later < len(height)
    lost = height[ends] - height[later[ends]]
    took = truth.time[later[ends]] - truth.time[ends]
    fastest = float(np.max(lost / took, initial=0.0))
    if fastest > HARD_LANDING:
        yield f"fall: came down at {fastest:.1f} m/s"


def _left_up(truth: TrueFlight, end: str) -> Iterator[str]:
    if truth.airborne[-1] or truth.position[-1][2] > STANDING:
        yield f"end: at {truth.position[-1][2]:.1f} m {end}"
