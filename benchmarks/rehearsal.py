"""How long a rehearsal takes, warm, and how near it comes to the flight at full rate."""

from __future__ import annotations

import time
from typing import Any

from _run import table
from housefly.app.loaded_site import load_site
from housefly.app.rehearsal import Rehearser
from housefly.app.room_now import RoomNow
from housefly.app.task_lockstep import fly_task_lockstep
from housefly.errors import LinkError
from housefly.hub.api.questions import Question
from housefly.messages import Obstacle
from housefly.tasks.api.values import ParameterValue
from housefly.tasks.document.library import bind, load_library
from housefly.tasks.execution.task_room import SeenPerson

REPEATS = 3
GOAL = 2.0
VISITOR = SeenPerson("visitor", (0.85, 4.2, 0.0), (0.0, 0.0), 0.1)
RESIDENT = SeenPerson("person-1", (11.9, 4.65, 0.0), (0.0, 0.0), 0.1)
BOX = Obstacle("box", (8.0, 3.3), 0.25, source="laser-1", top=1.5)
CASES: tuple[tuple[str, dict[str, ParameterValue], RoomNow], ...] = (
    ("visitor", {}, RoomNow(people=(VISITOR,))),
    ("visitor", {}, RoomNow(people=(VISITOR, RESIDENT), obstacles=(BOX,))),
    ("look", {"subject": "refrigerator", "time": 300.0}, RoomNow()),
    ("look", {"subject": "the moon"}, RoomNow()),
)


def nobody(question: Question) -> Any:
    """Remember nothing."""
    raise LinkError("nobody remembers")


def main() -> None:
    """Print what rehearsals take and find."""
    loaded, library, now = load_site("bsen"), load_library(), [RoomNow()]
    rehearser = Rehearser(loaded, lambda: now[0], nobody, limit=120.0)
    rehearser.rehearse(bind(library["look"], {"subject": "tv"})).result()
    rows: list[list[object]] = []
    for service, parameters, room in CASES:
        now[0], task = room, bind(library[service], parameters)
        walls, reports = [], []
        for _ in range(REPEATS):
            begin = time.monotonic()
            reports.append(rehearser.rehearse(task).result())
            walls.append(time.monotonic() - begin)
        one = reports[0]
        of = f"{len(room.people)} people, {len(room.obstacles)} obstacles"
        told = "" if one.duration is None else f"{one.duration:.1f}"
        charge = "" if one.charge is None else f"{100 * one.charge:.1f} %"
        rows.append([service, of, f"{min(walls):.2f}", one.code.value, told, charge])
    rehearser.close()
    begin = time.process_time()
    flight = fly_task_lockstep(loaded, bind(library["visitor"], {}))
    full = time.process_time() - begin
    shown = [
        f"{full:.2f}",
        "flown",
        f"{flight.landed_at or 0.0:.1f}",
        f"{100 * flight.charge:.1f} %",
    ]
    rows.append(["visitor", "at 100 Hz, the whole flight", *shown])
    print("### Rehearsals\n")
    print(table(["task", "room", "took [s]", "found", "duration [s]", "charge"], rows))
    print(
        f"\nIn the warm worker, quickest of {REPEATS}; goal: under {GOAL:.0f} s for the visitor"
        " service on an idle machine. The last row is processor time."
    )


if __name__ == "__main__":
    main()
