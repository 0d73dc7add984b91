"""The store in SQL, the same for both databases."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from housefly.errors import StoreError
from housefly.hub.store.changes import Changes
from housefly.hub.store.contract import KEPT_DAYS, Trajectory
from housefly.hub.store.database import Database, Row
from housefly.hub.store.rows import (
    EVENT,
    SAMPLE,
    THING,
    VIEWPOINT,
    happening_of,
    is_valid,
    row_of_happening,
    row_of_sample,
    row_of_thing,
    row_of_viewpoint,
    sample_of,
    thing_of,
)
from housefly.hub.store.schema import STEPS, Steps, migrate
from housefly.hub.store.statements import (
    BEGIN,
    HAPPENED,
    KNOWN,
    LATEST,
    PATH,
    SEEN,
    STRETCH,
    THINNED,
    insert,
)
from housefly.hub.store.tidying import tidy_step
from housefly.hub.things.thing import Thing
from housefly.messages import Happening, Observation


class SqlStore:
    """A ``Store`` over a database."""

    def __init__(
        self, database: Database, *, keep_days: float = KEPT_DAYS, steps: Steps = STEPS
    ) -> None:
        """Bring the tables up to date; raises StoreError when a newer program made them or the
        database refuses.
        """
        self._database = database
        self._keep_days = keep_days
        self._changes = Changes()
        try:
            migrate(database, steps)
        except StoreError:
            database.close()
            raise

    @property
    def notices(self) -> tuple[str, ...]:
        """What the user should know about how it was opened."""
        return self._database.notices

    def know(self, things: Iterable[Thing]) -> None:
        """Keep things of the catalogue, replacing what was known of them."""
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
            self._database.many(KNOWN, [row_of_thing(thing) for thing in kept])
            self._database.many("DELETE FROM alias WHERE thing = ?", ids)
            self._database.many("DELETE FROM viewpoint WHERE thing = ?", ids)
            self._database.many(insert("alias", "thing, number, alias"), aliases)
            self._database.many(insert("viewpoint", f"thing, number, {VIEWPOINT}"), views)

    def write(self, samples: Sequence[Observation], happenings: Sequence[Happening] = ()) -> None:
        """Keep all or nothing; raises StoreError (not now) or UnfitRowError (never)."""
        change = self._changes.of(samples)
        newest: dict[tuple[str, str, bool], Observation] = {}
        for sample in samples:
            key = sample.thing, sample.source, is_valid(sample)
            if key not in newest or sample.captured_at >= newest[key].captured_at:
                newest[key] = sample
        try:
            with self._database.transaction():
                self._database.many(
                    BEGIN, [_begin(span.sample, span.until) for span in change.begun]
                )
                self._database.many(
                    STRETCH, [_stretch(span.sample, span.until) for span in change.stretched]
                )
                self._database.many(LATEST, [_latest(sample) for sample in newest.values()])
                self._database.many(
                    HAPPENED, [row_of_happening(happening) for happening in happenings]
                )
        except StoreError:
            self._changes.forget()
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
            f"SELECT thing, {VIEWPOINT} FROM viewpoint {of_thing} ORDER BY thing, number", values
        ):
            views.setdefault(owner, []).append(tuple(view))
        rows = self._database.query(
            f"SELECT {THING} FROM thing {where.format('id')} ORDER BY id", values
        )
        return tuple(thing_of(row, aliases.get(row[0], ()), views.get(row[0], ())) for row in rows)

    def latest(self, thing: str = "") -> tuple[Observation, ...]:
        """Return the last valid and the last invalid sample of each source, of one thing or of all."""
        where, values = ("WHERE thing = ?", (thing,)) if thing else ("", ())
        sql = (
            f"SELECT thing, source, captured_at, valid, {SAMPLE} FROM latest {where} ORDER BY"
            " thing, source, captured_at"
        )
        return tuple(sample_of(row) for row in self._database.query(sql, values))

    def seen(self, at: float, thing: str = "") -> tuple[Observation, ...]:
        """Return the last valid sample of each source at or before a time, of one thing or of all."""
        sql, values = (
            (f"{SEEN} AND l.thing = ?", (at, at, at, thing)) if thing else (SEEN, (at, at, at))
        )
        return tuple(
            sample_of(row)
            for row in self._database.query(f"{sql} ORDER BY l.thing, l.source", values)
        )

    def trajectory(
        self, thing: str, since: float, until: float, *, source: str = "", every: float = 0.0
    ) -> Trajectory:
        """Return where a thing was between two times, by one source or by all."""
        sources = [
            sample.source for sample in self.seen(until, thing) if source in ("", sample.source)
        ]
        before = {sample.source: sample for sample in self.seen(since, thing)}
        parts = [
            _from_begin(before.get(name), since, self._path(thing, name, since, until, every))
            for name in sources
        ]
        return parts[0] if len(parts) == 1 else _by_time(np.concatenate([np.empty((0, 4)), *parts]))

    def events(
        self, since: float, until: float, *, thing: str = "", kind: str = "", cause: str = ""
    ) -> tuple[Happening, ...]:
        """Return what happened between two times, by time."""
        asked = [
            (column, value)
            for column, value in (("thing", thing), ("kind", kind), ("cause", cause))
            if value
        ]
        where = "".join(f" AND {column} = ?" for column, _ in asked)
        sql = (
            f"SELECT {EVENT} FROM event WHERE at >= ? AND at <= ?{where} ORDER BY at, kind, thing,"
            " source, cause"
        )
        return tuple(
            happening_of(row)
            for row in self._database.query(sql, (since, until, *(value for _, value in asked)))
        )

    def tidy(self, now: float) -> bool:
        """Thin and remove old samples in one short transaction; tell whether there is more to do."""
        return tidy_step(self._database, now, keep_days=self._keep_days)

    def close(self) -> None:
        """Let go of the database."""
        self._database.close()

    def _path(
        self, thing: str, source: str, since: float, until: float, every: float
    ) -> Trajectory:
        """Return the samples of one source; where it stood still, the begin and the end of that."""
        asked: Row = (thing, source, since, until)
        sql, values = PATH, asked
        if every > 0.0:
            bucket = self._database.dialect.floor.format(f"captured_at / {every!r}")
            sql, values = PATH + THINNED.format(bucket), asked * 2
        spans = self._database.numbers(f"{sql} ORDER BY captured_at", values, 5)
        path, stood = spans[:, (0, 2, 3, 4)], spans[:, 1] > spans[:, 0]
        if not stood.any():
            return path
        ends = np.column_stack([np.minimum(spans[stood, 1], until), spans[stood, 2:]])
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


def _stretch(sample: Observation, until: float) -> Row:
    return until, sample.thing, sample.source, sample.captured_at, until


def _latest(sample: Observation) -> Row:
    return (
        sample.thing,
        sample.source,
        int(is_valid(sample)),
        sample.captured_at,
        *row_of_sample(sample),
    )


def _by_time(path: Trajectory) -> Trajectory:
    return path[np.argsort(path[:, 0], kind="stable")]


def _from_begin(before: Observation | None, since: float, path: Trajectory) -> Trajectory:
    """Put in front where the thing stood at the begin, if its source said so just then."""
    if before is None or before.position is None or before.captured_at < since:
        return path
    return np.concatenate([np.array([(since, *before.position)]), path])
