"""Makes functions that write messages in CDR."""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

from rosbags.interfaces import Nodetype
from rosbags.typesys.store import Typestore

from housefly import messages
from housefly.bus.cdr_fields import FACT, TUPLES, WORDS, EnumCodes, fact_fields, fields_of
from housefly.bus.cdr_source import BASE_CODES, CdrSource
from housefly.bus.interfaces import type_store
from housefly.messages.words import flat

_ZERO = r"b'\0'"
"""The end of a text, in the source that is made."""


@cache
def cdr_writer(name: str) -> Callable[[Any, list[Any]], None]:
    """Return a function that appends the parts of a message to a list."""
    source = CdrSource("<", lambda s, _, values: f"parts.append({s}.pack({', '.join(values)}))")
    source.line("pos = 0")
    _Writing(source, type_store()).record(name, "message")
    return source.function("message, parts", "None")


class _Writing:
    """Makes the lines that write; each method is given the value as an expression."""

    def __init__(self, source: CdrSource, store: Typestore) -> None:
        self._source, self._store = source, store

    def record(self, name: str, value: str) -> None:
        """Write a dataclass."""
        record = self._named_value(value)
        for field, description, enum in fields_of(getattr(messages, name), self._store):
            self._field(description, enum, f"{record}.{field}")

    def _field(self, description: Any, enum: EnumCodes | None, value: str) -> None:
        shape, content = description
        codes = enum and self._source.constant(enum)
        if shape == Nodetype.NAME:
            self._named(content, value)
        elif shape == Nodetype.BASE:
            self._base(content[0], f"{codes}[{value}]" if codes else value)
        elif content[1] == 1:
            self._optional(content[0], value)
        else:
            numbers = f"bytes(map({codes}.__getitem__, {value}))" if codes else value
            self._sequence(content[0], numbers)

    def _named(self, name: str, value: str) -> None:
        if name == WORDS:
            _, of = self._store.fielddefs[name][1][0]
            self._field(of, None, f"{self._source.constant(flat)}({value})")
            return
        order = TUPLES.get(name)
        if order is None:
            self.record(name.rsplit("/", 1)[1], value)
            return
        if name == FACT:
            value = f"{self._source.constant(fact_fields)}({value})"
        parts = {field: self._source.name() for field in order}
        self._source.line(f"{', '.join(parts.values())} = {value}")
        for field, of in self._store.fielddefs[name][1]:
            self._field(of, None, parts[field])

    def _base(self, name: str, value: str) -> None:
        source = self._source
        if name != "string":
            source.number(BASE_CODES[name], value)
            return
        text = self._named_value(f"{value}.encode()")
        source.number("I", f"len({text}) + 1")
        source.flush()
        source.line(f"parts += {text}, {_ZERO}")
        source.line(f"pos += len({text}) + 1")

    def _optional(self, element: Any, value: str) -> None:
        one = self._named_value(value)
        self._source.number("I", f"{one} is not None")
        self._source.flush()
        with self._source.block(f"if {one} is not None:"):
            self._field(element, None, one)

    def _sequence(self, element: Any, value: str) -> None:
        source = self._source
        shape, content = element
        if shape == Nodetype.BASE and content[0] in _PLAIN_PARTS:
            number, part = source.name(), source.name()
            made = source.constant(_PLAIN_PARTS[content[0]])
            source.line(f"{number}, {part} = {made}({value})")
            source.number("I", number)
            source.flush()
            if content[0] == "float64":
                source.line(f"if {number}: {part} = bytes(-pos % 8) + {part}")
            source.line(f"parts.append({part})")
            source.line(f"pos += len({part})")
            return
        several, one = self._named_value(value), source.name()
        source.number("I", f"len({several})")
        source.flush()
        with source.block(f"for {one} in {several}:"):
            self._field(element, None, one)

    def _named_value(self, value: str) -> str:
        name = self._source.name()
        self._source.line(f"{name} = {value}")
        return name


def _bytes_part(data: bytes) -> tuple[int, bytes]:
    return len(data), data


def _points_part(points: Sequence[tuple[float, float]]) -> tuple[int, bytes]:
    numbers = [number for x, y in points for number in (x, y)]
    return len(numbers), struct.pack(f"<{len(numbers)}d", *numbers)


_PLAIN_PARTS: dict[str, Callable[[Any], tuple[int, bytes]]] = {
    "uint8": _bytes_part,
    "float64": _points_part,
}
"""How many numbers such a sequence has, and its bytes."""
