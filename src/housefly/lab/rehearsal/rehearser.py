"""Rehearses tasks in a warm process of its own, so that no flight waits for a rehearsal.

A worker that crashes, hangs or is not ready is a refusal, never a yes; it is started again.
"""

from __future__ import annotations

import logging
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import replace
from multiprocessing.connection import Connection
from threading import Lock
from typing import Any

from housefly.errors import HouseflyError
from housefly.hub.api.questions import Question
from housefly.lab.rehearsal.rehearsal_ahead import RENEW_TIME, RehearsedAhead, is_same_room
from housefly.lab.rehearsal.rehearsal_link import (
    MemoryQuestion,
    MemoryReply,
    RehearsalOrder,
    WorkerReady,
    memory_refusal,
)
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.messages.words import literal
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.api.values import ReasonCode, RehearsalReport
from housefly.tasks.document.task_document import BoundTask

_log = logging.getLogger(__name__)

REHEARSAL_LIMIT = 110.0
"""Longest time of a rehearsal [s]: a slow machine that does all of a house takes over twenty."""
_OWN_SHARE = 0.8
"""Of that time the worker itself may take this share: it says best why it stops."""
_START_LIMIT = 180.0
"""A worker that is not ready after so long is started again [s]: it may have to compile."""
_WORKER = "housefly.lab.rehearsal.process"
_END_TIME = 2.0


class Rehearser:
    """One worker and who talks to it; thread-safe.

    Args:
        loaded: the site as it flies.
        look: returns the room as it is now.
        ask: asks the room's memory; raises ThingError or LinkError.
        limit: longest time of a rehearsal [s].

    Attributes:
        limit: the same; counts from the next rehearsal on.
    """

    def __init__(
        self,
        loaded: LoadedSite,
        look: Callable[[], RoomNow],
        ask: Callable[[Question], Any],
        limit: float = REHEARSAL_LIMIT,
    ) -> None:
        self._loaded, self._look, self._ask, self.limit = loaded, look, ask, limit
        self._thread = ThreadPoolExecutor(1, "rehearsal")
        self._worker: _Worker | None = None
        self._closed = False
        self._ahead: dict[int, RehearsedAhead] = {}
        self._room = self._seen = RoomNow()
        self._last: Future[RehearsalReport] | None = None
        self._thread.submit(self._start)

    @property
    def process_id(self) -> int | None:
        """The worker's process, once it is started."""
        return None if self._worker is None else self._worker.process_id

    def rehearse(self, task: BoundTask) -> Future[RehearsalReport]:
        """Begin a rehearsal on the room as it is now; one after the other.

        One that was rehearsed ahead, in the same room, is answered at once.
        """
        known = self._known(task)
        if known is not None:
            told: Future[RehearsalReport] = Future()
            told.set_result(known)
            return told
        # By its turn the one ahead that was under way may have been the same.
        self._last = self._thread.submit(lambda: self._known(task) or self._rehearsed(task))
        return self._last

    def rehearse_ahead(self, tasks: Sequence[BoundTask]) -> None:
        """Rehearse what may be asked for at any moment; to be called about once a second.

        Nothing is begun while anything moves in the room or another rehearsal is under way. What
        is refused is not tried again before the room changes or its time is over.
        """
        before, room = self._seen, self._look()
        self._seen = room
        is_busy = self._last is not None and not self._last.done()
        if self._closed or is_busy or not is_same_room(before, room):
            return
        for number, task in enumerate(tasks):
            kept = self._ahead.get(number)
            if kept is None or not kept.holds(task, room, RENEW_TIME):
                self._last = self._thread.submit(self._kept, number, task)
                return

    def close(self) -> None:
        """End the worker; a rehearsal under way is refused."""
        self._closed = True
        worker = self._worker
        if worker is not None:
            worker.end()
        self._thread.shutdown(cancel_futures=True)

    def _start(self) -> None:
        if not self._closed:
            self._worker = _Worker(self._loaded)
        if self._closed and self._worker is not None:
            self._worker.end()

    def _known(self, task: BoundTask) -> RehearsalReport | None:
        """Return what was found ahead, in the room as it is now."""
        room = self._look()
        held = (one for one in tuple(self._ahead.values()) if one.counts(task, room))
        return next((replace(one.report, took=0.0) for one in held), None)

    def _rehearsed(self, task: BoundTask) -> RehearsalReport:
        try:
            worker = self._ready_worker()
            if worker is None:
                return _not_ready("the rehearsal is still getting ready; ask again in a moment")
            return self._answered(worker, task)
        except TimeoutError:
            return self._failed(f"the rehearsal gave no answer within {self.limit:.0f} s")
        except (OSError, EOFError) as error:
            _log.warning("the rehearsal failed: %s", error)
            return self._failed("the rehearsal failed; its log says why")

    def _kept(self, number: int, task: BoundTask) -> RehearsalReport:
        report = self._rehearsed(task)
        self._ahead[number] = RehearsedAhead(task, self._room, report)
        return report

    def _ready_worker(self) -> _Worker | None:
        """Return the worker once it is ready, None where it never is; one that is gone is replaced.

        Getting ready counts for no rehearsal: on a slow machine it takes longer than any of them.
        """
        worker = self._worker
        if worker is None or not worker.is_alive or worker.is_late:
            if worker is not None:
                worker.end()
            self._start()
            worker = self._worker
        return worker if worker is not None and worker.is_ready() else None

    def _answered(self, worker: _Worker, task: BoundTask) -> RehearsalReport:
        """Return what the worker finds; its questions are answered meanwhile."""
        until = time.monotonic() + self.limit
        self._room = self._look()
        worker.send(RehearsalOrder(task, self._room, _OWN_SHARE * self.limit))
        while True:
            message = worker.receive(until)
            if isinstance(message, RehearsalReport):
                return message
            if isinstance(message, MemoryQuestion):
                worker.send(self._asked(message.question))

    def _asked(self, question: Question) -> MemoryReply:
        try:
            return MemoryReply(self._ask(question))
        except HouseflyError as error:
            return memory_refusal(error)

    def _failed(self, words: str) -> RehearsalReport:
        """Start another worker; return the refusal."""
        if self._worker is not None:
            self._worker.end()
        self._start()
        return _not_ready(words)


