"""Events, ways and flights as tables for other programs: CSV, or Parquet (extra ``lab``)."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Iterator, Mapping
from datetime import UTC, datetime
from pathlib import Path

from housefly.app.event_words import EventWords
from housefly.errors import ConfigError, MissingPartError
from housefly.hub.api.answers import EventAnswer
from housefly.messages import RoomEvent

Cell = str | float
CellType = type[str] | type[float] | type[int]
Row = tuple[Cell, ...]
EVENT_HEADINGS: Mapping[str, CellType] = {
    "time": str, "unix": float, "kind": str, "thing": str, "name": str, "cause": str,
    "cause_name": str, "confidence": float, "source": str, "words": str, "facts": str,
}  # fmt: skip
"""Columns of the table of events and their types; facts are JSON."""
WAY_HEADINGS: Mapping[str, CellType] = {
    "time": str, "unix": float, "thing": str, "name": str, "x_m": float, "y_m": float, "z_m": float,
}  # fmt: skip
"""Columns of the table of where things were."""
_FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""A text that begins so would be a formula to a spreadsheet."""


def event_rows(events: Iterable[RoomEvent], names: Mapping[str, str]) -> Iterator[Row]:
    """Yield a row for each event; ``names`` are those of things by id."""
    words = EventWords(names)
    for one in events:
        facts = dict(one.facts)
        told = EventAnswer(
            one.kind, one.thing, one.at, one.source, one.cause, one.confidence, facts
        )
        yield (
            *dated(one.at),
            one.kind,
            one.thing,
            names.get(one.thing, ""),
            one.cause,
            names.get(one.cause, ""),
            one.confidence,
            one.source,
            words.sentence(told),
            json.dumps(facts, ensure_ascii=False, sort_keys=True),
        )


def way_rows(thing: str, name: str, rows: Iterable[tuple[float, ...]]) -> Iterator[Row]:
    """Yield a row for each place of a thing: Unix time [s], x, y, z [m]."""
    for at, x, y, z in rows:
        yield *dated(at), thing, name, x, y, z


def write_table(file: Path, headings: Mapping[str, CellType], rows: Iterable[Row]) -> int:
    """Write a table and return its number of rows; the name's ending says the format.

    Raises:
        ConfigError: it is neither .csv nor .parquet, or cannot be written.
        MissingPartError: Parquet without pyarrow.
    """
    writers = {".csv": _write_csv, ".parquet": _write_parquet}
    if file.suffix.lower() not in writers:
        raise ConfigError(
            "FILE", f"is {file.name!r}; allowed: a name that ends in .csv or .parquet"
        )
    try:
        return writers[file.suffix.lower()](file, headings, rows)
    except OSError as error:
        raise ConfigError("FILE", f"cannot be written ({error.strerror})", str(file)) from error


def _write_csv(file: Path, headings: Mapping[str, CellType], rows: Iterable[Row]) -> int:
    count = 0
    with file.open("w", encoding="utf-8", newline="") as target:
        table = csv.writer(target)
        table.writerow(headings)
        for row in rows:
            table.writerow([_plain(cell) for cell in row])
            count += 1
    return count


def _write_parquet(file: Path, headings: Mapping[str, CellType], rows: Iterable[Row]) -> int:
    try:
        import pyarrow as pa
        import pyarrow.parquet as pq
    except ModuleNotFoundError as error:
        raise MissingPartError("pyarrow (Parquet)", "pip install 'housefly[lab]'") from error
    columns = list(zip(*rows, strict=True)) or [()] * len(headings)
    types = {str: pa.string(), float: pa.float64(), int: pa.int64()}
    arrays = [
        pa.array(column, types[kind], from_pandas=True)
        for column, kind in zip(columns, headings.values(), strict=True)
    ]
    pq.write_table(pa.table(arrays, names=list(headings)), file)
    return len(columns[0])


def dated(at: float) -> tuple[str, float]:
    """Return a Unix time [s] as ISO 8601 in UTC, and as it is."""
    return datetime.fromtimestamp(at, UTC).isoformat(timespec="milliseconds"), at


def _plain(cell: Cell) -> Cell:
    if cell != cell:  # no number: an empty cell, as in Parquet
        return ""
    is_formula = isinstance(cell, str) and cell.startswith(_FORMULA)
    return f"'{cell}" if is_formula else cell
