"""Flies a plan on several cores; what was flown is kept, so that it can go on later."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

from housefly.app.safety_case.faulty_flight import fly_trial
from housefly.app.safety_case.trial import TrialKey, TrialResult, result_from_json
from housefly.errors import RecordingError

RESULTS_FILE = "flights.jsonl"
_CHUNK = 4


def flown_results(folder: Path) -> list[TrialResult]:
    """Return what a folder holds; a line cut short at the end is left out.

    Raises:
        RecordingError: a line in the middle cannot be read.
    """
    path = folder / RESULTS_FILE
    if not path.exists():
        return []
    lines = path.read_text(encoding="utf-8").splitlines()
    results = []
    for number, line in enumerate(lines, 1):
        try:
            results.append(result_from_json(json.loads(line)))
        except (ValueError, KeyError, TypeError) as error:
            if number == len(lines):
                break
            raise RecordingError(f"{path}, line {number}: {error}; remove it to go on") from error
    return results


def fly_plan(
    keys: list[TrialKey], folder: Path, workers: int, on_result: Callable[[TrialResult], None]
) -> list[TrialResult]:
    """Fly what a folder does not hold yet, and return everything that it holds then."""
    known = {result.key: result for result in flown_results(folder)}
    wanted = [key for key in keys if key not in known]
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / RESULTS_FILE
    _rewrite(path, known.values())
    with path.open("a", encoding="utf-8") as file:
        for result in _flown(wanted, workers):
            file.write(json.dumps(result.to_json()) + "\n")
            file.flush()
            known[result.key] = result
            on_result(result)
    return [known[key] for key in keys]


def _rewrite(path: Path, results: Iterable[TrialResult]) -> None:
    """Drop a line that was cut short."""
    lines = [json.dumps(result.to_json()) + "\n" for result in results]
    fresh = path.with_suffix(".new")
    fresh.write_text("".join(lines), encoding="utf-8")
    fresh.replace(path)


def _flown(keys: list[TrialKey], workers: int) -> Iterator[TrialResult]:
    if workers == 1:
        yield from map(fly_trial, keys)
        return
    with ProcessPoolExecutor(workers, get_context("spawn"), _yield_to_others) as pool:
        yield from pool.map(fly_trial, keys, chunksize=_CHUNK)


def _yield_to_others() -> None:
    os.nice(5)
