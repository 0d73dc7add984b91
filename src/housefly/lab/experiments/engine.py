"""Flies many drones at once: threads over a compiled loop that holds no lock."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.lab.experiments.cases import Cases
from housefly.lab.experiments.flight_plan import FlightPlan
from housefly.lab.experiments.loop import Record, flight_buffers, fly_rows, ticks_of
from housefly.lab.experiments.outcomes import OUTCOME, Outcomes
from housefly.lab.experiments.route import Route, route_of
from housefly.lab.experiments.trace import SEEN, TRACE, Trace

Progress = Callable[[int], None]
"""Called with the number of drones that have just landed."""

CHUNK = 64
"""Drones flown between two looks at whether to stop."""
NICENESS = 10
"""Of the threads: a drone that flies in real time on the same machine goes first."""
UNWRITTEN = Record(np.zeros(0, TRACE), np.zeros(0, SEEN))


def fly_many(
    cases: Cases,
    mission: FlightPlan,
    *,
    threads: int | None = None,
    on_progress: Progress | None = None,
) -> Outcomes:
    """Fly every case on its own and return one row each, in order.

    A drone's result depends on its own row alone: not on the others, the number of threads, or the
    order.

    Args:
        cases: one row a drone, dtype ``CASE``.
        mission: what all of them are to do.
        threads: how many at a time; None takes one a core.
        on_progress: told how many have just landed.
    """
    route, outcomes = route_of(mission), np.zeros(len(cases), OUTCOME)
    starts = range(0, len(cases), CHUNK)
    with ThreadPoolExecutor(threads or len(os.sched_getaffinity(0)), initializer=_yield) as pool:
        chunks = [pool.submit(_fly_chunk, cases, start, route, outcomes) for start in starts]
        try:
            for chunk in as_completed(chunks):
                landed = chunk.result()
                if on_progress is not None:
                    on_progress(landed)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return outcomes


def fly_traced(cases: Cases, mission: FlightPlan) -> Trace:
    """Fly the first case and return every tick as a structured array of dtype ``trace.TRACE``."""
    return fly_recorded(cases, mission)[0]


def fly_recorded(cases: Cases, mission: FlightPlan) -> tuple[Trace, NDArray[Any]]:
    """Fly the first case; return every tick, and every sighting with its tick (``trace.SEEN``)."""
    route = route_of(mission)
    ticks = ticks_of(route, cases[0]) + 1
    frames = int(2.0 + mission.duration * float(cases["mocap_rate_hz"][0]))
    record = Record(np.zeros(ticks, TRACE), np.zeros(frames, SEEN))
    outcomes = np.zeros(1, OUTCOME)
    fly_rows(cases, 0, 1, route, flight_buffers(cases), record, outcomes)
    flown = np.count_nonzero(record.ticks["t"]) + 1
    return record.ticks[:flown], record.seen[record.seen["captured_at"] > 0.0]


def _yield() -> None:
    if sys.platform == "linux":  # elsewhere niceness belongs to the whole process
        thread = threading.get_native_id()
        os.setpriority(
            os.PRIO_PROCESS, thread, max(NICENESS, os.getpriority(os.PRIO_PROCESS, thread))
        )


def _fly_chunk(cases: Cases, start: int, route: Route, outcomes: Outcomes) -> int:
    stop = min(start + CHUNK, len(cases))
    fly_rows(cases, start, stop, route, flight_buffers(cases[start:stop]), UNWRITTEN, outcomes)
    return stop - start
