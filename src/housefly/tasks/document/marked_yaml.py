"""YAML with the line of every value: one document, no anchors, aliases or tags, bounded.

Plain words stay words: ``on``, ``off``, ``yes`` and ``no`` are text, only ``true`` and ``false``
are flags (YAML 1.2), because rooms have lamps that are ``on``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import yaml

from housefly.errors import TaskError
from housefly.tasks.api.values import ReasonCode

SIZE_MAX = 64_000
"""Longest document [characters]."""
DEPTH_MAX = 24
"""Lists and mappings inside each other."""
VALUES_MAX = 4_000
"""Values in one document."""
TEXT_MAX = 1_000
"""Longest single text [characters]."""
_FAST_LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
"""libyaml reads ten times as fast, and says less of what is wrong."""
_FLAGS = {"true": True, "false": False}
_NOTHING = frozenset({"", "~", "null"})
_NUMBER = re.compile(r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d{1,3})?")


@dataclass(frozen=True, slots=True)
class MarkedValue:
    """One value with its line, and of a single value the text as it was written."""

    line: int
    value: str | float | bool | tuple[MarkedValue, ...] | dict[str, MarkedValue] | None
    text: str = ""


class _Reader:
    def __init__(self, text: str, source: str, loader: Any) -> None:
        self._source = source
        self._events: Iterator[yaml.Event] = yaml.parse(text, Loader=loader)
        self._count = 0

    def document(self) -> MarkedValue:
        self._next()
        if isinstance(self._next(), yaml.StreamEndEvent):
            raise self._error(1, "there is nothing in it")
        value = self._value(self._next(), 0)
        self._next()
        after = self._next()
        if not isinstance(after, yaml.StreamEndEvent):
            raise self._error(_line(after), "a second document begins; one file holds one")
        return value

    def _next(self) -> yaml.Event:
        return next(self._events)

    def _value(self, event: yaml.Event, depth: int) -> MarkedValue:
        line = _line(event)
        self._count += 1
        if self._count > VALUES_MAX:
            raise self._error(line, f"more than {VALUES_MAX} values; split it into several tasks")
        if depth > DEPTH_MAX:
            raise self._error(line, f"nested more than {DEPTH_MAX} deep")
        if isinstance(event, yaml.AliasEvent) or getattr(event, "anchor", None):
            raise self._error(line, "anchors (&) and aliases (*) are not allowed; write it out")
        if getattr(event, "tag", None) not in (None, "!"):
            raise self._error(line, "tags (!) are not allowed; values are text, numbers, flags")
        if isinstance(event, yaml.ScalarEvent):
            return MarkedValue(line, self._scalar(event, line), event.value)
        if isinstance(event, yaml.SequenceStartEvent):
            return MarkedValue(line, tuple(self._items(depth)))
        return MarkedValue(line, self._mapping(depth))

    def _items(self, depth: int) -> Iterator[MarkedValue]:
        while not isinstance(event := self._next(), yaml.SequenceEndEvent):
            yield self._value(event, depth + 1)

    def _mapping(self, depth: int) -> dict[str, MarkedValue]:
        found: dict[str, MarkedValue] = {}
        while not isinstance(event := self._next(), yaml.MappingEndEvent):
            key = self._key(event)
            if key in found:
                raise self._error(_line(event), f"{key!r} stands here twice")
            # A value counts as standing on the line of its key.
            found[key] = replace(self._value(self._next(), depth + 1), line=_line(event))
        return found

    def _key(self, event: yaml.Event) -> str:
        if not isinstance(event, yaml.ScalarEvent) or event.tag or event.anchor:
            raise self._error(_line(event), "a key must be a plain word")
        return str(event.value)[:TEXT_MAX]

    def _scalar(self, event: yaml.ScalarEvent, line: int) -> str | float | bool | None:
        text = event.value
        if len(text) > TEXT_MAX:
            raise self._error(line, f"a text of {len(text)} characters; allowed: {TEXT_MAX}")
        if event.style:  # libyaml says "" of a plain one
            return text
        if text in _NOTHING:
            return None
        if text in _FLAGS:
            return _FLAGS[text]
        return float(text) if _NUMBER.fullmatch(text) else text

    def _error(self, line: int, problem: str) -> TaskError:
        return document_error(self._source, line, problem)


def read_marked_yaml(text: str, source: str = "") -> MarkedValue:
    """Return what a YAML text holds.

    Args:
        text: at most SIZE_MAX characters.
        source: name of its file, for messages.

    Raises:
        TaskError: BAD_PARAMETER; names file, line, and what is allowed.
    """
    if len(text) > SIZE_MAX:
        raise document_error(source, 1, f"{len(text)} characters; allowed: {SIZE_MAX}")
    try:
        with suppress(yaml.YAMLError):
            return _Reader(text, source, _FAST_LOADER).document()
        return _Reader(text, source, yaml.SafeLoader).document()
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
        problem = getattr(error, "problem", None) or getattr(error, "reason", None) or "unreadable"
        line = mark.line + 1 if mark else 1
        raise document_error(source, line, f"this is no YAML: {problem}") from error
    except (ValueError, OverflowError) as error:  # an escaped letter beyond Unicode
        raise document_error(source, 1, f"this is no YAML: {error}") from error


def document_error(source: str, line: int, problem: str) -> TaskError:
    """Return the error for one line of a document."""
    where = f"{source}, line {line}" if source else f"line {line}"
    return TaskError(f"{where}: {problem}", ReasonCode.BAD_PARAMETER.value)


def _line(event: yaml.Event) -> int:
    mark = event.start_mark
    return 1 if mark is None else int(mark.line) + 1
