"""Flies batches in blocks and keeps each in a folder: a killed run loses one block at most."""

from __future__ import annotations

import os
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import Protocol

import numpy as np

from housefly.lab.experiments.cases import Cases
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.experiments.flight_plan import FlightPlan
from housefly.lab.experiments.outcomes import OUTCOME, Outcomes

BLOCK = 2048
"""Drones of a block: seconds of flying."""


class FlyBatch(Protocol):
    """What ``fly_many`` and ``KeptFlights`` have in common."""

    def __call__(
        self, cases: Cases, mission: FlightPlan, *, on_progress: Progress | None = None
    ) -> Outcomes:
        """Fly every case and return one row each, in order."""
        ...


class KeptFlights:
    """Flies like ``fly_many``, but reads what an earlier run has flown with the same inputs.

    A drone's result depends on its own row alone, so blocks give what one batch would.

    Args:
        folder: for the blocks; made if need be.
        sources: names the state of the code; blocks of other code are not read.
        on_kept: told how many drones an earlier run has flown.
    """

    def __init__(
        self, folder: Path, sources: str, on_kept: Callable[[int], None] = lambda count: None
    ) -> None:
        self._folder, self._sources, self._on_kept = folder, sources, on_kept
        self._own: set[Path] = set()
        folder.mkdir(parents=True, exist_ok=True)

    def __call__(
        self, cases: Cases, mission: FlightPlan, *, on_progress: Progress | None = None
    ) -> Outcomes:
        """Fly every case that is not kept and return one row each, in order."""
        starts = range(0, len(cases), BLOCK)
        blocks = [self._block(cases[s : s + BLOCK], mission, on_progress) for s in starts]
        return np.concatenate(blocks) if blocks else np.zeros(0, OUTCOME)

    def _block(self, cases: Cases, mission: FlightPlan, on_progress: Progress | None) -> Outcomes:
        path = self._folder / f"{self._name(cases, mission)}.npy"
        kept = _read(path, len(cases))
        if kept is not None:
            if path not in self._own:
                self._on_kept(len(cases))
            if on_progress is not None:
                on_progress(len(cases))
            return kept
        flown = fly_many(cases, mission, on_progress=on_progress)
        _write(path, flown)
        self._own.add(path)
        return flown

    def _name(self, cases: Cases, mission: FlightPlan) -> str:
        inputs = sha256(f"{self._sources} {mission.digest} {cases.dtype}".encode())
        inputs.update(np.ascontiguousarray(cases).tobytes())
        return inputs.hexdigest()[:24]


def _read(path: Path, rows: int) -> Outcomes | None:
    """Return the block; None where it is absent, damaged, or of another shape."""
    try:
        block = np.load(path, allow_pickle=False)
    except (OSError, ValueError, EOFError):
        return None
    return block if block.dtype == OUTCOME and block.shape == (rows,) else None


def _write(path: Path, block: Outcomes) -> None:
    """Write the block; it has its name only when it is whole."""
    part = path.with_suffix(f".{os.getpid()}.part")
    with part.open("wb") as file:
        np.save(file, block, allow_pickle=False)
    part.replace(path)