class _Worker:
    """One process and the pipe to it."""

    def __init__(self, loaded: LoadedSite) -> None:
        ours, theirs = socket.socketpair()
        with theirs:
            self._process = subprocess.Popen(
                [sys.executable, "-m", _WORKER, str(theirs.fileno())],
                pass_fds=(theirs.fileno(),),
                stdin=subprocess.DEVNULL,
            )
        self._pipe = Connection(ours.detach())
        self._since, self._ready = time.monotonic(), False
        with suppress(OSError):
            self._pipe.send(loaded)

    @property
    def process_id(self) -> int:
        return self._process.pid

    @property
    def is_alive(self) -> bool:
        return self._process.poll() is None

    @property
    def is_late(self) -> bool:
        return not self._ready and time.monotonic() - self._since > _START_LIMIT

    def is_ready(self) -> bool:
        """Wait for the worker to be ready, as long as it may take to start."""
        while not self._ready:
            try:
                message = self.receive(self._since + _START_LIMIT)
                self._ready = isinstance(message, WorkerReady)
            except TimeoutError:
                return False
        return True

    def send(self, message: object) -> None:
        self._pipe.send(message)

    def receive(self, until: float) -> object:
        """Return the next message; raises TimeoutError, EOFError or OSError when none comes."""
        if not self._pipe.poll(max(0.0, until - time.monotonic())):
            raise TimeoutError
        message: object = self._pipe.recv()
        return message

    def end(self) -> None:
        """End the process; it holds nothing that could be lost."""
        with suppress(OSError):
            self._pipe.close()
        self._process.kill()
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(_END_TIME)


def _not_ready(words: str) -> RehearsalReport:
    return RehearsalReport(False, ReasonCode.NOT_READY, literal(words))


class DroneRehearsers:
    """Hands each rehearsal to the worker of its drone; thread-safe.

    Args:
        starts: start the rehearsals of a drone, by its name; at least one.
    """

    def __init__(self, starts: Mapping[str, Callable[[], Rehearser]]) -> None:
        self._starts, self._lock = starts, Lock()
        self._first = next(iter(starts))
        self._running: dict[str, Rehearser] = {}

    def start(self) -> None:
        """Start the first drone's worker, so that its first rehearsal need not wait."""
        self._of(self._first)

    def rehearse(self, task: BoundTask, drone: str) -> Future[RehearsalReport]:
        """Begin a rehearsal with a drone, "" for the first, in the room as it is now."""
        return self._of(drone or self._first).rehearse(task)

    def rehearse_ahead(self, tasks: Sequence[BoundTask]) -> None:
        """Rehearse what may be asked for at any moment, with the first drone; see ``Rehearser``."""
        self._of(self._first).rehearse_ahead(tasks)

    def close(self) -> None:
        """End all workers."""
        with self._lock:
            for rehearser in self._running.values():
                rehearser.close()

    def _of(self, drone: str) -> Rehearser:
        with self._lock:
            if drone not in self._running:
                self._running[drone] = self._starts[drone]()
            return self._running[drone]
