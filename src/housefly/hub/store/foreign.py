"""Tells a store of Housefly from another program's file, before anything is written to it."""

from __future__ import annotations

import re
import sqlite3
from contextlib import closing
from pathlib import Path

from housefly.errors import StoreError
from housefly.hub.store.schema import MIGRATIONS

_MAGIC = b"SQLite format 3\0"
_TABLE = re.compile(r"CREATE TABLE (\w+)")
_OURS = {"schema"} | {
    found[1] for step in MIGRATIONS for statement in step if (found := _TABLE.match(statement))
}
_REMEDY = "it stays as it is: move it away, or choose another hub.store"
_MOST_SHOWN = 3


def refuse_foreign_file(path: Path) -> None:
    """Raise StoreError for a file that is no SQLite database, or another program's.

    A missing or empty file may become a store; what cannot be read is left to SQLite.
    """
    try:
        with path.open("rb") as file:
            head = file.read(len(_MAGIC))
    except OSError:
        return
    if not head:
        return
    if head != _MAGIC:
        raise StoreError(f"{path} is no database of Housefly, or its beginning is damaged", _REMEDY)
    try:
        with closing(sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)) as found:
            rows = found.execute(
                "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite_%'"
            )
            tables = {str(name) for (name,) in rows}
    except sqlite3.Error:
        return
    foreign = sorted(tables - _OURS)
    if foreign and not tables >= _OURS:
        shown = ", ".join(foreign[:_MOST_SHOWN]) + (" ..." if len(foreign) > _MOST_SHOWN else "")
        raise StoreError(f"{path} is another program's database (it holds {shown})", _REMEDY)
