"""Writes to a store on its own thread: callers never wait and never see an error.

Every tenth of a second all new rows are written in one transaction, so ``kill -9`` loses about a
tenth of a second. When the store refuses (full disk, locked by another process, no server) the
batch is kept and retried until it succeeds. Meanwhile new rows wait in a bounded backlog, and
what does not fit is dropped and counted: samples before events, the oldest first.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from threading import Condition, Lock, Thread

from housefly.errors import StoreError
from housefly.hub.store.backlog import MAX_BATCH, Backlog, Batch, Dropped
from housefly.hub.store.losses import Losses
from housefly.hub.store.store import RejectedRowError, Store
from housefly.hub.things.thing import Thing
from housefly.messages import Observation, RoomEvent

_BATCH_PERIOD = 0.1
_CAPACITY = 60_000
"""Samples and events that may wait: half a minute at 2000 a second."""
_MAX_RETRY_PAUSE = 1.0
"""A failing store is retried at least this often [s]."""
_PRUNE_PERIOD = 10.0
"""How often to look for old samples if there were none [s]."""
_TOO_SLOW = "the database is too slow"
_STOPPED = "the writer was stopped"


class StoreWriter:
    """Writes values to a store; starts at once, ends with ``close``."""

    def __init__(self, open_store: Callable[[], Store], *, capacity: int = _CAPACITY) -> None:
        """Open the store and start; raises StoreError if it cannot be opened at all."""
        self._open = open_store
        self._store: Store | None = open_store()
        self._backlog = Backlog(capacity)
        self._losses = Losses()
        self._pending = Batch()
        self._reason = ""
        self._notices: tuple[str, ...] = self._store.notices
        self._stopping_at: float | None = None
        self._next_tidy = 0.0
        self._woken = Condition()
        self._moving = Lock()
        self._thread = Thread(target=self._run, name="store-writer", daemon=True)
        self._thread.start()

    def write(self, *values: Observation | RoomEvent | Thing) -> None:
        """Write observations, events and things soon; never waits, never raises."""
        self.write_all(values)

    def write_all(self, values: Iterable[Observation | RoomEvent | Thing]) -> None:
        """Write many at once."""
        if self._stopping_at is None:
            self._count(self._backlog.put(tuple(values)), self._reason or _TOO_SLOW)
        else:
            self._count(_rows_in(values), _STOPPED)

    def report(self) -> str:
        """Return what is wrong, in words; "" when all is kept.

        Says what was dropped in the last minute and why, and what waits and why.
        """
        waiting = len(self._backlog) + len(self._pending.samples) + len(self._pending.events)
        parts = [
            self._losses.words(time.monotonic()),
            f"{waiting:,} rows wait: {self._reason}".replace(",", " ") if self._reason else "",
            *self._notices,
        ]
        return "; ".join(part for part in parts if part)

    def dropped(self) -> Dropped:
        """Return how many rows were dropped since the start."""
        ever = self._losses.ever.copy()
        return Dropped(
            *(
                sum(count for (rows, _), count in ever.items() if rows == asked)
                for asked in ("poses", "events")
            )
        )

    def flush(self, timeout: float = 5.0) -> bool:
        """Wait until everything added so far is written; return whether it is."""
        deadline = time.monotonic() + timeout
        while time.monotonic() < deadline:
            with self._moving:
                if not self._pending and not len(self._backlog):
                    return True
            time.sleep(0.01)
        return False

    def close(self, timeout: float = 5.0) -> None:
        """Write what waits, for at most this long [s], and end; what is left counts as dropped."""
        self._stopping_at = time.monotonic() + timeout
        with self._woken:
            self._woken.notify()
        self._thread.join(timeout + 2 * _MAX_RETRY_PAUSE)

    def _run(self) -> None:
        pause = _BATCH_PERIOD
        while not self._is_over():
            with self._woken:
                self._woken.wait(pause if self._stopping_at is None else _BATCH_PERIOD)
            pause = _BATCH_PERIOD if self._try() else min(2.0 * pause, _MAX_RETRY_PAUSE)
        left = (self._pending, *iter(self._backlog.pop_batch, Batch()))
        for batch in left:
            self._count(_rows_in((*batch.samples, *batch.events)), self._reason or _STOPPED)
        self._pending = Batch()
        if self._store:
            self._store.close()

    def _is_over(self) -> bool:
        if self._stopping_at is None:
            return False
        return time.monotonic() >= self._stopping_at or not (self._pending or len(self._backlog))

    def _try(self) -> bool:
        """Write one batch and prune a little; return whether the store accepted it."""
        try:
            store = self._opened()
            while batch := self._next():
                self._keep(store, batch)
                self._pending = Batch()
                if (
                    len(self._backlog) < MAX_BATCH
                ):  # few came meanwhile: they are for the next tenth of a second
                    break
            self._tidy(store)
        except StoreError as error:
            self._give_up(error.reason)
            return False
        except Exception as error:  # a fault of ours must not end the thread
            self._count(
                Dropped(len(self._pending.samples), len(self._pending.events)),
                f"{type(error).__name__}: {error}",
            )
            self._pending = Batch()
            return False
        self._reason = ""
        return True

    def _opened(self) -> Store:
        if self._store is None:
            self._store = self._open()
            self._notices = tuple(dict.fromkeys((*self._notices, *self._store.notices)))
        return self._store

    def _next(self) -> Batch:
        with self._moving:
            self._pending = self._pending or self._backlog.pop_batch()
        return self._pending

    def _keep(self, store: Store, batch: Batch) -> None:
        try:
            if batch.things:
                store.put_things(batch.things)
            if batch.samples or batch.events:
                store.write(batch.samples, batch.events)
        except RejectedRowError:
            self._keep_one_by_one(store, batch)

    def _keep_one_by_one(self, store: Store, batch: Batch) -> None:
        """Find the rows that the database never accepts; writing a row twice does no harm."""
        singles = [
            *(Batch(things=(thing,)) for thing in batch.things),
            *(Batch(events=(event,)) for event in batch.events),
            *(Batch(samples=(sample,)) for sample in batch.samples),
        ]
        for single in singles:
            try:
                if single.things:
                    store.put_things(single.things)
                else:
                    store.write(single.samples, single.events)
            except RejectedRowError as error:
                self._count(Dropped(len(single.samples), len(single.events)), error.reason)

    def _tidy(self, store: Store) -> None:
        now = time.monotonic()
        if now >= self._next_tidy and self._stopping_at is None:
            self._next_tidy = now if store.prune(time.time()) else now + _PRUNE_PERIOD

    def _give_up(self, reason: str) -> None:
        """Reopen the store at the next attempt: the file may have moved, the server restarted."""
        self._reason = reason
        if self._store:
            self._notices = tuple(dict.fromkeys((*self._notices, *self._store.notices)))
            self._store.close()
        self._store = None

    def _count(self, dropped: Dropped, reason: str) -> None:
        if dropped:
            self._losses.count(dropped, reason, time.monotonic())


def _rows_in(values: Iterable[Observation | RoomEvent | Thing]) -> Dropped:
    values = tuple(values)
    return Dropped(
        *(sum(isinstance(value, sort) for value in values) for sort in (Observation, RoomEvent))
    )
