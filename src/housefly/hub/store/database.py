"""What the store needs from a database, and how the two SQL dialects differ."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

Row = tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class Dialect:
    """How the SQL of one database differs from another.

    Attributes:
        clustered: clause that stores a table in the order of its key.
        floor: the integer part of a positive number, with {} for the number.
        lock_schema: statement that keeps other processes from migrating at the same time, "" where
            a transaction does so anyway.
    """

    clustered: str
    floor: str
    lock_schema: str


class Database(Protocol):
    """A connection; every problem is a StoreError in words. SQL uses ``?`` for values."""

    @property
    def dialect(self) -> Dialect:
        """Its SQL dialect."""
        ...

    @property
    def notices(self) -> tuple[str, ...]:
        """What the user should know about how it was opened."""
        ...

    def query(self, sql: str, values: Sequence[object] = ()) -> Iterable[Row]:
        """Run one statement and return its rows."""
        ...

    def numbers(self, sql: str, values: Sequence[object], columns: int) -> NDArray[np.float64]:
        """Run one statement with numeric columns and return its rows, shape (n, columns)."""
        ...

    def many(self, sql: str, rows: Sequence[Row]) -> None:
        """Run one statement for each row of values."""
        ...

    def transaction(self) -> AbstractContextManager[None]:
        """Keep all statements of the block or none; one writer at a time."""
        ...

    def scrub(self) -> None:
        """Write the file anew, without the remains of deleted rows, where it is a file."""
        ...

    def close(self) -> None:
        """Close the connection."""
        ...
