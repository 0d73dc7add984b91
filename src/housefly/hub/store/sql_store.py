"""The store in SQL, shared by both databases."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from housefly.errors import StoreError
from housefly.hub.store.database import Database, Row
from housefly.hub.store.forget import Forgotten, forget_thing
from housefly.hub.store.retention import DAY, delete_old_events, prune_step
from housefly.hub.store.rows import (
    EVENT_COLUMNS,
    SAMPLE_COLUMNS,
    THING_COLUMNS,
    VIEWPOINT_COLUMNS,
    event_from_row,
    is_valid,
    row_of_event,
    row_of_sample,
    row_of_thing,
    row_of_viewpoint,
    sample_from_row,
    thing_from_row,
)
from housefly.hub.store.run_length import RunLengthEncoder
from housefly.hub.store.schema import MIGRATIONS, Migrations, migrate
from housefly.hub.store.statements import (
    EXTEND_SAMPLE,
    INSERT_EVENT,
    INSERT_SAMPLE,
    SELECT_PATH,
    SELECT_SEEN,
    THINNED_PATH,
    UPSERT_LATEST,
    UPSERT_THING,
    insert_into,
)
from housefly.hub.store.store import DEFAULT_KEEP_DAYS, TrajectoryRows
from housefly.hub.things.thing import Thing
from housefly.messages import Observation, RoomEvent


class SqlStore:
    """A ``Store`` on a database."""

    def __init__(
        self,
        database: Database,
        *,
        keep_days: float = DEFAULT_KEEP_DAYS,
        keep_events_days: float = 0.0,
        steps: Migrations = MIGRATIONS,
    ) -> None:
        """Migrate the tables; raises StoreError if a newer version made them."""
        self._database = database
        self._keep_days, self._keep_events_days = keep_days, keep_events_days
        self._runs = RunLengthEncoder()
        try:
            migrate(database, steps)
        except StoreError:
            database.close()
            raise

    @property
    def notices(self) -> tuple[str, ...]:
        """What the user should know about how it was opened."""
        return self._database.notices

    def put_things(self, things: Iterable[Thing]) -> None:
        """Write things of the catalogue, replacing older ones."""
        kept = tuple(things)
        ids = [(thing.id,) for thing in kept]
        aliases = [
            (thing.id, number, alias)
            for thing in kept
            for number, alias in enumerate(thing.aliases)
        ]
        views = [
            (thing.id, number, *row_of_viewpoint(view))
            for thing in kept
            for number, view in enumerate(thing.viewpoints)
        ]
        with self._database.transaction():
            self._database.many(UPSERT_THING, [row_of_thing(thing) for thing in kept])
            self._database.many("DELETE FROM alias WHERE thing = ?", ids)
            self._database.many("DELETE FROM viewpoint WHERE thing = ?", ids)
            self._database.many(insert_into("alias", "thing, number, alias"), aliases)
            self._database.many(
                insert_into("viewpoint", f"thing, number, {VIEWPOINT_COLUMNS}"), views
            )

    def write(self, samples: Sequence[Observation], events: Sequence[RoomEvent] = ()) -> None:
        """Write all or nothing; raises StoreError (not now) or RejectedRowError (never)."""
        change = self._runs.encode(samples)
        newest: dict[tuple[str, str, bool], Observation] = {}
        for sample in samples:
            key = sample.thing, sample.source, is_valid(sample)
            if key not in newest or sample.captured_at >= newest[key].captured_at:
                newest[key] = sample
        try:
            with self._database.transaction():
                self._database.many(
                    INSERT_SAMPLE, [_begin(run.sample, run.until) for run in change.begun]
                )
                self._database.many(
                    EXTEND_SAMPLE, [_extend(run.sample, run.until) for run in change.extended]
                )
                self._database.many(UPSERT_LATEST, [_latest(sample) for sample in newest.values()])
                self._database.many(INSERT_EVENT, [row_of_event(event) for event in events])
        except StoreError:
            self._runs.reset()
            raise

    def things(self, thing: str = "") -> tuple[Thing, ...]:
        """Return one thing of the catalogue by its id, or all."""
        where, values = ("WHERE {} = ?", (thing,)) if thing else ("", ())
        aliases: dict[str, list[str]] = {}
        views: dict[str, list[Row]] = {}
        of_thing = where.format("thing")
        for owner, alias in self._database.query(
            f"SELECT thing, alias FROM alias {of_thing} ORDER BY thing, number", values
        ):
            aliases.setdefault(owner, []).append(alias)
        for owner, *view in self._database.query(
            f"SELECT thing, {VIEWPOINT_COLUMNS} FROM viewpoint {of_thing} ORDER BY thing, number",
            values,
        ):
            views.setdefault(owner, []).append(tuple(view))
        rows = self._database.query(
            f"SELECT {THING_COLUMNS} FROM thing {where.format('id')} ORDER BY id", values
        )
        return tuple(
            thing_from_row(row, aliases.get(row[0], ()), views.get(row[0], ())) for row in rows
        )

    def latest(self, thing: str = "") -> tuple[Observation, ...]:
        """Return the last valid and invalid sample of each source, of one thing or of all."""
        where, values = ("WHERE thing = ?", (thing,)) if thing else ("", ())
        sql = (
            f"SELECT thing, source, captured_at, valid, {SAMPLE_COLUMNS} FROM latest {where}"
            " ORDER BY thing, source, captured_at"
        )
        return tuple(sample_from_row(row) for row in self._database.query(sql, values))

    def latest_at(self, at: float, thing: str = "") -> tuple[Observation, ...]:
        """Return the last valid sample of each source up to a time, of one thing or of all."""
        sql, values = (
            (f"{SELECT_SEEN} AND l.thing = ?", (at, at, at, thing))
            if thing
            else (SELECT_SEEN, (at, at, at))
        )
        return tuple(
            sample_from_row(row)
            for row in self._database.query(f"{sql} ORDER BY l.thing, l.source", values)
        )

    def trajectory(
        self, thing: str, since: float, until: float, *, source: str = "", every: float = 0.0
    ) -> TrajectoryRows:
        """Return where a thing was between two times, by one source or by all."""
        sources = [
            sample.source
            for sample in self.latest_at(until, thing)
            if source in ("", sample.source)
        ]
        before = {sample.source: sample for sample in self.latest_at(since, thing)}
        parts = [
            _from_begin(before.get(name), since, self._path(thing, name, since, until, every))
            for name in sources
        ]
        return parts[0] if len(parts) == 1 else _by_time(np.concatenate([np.empty((0, 4)), *parts]))

    def events(
        self, since: float, until: float, *, thing: str = "", kind: str = "", cause: str = ""
    ) -> tuple[RoomEvent, ...]:
        """Return what happened between two times, by time."""
        asked = [
            (column, value)
            for column, value in (("thing", thing), ("kind", kind), ("cause", cause))
            if value
        ]
        where = "".join(f" AND {column} = ?" for column, _ in asked)
        sql = (
            f"SELECT {EVENT_COLUMNS} FROM event WHERE at >= ? AND at <= ?{where}"
            " ORDER BY at, kind, thing, source, cause"
        )
        return tuple(
            event_from_row(row)
            for row in self._database.query(sql, (since, until, *(value for _, value in asked)))
        )

    def prune(self, now: float) -> bool:
        """Thin and delete old samples in one short transaction; return whether more is left."""
        if self._keep_events_days:
            delete_old_events(self._database, now - self._keep_events_days * DAY)
        return prune_step(self._database, now, keep_days=self._keep_days)

    def forget(self, thing: str, names: Iterable[str] = ()) -> Forgotten:
        """Delete all of a thing, and what is left of it in the file; no hub may run."""
        found = forget_thing(self._database, thing, names)
        self._database.scrub()
        return found

    def close(self) -> None:
        """Close the database."""
        self._database.close()

    def _path(
        self, thing: str, source: str, since: float, until: float, every: float
    ) -> TrajectoryRows:
        """Return the samples of one source; where it stood still, begin and end of that."""
        asked: Row = (thing, source, since, until)
        sql, values = SELECT_PATH, asked
        if every > 0.0:
            bucket = self._database.dialect.floor.format(f"captured_at / {every!r}")
            sql, values = SELECT_PATH + THINNED_PATH.format(bucket), asked * 2
        runs = self._database.numbers(f"{sql} ORDER BY captured_at", values, 5)
        path, stood = runs[:, (0, 2, 3, 4)], runs[:, 1] > runs[:, 0]
        if not stood.any():
            return path
        ends = np.column_stack([np.minimum(runs[stood, 1], until), runs[stood, 2:]])
        return _by_time(np.concatenate([path, ends]))


def _begin(sample: Observation, until: float) -> Row:
    return (
        sample.thing,
        sample.source,
        sample.captured_at,
        until,
        int(is_valid(sample)),
        *row_of_sample(sample),
    )


def _extend(sample: Observation, until: float) -> Row:
    return until, sample.thing, sample.source, sample.captured_at, until


def _latest(sample: Observation) -> Row:
    return (
        sample.thing,
        sample.source,
        int(is_valid(sample)),
        sample.captured_at,
        *row_of_sample(sample),
    )


def _by_time(path: TrajectoryRows) -> TrajectoryRows:
    return path[np.argsort(path[:, 0], kind="stable")]


def _from_begin(before: Observation | None, since: float, path: TrajectoryRows) -> TrajectoryRows:
    """Prepend the position at the begin, if the source reported one at that very time."""
    if before is None or before.position is None or before.captured_at < since:
        return path
    return np.concatenate([np.array([(since, *before.position)]), path])
