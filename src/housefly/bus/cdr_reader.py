"""Makes functions that read messages from CDR."""

from __future__ import annotations

import struct
from collections.abc import Callable
from enum import Enum
from functools import cache
from typing import Any

from rosbags.interfaces import Nodetype
from rosbags.typesys.store import Typestore

from housefly import messages
from housefly.bus.cdr_fields import (
    FACT,
    TUPLES,
    WORDS,
    EnumCodes,
    fact_of,
    fields_of,
    was_plain_text,
)
from housefly.bus.cdr_source import BASE_CODES, CdrSource
from housefly.messages.words import literal, unflattened


@cache
def cdr_reader(name: str, store: Typestore, order: str) -> Callable[[bytes, int], tuple[Any, int]]:
    """Return a function of a message's bytes and their number: the message, and where it ends."""
    source = CdrSource(order, lambda s, run, _: f"r{run} = {s}.unpack_from(data, pos)")
    source.line("pos = 0")
    return source.function("data, size", f"{_Reading(source, store, order).record(name)}, pos")


class _Reading:
    """Makes the lines that read; each method returns the value as an expression."""

    def __init__(self, source: CdrSource, store: Typestore, order: str) -> None:
        self._source, self._store, self._order = source, store, order

    def record(self, name: str) -> str:
        """Read a dataclass."""
        kind = getattr(messages, name)
        read = [
            f"{field}={self._worded(kind, field, description, self._field(description, enum))}"
            for field, description, enum in fields_of(kind, self._store)
        ]
        return f"{self._source.constant(kind)}({', '.join(read)})"

    def _worded(self, kind: type[Any], field: str, description: Any, read: str) -> str:
        """Return what was read; as words where an older version wrote a text for them."""
        if not was_plain_text(kind, field, description):
            return read
        made = self._source.constant(literal)
        return (
            f"{made}({read})" if description[0] == Nodetype.BASE else f"tuple(map({made}, {read}))"
        )

    def _field(self, description: Any, enum: EnumCodes | None) -> str:
        shape, content = description
        members = enum and self._source.constant(
            _Members((code, member) for member, code in enum.items())
        )
        if shape == Nodetype.NAME:
            return self._named(content)
        if shape == Nodetype.BASE:
            read = self._base(content[0])
            return f"{members}[{read}]" if members else read
        element, limit = content
        length = self._source.number("I")
        self._source.flush()
        if limit == 1:
            return self._optional(element, length)
        read = self._sequence(element, length)
        return f"tuple(map({members}.__getitem__, {read}))" if members else read

    def _named(self, name: str) -> str:
        if name == WORDS:
            _, parts = self._store.fielddefs[name][1][0]
            return f"{self._source.constant(unflattened)}({self._field(parts, None)})"
        order = TUPLES.get(name)
        if order is None:
            return self.record(name.rsplit("/", 1)[1])
        read = {field: self._field(of, None) for field, of in self._store.fielddefs[name][1]}
        made = self._source.constant(fact_of) if name == FACT else ""
        return f"{made}({', '.join(read[field] for field in order)})"

    def _base(self, name: str) -> str:
        source = self._source
        if name != "string":
            return source.number(BASE_CODES[name])
        length, text = source.number("I"), source.name()
        source.flush()
        source.line(f"{text}, pos = {source.constant(_text)}(data, pos, {length})")
        return text

    def _optional(self, element: Any, length: str) -> str:
        source, value = self._source, self._source.name()
        source.line(f"{value} = None")
        with source.block(f"if {length}:"):
            source.line(f"if {length} > 1: raise ValueError(f'{{{length}}} values {_AT_MOST}')")
            read = self._field(element, None)
            source.flush()
            source.line(f"{value} = {read}")
        return value

    def _sequence(self, element: Any, length: str) -> str:
        source, value = self._source, self._source.name()
        source.line(f"if {length} > size - pos: raise ValueError('a sequence without an end')")
        shape, content = element
        if shape == Nodetype.BASE and (whole := _PLAIN_READERS.get(content[0])):
            source.line(
                f"{value}, pos = {source.constant(whole)}(data, pos, {length}, {self._order!r})"
            )
            return value
        source.line(f"{value} = []")
        with source.block(f"for _ in range({length}):"):
            read = self._field(element, None)
            source.flush()
            source.line(f"{value}.append({read})")
        return f"tuple({value})"


class _Members(dict[int | str, Enum]):
    """Members of an enum by their codes; where there is an OTHER, it stands for unknown ones."""

    def __missing__(self, code: int | str) -> Enum:
        kind = type(next(iter(self.values())))
        if "OTHER" not in kind.__members__:
            raise KeyError(code)
        return kind["OTHER"]


_AT_MOST = "where at most one is allowed"


def _text(data: bytes, pos: int, length: int) -> tuple[str, int]:
    """Return a text of so many bytes, its zero included, and where it ends."""
    end = pos + length
    if length < 1 or end > len(data) or data[end - 1]:
        raise ValueError("a text without an end")
    return data[pos : end - 1].decode(), end


def _bytes_read(data: bytes, pos: int, length: int, order: str) -> tuple[bytes, int]:
    return data[pos : pos + length], pos + length


def _points_read(
    data: bytes, pos: int, length: int, order: str
) -> tuple[tuple[tuple[float, float], ...], int]:
    pos += -pos % 8 if length else 0
    numbers = iter(struct.unpack_from(f"{order}{length}d", data, pos))
    return tuple(zip(numbers, numbers, strict=True)), pos + 8 * length


_PLAIN_READERS: dict[str, Callable[..., tuple[Any, int]]] = {
    "uint8": _bytes_read,
    "float64": _points_read,
}
"""Sequences that are not read one by one: bytes, and points as x, y, x, y, ..."""
