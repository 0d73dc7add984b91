"""How long a rehearsal takes, warm, on this machine as it is and with every core busy, and how near
it comes to the flight at full rate.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from unittest.mock import patch

from _run import percentile, table
from housefly.errors import LinkError
from housefly.hub.api.questions import Question
from housefly.lab.rehearsal import rehearsed_flight
from housefly.lab.rehearsal.process import NICENESS
from housefly.lab.rehearsal.rehearsed_flight import RehearsedSite
from housefly.lab.rehearsal.rehearser import Rehearser
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.messages import Obstacle
from housefly.sites.loaded_site import load_site
from housefly.tasks.api.values import ParameterValue, RehearsalReport
from housefly.tasks.document.library import bind, load_library
from housefly.tasks.execution.task_room import SeenPerson

REPEATS = 3
GOAL = 2.0
FULL_RATE_HZ = 100.0
VISITOR = SeenPerson("visitor", (0.85, 4.2, 0.0), (0.0, 0.0), 0.1)
RESIDENT = SeenPerson("person-1", (11.9, 4.65, 0.0), (0.0, 0.0), 0.1)
BOX = Obstacle("box", (8.0, 3.3), 0.25, source="laser-1", top=1.5)
CASES: tuple[tuple[str, dict[str, ParameterValue], RoomNow], ...] = (
    ("visitor", {}, RoomNow(people=(VISITOR,))),
    ("visitor", {}, RoomNow(people=(VISITOR, RESIDENT), obstacles=(BOX,))),
    ("look", {"subject": "refrigerator", "time": 300.0}, RoomNow()),
    ("look", {"subject": "the moon"}, RoomNow()),
)
PLACES = ("entrance", "table", "bed", "kitchen", "sofa", "tv", "desk", "window")


def nobody(question: Question) -> Any:
    """Remember nothing."""
    raise LinkError("nobody remembers")


@contextmanager
def busy() -> Iterator[None]:
    """Keep every core busy at the rehearsal's own priority."""
    burn = f"import os\nos.nice({NICENESS})\nwhile True: pass"
    cores = len(os.sched_getaffinity(0))
    burners = [subprocess.Popen([sys.executable, "-c", burn]) for _ in range(cores)]
    try:
        yield
    finally:
        for burner in burners:
            burner.kill()
            burner.wait()


def timed(
    rehearser: Rehearser, now: list[RoomNow], case: tuple[str, dict[str, ParameterValue], RoomNow]
) -> tuple[float, RehearsalReport]:
    """Return what one rehearsal takes [s], the quickest of some, and what it finds."""
    service, parameters, now[0] = case
    task = bind(load_library()[service], parameters)
    walls = []
    for _ in range(REPEATS):
        begin = time.monotonic()
        report = rehearser.rehearse(task).result()
        walls.append(time.monotonic() - begin)
    return min(walls), report


def print_times() -> None:
    """Print what rehearsals take in the worker, idle and busy."""
    now = [RoomNow()]
    rehearser = Rehearser(load_site("bsen"), lambda: now[0], nobody, limit=120.0)
    rehearser.rehearse(bind(load_library()["look"], {"subject": "tv"})).result()
    rows: list[list[object]] = []
    for case in CASES:
        alone, one = timed(rehearser, now, case)
        with busy():
            beside, _ = timed(rehearser, now, case)
        room = f"{len(case[2].people)} people, {len(case[2].obstacles)} obstacles"
        told = "" if one.duration is None else f"{one.duration:.1f}"
        charge = "" if one.charge is None else f"{100 * one.charge:.1f} %"
        ratio = f"{beside / alone:.1f}" if alone > 0.1 else ""
        rows.append([case[0], room, f"{alone:.2f}", f"{beside:.2f}", ratio, one.code.value])
        rows[-1] += [told, charge]
    rehearser.close()
    heads = ["task", "room", "as it is [s]", "busy [s]", "busy over as it is"]
    print(table([*heads, "found", "duration [s]", "charge"], rows))
    print(
        f"\nIn the warm worker, quickest of {REPEATS}; busy: one endless loop a core, as nice as"
        f" the worker. Goal: under {GOAL:.0f} s for the visitor service."
    )


def print_rates() -> None:
    """Print how near rehearsals come to those at the full rates, and what they save."""
    loaded, found = load_site("bsen"), []
    quick = RehearsedSite(loaded)
    with patch.multiple(rehearsed_flight, _RATE_HZ=FULL_RATE_HZ, _TRACKING_RATE_HZ=FULL_RATE_HZ):
        full = RehearsedSite(loaded)
    warm = bind(load_library()["look"], {"subject": PLACES[-1], "time": 2.0})
    for site in (quick, full):
        site.rehearse(warm, RoomNow(), nobody)
    for place in PLACES:
        task = bind(load_library()["look"], {"subject": place, "time": 2.0})
        pair = []
        for site in (quick, full):
            begin = time.process_time()
            report = site.rehearse(task, RoomNow(), nobody)
            pair.append((time.process_time() - begin, report))
        found.append(pair)
    both = [pair for pair in found if all(report.may_fly for _, report in pair)]
    cost = [mine / whole for (mine, _), (whole, _) in both]
    time_off = [abs((a.duration or 0) / (b.duration or 1) - 1) for (_, a), (_, b) in both]
    near_off = [abs((a.clearance or 0) - (b.clearance or 0)) for (_, a), (_, b) in both]
    rows = [
        (
            "the same verdict",
            f"{sum(a.code is b.code for (_, a), (_, b) in found)} of {len(found)}",
        ),
        ("processor time over that at full rate, median", f"{percentile(cost, 0.5):.2f}"),
        ("duration off that at full rate, most", f"{100 * max(time_off):.1f} %"),
        ("clearance off that at full rate, most", f"{100 * max(near_off):.1f} cm"),
    ]
    print(
        f"\nA look at each of {len(PLACES)} places, beside a rehearsal at {FULL_RATE_HZ:.0f} Hz:\n"
    )
    print(table(["what", "figure"], rows))


def main() -> None:
    """Print what rehearsals take and find."""
    print("### Rehearsals\n")
    print_times()
    print_rates()


if __name__ == "__main__":
    main()
