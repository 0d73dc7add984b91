"""The rehearsal worker: ``python -m housefly.lab.rehearsal.process DESCRIPTOR``; tasks start it.

Loads and compiles everything, says that it is ready, then rehearses one task after the other until
its parent is gone.
"""

from __future__ import annotations

import os
import signal
import sys
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from housefly.errors import HouseflyError, LinkError
from housefly.geometry import distance
from housefly.hub.api.questions import Question
from housefly.lab.rehearsal.rehearsal_link import (
    MemoryQuestion,
    MemoryReply,
    RehearsalOrder,
    WorkerReady,
)
from housefly.lab.rehearsal.rehearsed_flight import RehearsedSite
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.pilot.assembly import warm_up
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.document.library import bind, load_library

NICENESS = 3
"""Added to that of the tasks: the pilot comes first, but a person waits for what is found here."""
_ALARM_FACTOR = 3.0
"""A rehearsal that nobody waits for any more ends the process after so many times its limit."""


def serve(pipe: Connection) -> None:
    """Rehearse whatever is ordered; raises EOFError when the parent is gone."""
    loaded = pipe.recv()
    assert isinstance(loaded, LoadedSite)
    site = RehearsedSite(loaded)
    _warm(site, loaded)

    def ask(question: Question) -> Any:
        pipe.send(MemoryQuestion(question))
        reply = pipe.recv()
        assert isinstance(reply, MemoryReply)
        return reply.unpacked()

    pipe.send(WorkerReady())
    while True:
        order = pipe.recv()
        assert isinstance(order, RehearsalOrder)
        signal.setitimer(signal.ITIMER_REAL, _ALARM_FACTOR * order.limit)
        pipe.send(site.rehearse(order.task, order.now, ask, order.limit))
        signal.setitimer(signal.ITIMER_REAL, 0.0)


def _warm(site: RehearsedSite, loaded: LoadedSite) -> None:
    """Compile and load whatever a rehearsal needs, by one to the nearest place."""
    warm_up(loaded.site, loaded.room, loaded.grid)
    room = loaded.room
    places = [place for place in room.places if place.name != "home"]
    ways = [distance(place.viewpoint, room.home) for place in places]
    subject = places[ways.index(min(ways))].name if places else "home"
    with suppress(HouseflyError, KeyError):
        site.rehearse(bind(load_library()["look"], {"subject": subject}), RoomNow(), _nobody)


def _nobody(question: Question) -> Any:
    raise LinkError("nobody remembers anything yet")


def main() -> None:
    """Serve until the parent is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.nice(NICENESS)
    with suppress(EOFError, ConnectionError):
        serve(Connection(int(sys.argv[1])))


if __name__ == "__main__":
    main()
