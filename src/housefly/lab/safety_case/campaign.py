"""Flies a plan on several cores; what was flown is kept, so that it can go on later."""

from __future__ import annotations

import gc
import json
import os
import pickle
import traceback
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor, as_completed
from functools import partial
from multiprocessing import active_children, get_context
from pathlib import Path
from queue import SimpleQueue
from typing import Any, Protocol, TypeVar

from pydantic import ValidationError

from housefly.config.text import shortened
from housefly.config.validation import dotted, explain
from housefly.errors import RecordingError
from housefly.lab.safety_case.faulty_flight import FaultyFlight, course_of, fly_trial, onset_of
from housefly.lab.safety_case.trial import TrialKey, TrialResult, result_from_json
from housefly.lab.safety_case.wired_flight import (
    WiredKey,
    WiredResult,
    fly_wired,
    wired_result_from_json,
)

RESULTS_FILE = "flights.jsonl"
WIRED_RESULTS_FILE = "wired_flights.jsonl"

_MOST = 24
"""So many flights at once: what is flown at once is lost when it is interrupted."""


class FlownResult(Protocol):
    """A result that is kept as a line of a file."""

    @property
    def key(self) -> Any:
        """Which flight it was."""

    def to_json(self) -> dict[str, Any]:
        """Return the result as plain values."""


R = TypeVar("R", bound=FlownResult)


def flown_results(folder: Path) -> list[TrialResult]:
    """Return what a folder holds of flights in lock step; raises RecordingError."""
    return _read(folder / RESULTS_FILE, result_from_json)


def wired_results(folder: Path) -> list[WiredResult]:
    """Return what a folder holds of flights in real processes; raises RecordingError."""
    return _read(folder / WIRED_RESULTS_FILE, wired_result_from_json)


def fly_plan(
    keys: list[TrialKey], folder: Path, workers: int, on_result: Callable[[TrialResult], None]
) -> list[TrialResult]:
    """Fly what a folder does not hold yet, and return everything that was asked for."""
    known = flown_results(folder)
    wanted = _wanted(keys, known)
    return _kept(keys, known, folder / RESULTS_FILE, _flown(wanted, workers), on_result)


def fly_wired_plan(
    keys: list[WiredKey], folder: Path, at_once: int, on_result: Callable[[WiredResult], None]
) -> list[WiredResult]:
    """Fly the same way in real processes, so many flights at the same time."""
    known = wired_results(folder)
    flights = _flown_on_wires(_wanted(keys, known), folder / "wired", at_once)
    return _kept(keys, known, folder / WIRED_RESULTS_FILE, flights, on_result)


def _flown_on_wires(keys: list[WiredKey], folder: Path, at_once: int) -> Iterator[WiredResult]:
    seats: SimpleQueue[int] = SimpleQueue()
    for seat in range(at_once):
        seats.put(seat)

    def fly(key: WiredKey) -> WiredResult:
        seat = seats.get()
        try:
            return fly_wired(key, folder / f"{key.row.replace('/', '_')}_{key.seed}", seat)
        finally:
            seats.put(seat)

    with ThreadPoolExecutor(at_once) as pool:
        try:
            for flown in as_completed([pool.submit(fly, key) for key in keys]):
                yield flown.result()
        finally:
            pool.shutdown(cancel_futures=True)


def _wanted(keys: list[Any], known: Iterable[FlownResult]) -> list[Any]:
    there = {result.key for result in known}
    return [key for key in keys if key not in there]


def _kept(
    keys: Iterable[object],
    known: list[R],
    path: Path,
    flights: Iterable[R],
    on_result: Callable[[R], None],
) -> list[R]:
    """Write each result as it comes, and return those of the keys."""
    path.parent.mkdir(parents=True, exist_ok=True)
    results = {result.key: result for result in known}
    _rewrite(path, known)
    with path.open("a", encoding="utf-8") as file:
        for result in flights:
            file.write(json.dumps(result.to_json()) + "\n")
            file.flush()
            results[result.key] = result
            on_result(result)
    return [results[key] for key in keys]


def _read(path: Path, parse: Callable[[str], R]) -> list[R]:
    """Return the results of a file; a line cut short at the end is left out.

    Raises:
        RecordingError: a line in the middle cannot be read, or the last one was never ours.
    """
    if not path.exists():
        return []
    lines = path.read_bytes().splitlines()
    results = []
    for number, line in enumerate(lines, 1):
        try:
            text = line.decode("ascii")
            json.loads(text)  # tells a line that was cut short from one that was never ours
            results.append(parse(text))
        except (ValueError, RecursionError) as error:
            if number == len(lines) and isinstance(error, json.JSONDecodeError):
                break
            words = f"{path}, line {number}: {_problem(error)}; remove it to go on"
            raise RecordingError(words) from error
    return results


def _problem(error: Exception) -> str:
    if not isinstance(error, ValidationError):
        return str(error)
    first = error.errors()[0]
    return f"{dotted(first['loc']) or 'it'} {shortened(explain(first), 120)}"


def _rewrite(path: Path, results: Iterable[FlownResult]) -> None:
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
        try:
            groups = [pool.submit(fly_alike, group) for group in alike(keys)]
            for flown in as_completed(groups):
                yield from flown.result()
        except BaseException:
            # A signal to this process alone; flights that nobody waits for are not flown on.
            for worker in active_children():
                worker.terminate()
            raise
        finally:
            pool.shutdown(cancel_futures=True)


def _yield_to_others() -> None:
    os.nice(5)


def alike(keys: Iterable[TrialKey]) -> Iterator[tuple[TrialKey, ...]]:
    """Yield the flights in groups whose members have one course."""
    groups: dict[object, list[TrialKey]] = {}
    for key in keys:
        groups.setdefault(course_of(key), []).append(key)
    for group in groups.values():
        yield from (tuple(group[n : n + _MOST]) for n in range(0, len(group), _MOST))


def fly_alike(keys: tuple[TrialKey, ...]) -> list[TrialResult]:
    """Fly flights of one course; in a process without other threads."""
    flight, results = FaultyFlight(course_of(keys[0])), list[TrialResult]()
    waiting = {key: onset_of(key) for key in keys}
    while waiting and not flight.is_over:
        due = [key for key, onset in waiting.items() if flight.is_due(onset)]
        for key in due:
            del waiting[key]
            if not waiting:
                return [*results, flight.finish(key)]
            results.append(_in_a_child(partial(flight.finish, key)))
        flight.advance()
    return [*results, *(flight.result(key) for key in waiting)]


def _in_a_child(finish: Callable[[], TrialResult]) -> TrialResult:
    """Return what a forked child makes of this flight.

    Raises:
        ChildProcessError: it failed; it has printed why.
    """
    reader, writer = os.pipe()
    # What no collection touches is not copied for the child.
    gc.freeze()
    child = os.fork()
    if not child:
        _report(finish, writer)
    gc.unfreeze()
    os.close(writer)
    with os.fdopen(reader, "rb") as file:
        told = file.read()
    if os.waitpid(child, 0)[1]:
        raise ChildProcessError("a flight that was forked failed")
    result: TrialResult = pickle.loads(told)
    return result


def _report(finish: Callable[[], TrialResult], writer: int) -> None:
    """Write how a flight ended, and leave the process without its parent's endings."""
    status = 1
    try:
        with os.fdopen(writer, "wb") as file:
            pickle.dump(finish(), file)
        status = 0
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status)
