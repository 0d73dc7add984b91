"""Batches are kept block by block: what was flown once is read, not flown again."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from housefly.config.site import Site
from housefly.lab.experiments.cases import Cases, cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.lab.reproduction import kept_flights
from housefly.lab.reproduction.kept_flights import KeptFlights

PLAN = FlightPlan(Task.STEP, ((0.0, 0.0), (0.5, 0.0)), 3.0)
DRONES = 40


@pytest.fixture(autouse=True)
def small_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept_flights, "BLOCK", 16)


def fleet(count: int = DRONES) -> Cases:
    return cases(Site(), count, seed=np.arange(count))


class Interrupted(Exception):
    """The test ends the run."""


def counted(folder: Path, sources: str = "now") -> tuple[KeptFlights, list[int]]:
    kept: list[int] = []
    return KeptFlights(folder, sources, kept.append), kept


def test_blocks_give_what_one_batch_gives_and_a_second_run_flies_nothing(tmp_path: Path) -> None:
    landed: list[int] = []
    fly, kept = counted(tmp_path)
    first = fly(fleet(), PLAN, on_progress=landed.append)
    assert first.tobytes() == fly_many(fleet(), PLAN).tobytes()
    assert sum(landed) == DRONES and kept == []
    again, kept = counted(tmp_path)
    assert again(fleet(), PLAN).tobytes() == first.tobytes()
    assert sum(kept) == DRONES


def test_an_interrupted_run_goes_on_behind_its_last_whole_block(tmp_path: Path) -> None:
    landed = 0

    def interrupt(count: int) -> None:
        nonlocal landed
        landed += count
        if landed > 16:
            raise Interrupted

    with pytest.raises(Interrupted):
        counted(tmp_path)[0](fleet(), PLAN, on_progress=interrupt)
    fly, kept = counted(tmp_path)
    assert fly(fleet(), PLAN).tobytes() == fly_many(fleet(), PLAN).tobytes()
    assert sum(kept) == 16


def test_other_code_other_drones_and_another_task_are_flown(tmp_path: Path) -> None:
    counted(tmp_path)[0](fleet(), PLAN)
    longer = FlightPlan(Task.STEP, ((0.0, 0.0), (0.6, 0.0)), 3.0)
    gentle = cases(Site(), DRONES, seed=np.arange(DRONES), alpha=3.5)
    for sources, drones, plan in (
        ("later", fleet(), PLAN),
        ("now", gentle, PLAN),
        ("now", fleet(), longer),
    ):
        fly, kept = counted(tmp_path, sources)
        assert fly(drones, plan).tobytes() == fly_many(drones, plan).tobytes()
        assert kept == []


@pytest.mark.parametrize("damage", ["cut", "empty", "pickled", "other rows"])
def test_a_damaged_block_is_flown_again(tmp_path: Path, damage: str) -> None:
    counted(tmp_path)[0](fleet(), PLAN)
    for path in tmp_path.glob("*.npy"):
        match damage:
            case "cut":
                path.write_bytes(path.read_bytes()[:-40])
            case "empty":
                path.write_bytes(b"")
            case "pickled":
                np.save(path, np.array([{}], dtype=object), allow_pickle=True)
            case _:
                np.save(path, np.load(path)[:-1])
    fly, kept = counted(tmp_path)
    assert fly(fleet(), PLAN).tobytes() == fly_many(fleet(), PLAN).tobytes()
    assert kept == []


_ENDLESS = """
import sys
from pathlib import Path
import numpy as np
from housefly.config.site import Site
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.lab.reproduction import kept_flights
kept_flights.BLOCK = 16
plan = FlightPlan(Task.STEP, ((0.0, 0.0), (0.5, 0.0)), 3.0)
drones = cases(Site(), 1_000_000, seed=np.arange(1_000_000))
kept_flights.KeptFlights(Path(sys.argv[1]), "now")(drones, plan)
"""


@pytest.mark.interop
@pytest.mark.timeout(120)
def test_what_was_flown_before_a_kill_is_kept(tmp_path: Path) -> None:
    flying = subprocess.Popen([sys.executable, "-c", _ENDLESS, str(tmp_path)])
    try:
        while len(list(tmp_path.glob("*.npy"))) < 3:
            assert flying.poll() is None
            time.sleep(0.05)
    finally:
        flying.send_signal(signal.SIGKILL)
        flying.wait()
    fly, kept = counted(tmp_path)
    assert fly(fleet(48), PLAN).tobytes() == fly_many(fleet(48), PLAN).tobytes()
    assert sum(kept) == 48
