"""What a fuzz target is: a parser of bytes from outside, and the errors that it documents."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from housefly.errors import HouseflyError

HUGE = b"1" + b"0" * 400
"""A whole number that no float holds."""
DEEP = b"[" * 2000
"""Nested deeper than a parser may follow."""

Parse = Callable[[bytes], object]


@dataclass(frozen=True, slots=True)
class FuzzTarget:
    """One parser.

    Attributes:
        parse: reads the bytes as the product does; keeps nothing from one input to the next.
        seeds: good inputs to begin with.
        errors: all that it may raise.
        length_max: longest input that is tried [bytes].
        words: tokens of the format, for the mutator.
    """

    parse: Parse
    seeds: Callable[[], Iterable[bytes]]
    errors: tuple[type[HouseflyError], ...] = ()
    length_max: int = 2048
    words: tuple[bytes, ...] = ()

    def run(self, data: bytes) -> None:
        """Parse; anything but a documented error goes through."""
        with suppress(*self.errors):
            self.parse(data)


def pieces(data: bytes, size: int) -> Iterator[bytes]:
    """Cut what a stream delivers into pieces."""
    return (data[at : at + size] for at in range(0, len(data), size))


def split(data: bytes, mark: bytes = b"\n") -> tuple[bytes, bytes]:
    """Return what is before and after the first mark."""
    head, _, rest = data.partition(mark)
    return head, rest


@cache
def scratch() -> Path:
    """Return a folder of this process, in memory where there is such a place."""
    memory = Path("/dev/shm")
    holder = tempfile.TemporaryDirectory(
        prefix="housefly-fuzz-", dir=memory if memory.is_dir() else None
    )
    _holders.append(holder)
    return Path(holder.name)


_holders: list[tempfile.TemporaryDirectory[str]] = []


@contextmanager
def as_file(data: bytes, name: str) -> Iterator[Path]:
    """Offer the bytes as a file."""
    path = scratch() / name
    path.write_bytes(data)
    try:
        yield path
    finally:
        path.unlink(missing_ok=True)
