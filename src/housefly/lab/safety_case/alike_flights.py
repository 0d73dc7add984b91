"""Flies flights together that are alike until their faults begin.

The way to the first fault is flown once. Where a fault begins, the process forks: the child flies
that flight to its end, and the parent goes on without the fault. Every flight is the same, bit for
bit, as flown alone.
"""

from __future__ import annotations

import gc
import os
import pickle
import traceback
from collections.abc import Callable, Iterable, Iterator
from functools import partial

from housefly.lab.safety_case.faulty_flight import FaultyFlight, course_of, onset_of
from housefly.lab.safety_case.trial import TrialKey, TrialResult

_MOST = 24
"""So many flights at once: what is flown at once is lost when it is interrupted."""


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
