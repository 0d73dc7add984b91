"""Messages to bytes and back: CDR for the types in ``bus/msg``, exact to the last bit.

The fields of a dataclass and of its ``.msg`` text have the same names in the same order. What
differs is converted here: enums are numbered by the constants of the text, ``None`` is an empty
sequence, points and vectors are plain tuples. Each type has a function of its own that reads it and
one that writes it: a step passes here a hundred times a second, in five processes.
"""

from __future__ import annotations

import struct
from functools import cache
from typing import Any, TypeVar

from pydantic import TypeAdapter, ValidationError
from pydantic_core import PydanticSerializationError
from rosbags.typesys.store import Typestore

from housefly.bus.cdr_reader import cdr_reader
from housefly.bus.cdr_writer import cdr_writer
from housefly.bus.interfaces import type_store
from housefly.bus.topics import Encoding, Topic
from housefly.config.pydantic_words import words_of
from housefly.config.validation import dotted
from housefly.errors import WireError

_Message = TypeVar("_Message")
_HEADERS = {b"\x00\x00": ">", b"\x00\x01": "<"}
"""Plain CDR, big and little endian; two bytes of options follow."""
_HEADER = b"\x00\x01\x00\x00"
_MOST_LEFT = 3
"""So many bytes may follow a message [bytes]."""


def encoded(topic: Topic[_Message], message: _Message) -> bytes:
    """Return a message of a topic on the wire; raises WireError if a value does not fit."""
    if topic.encoding is Encoding.CDR:
        return to_cdr(message)
    try:
        return _json_adapter(topic).dump_json(message, warnings=False)
    except PydanticSerializationError as error:
        raise WireError(f"{topic.type.__name__} cannot be encoded: {error}") from error


def decoded(topic: Topic[_Message], data: bytes) -> _Message:
    """Return the message of a topic in bytes from the wire; raises WireError for anything else."""
    if topic.encoding is Encoding.CDR:
        return from_cdr(topic.type, data)
    try:
        message: _Message = _json_adapter(topic).validate_json(data)
    except ValidationError as error:
        first = error.errors(include_url=False, include_context=False, include_input=False)[0]
        raise WireError(
            f"not a {topic.type.__name__}: {dotted(first['loc'])}: {words_of(first)}"
        ) from error
    return message


@cache
def _json_adapter(topic: Topic[Any]) -> TypeAdapter[Any]:
    return TypeAdapter(topic.type)


def to_cdr(message: object) -> bytes:
    """Return the CDR bytes of a message; raises WireError if a value does not fit its field."""
    name = type(message).__name__
    try:
        parts: list[Any] = [_HEADER]
        cdr_writer(name)(message, parts)
        return b"".join(parts)
    except (
        struct.error,
        UnicodeEncodeError,
        OverflowError,
        TypeError,
        AttributeError,
        ValueError,
        KeyError,
    ) as error:
        raise WireError(f"{name} cannot be encoded: {error}") from error


def from_cdr(kind: type[_Message], data: bytes, store: Typestore | None = None) -> _Message:
    """Return the message in CDR bytes; raises WireError for anything else.

    Args:
        kind: of the message.
        data: its bytes.
        store: the types it was written with, ours if not given; a field that they lack takes its
            default.
    """
    name = kind.__name__
    try:
        order = _HEADERS[data[:2]]
        body = data[len(_HEADER) :]
        message: _Message
        message, end = cdr_reader(name, store or type_store(), order)(body, len(body))
        if end + _MOST_LEFT < len(body):
            raise ValueError(f"{len(body) - end} bytes follow it")
    except (
        struct.error,
        ValueError,
        IndexError,
        KeyError,
        TypeError,
        OverflowError,
        MemoryError,
    ) as error:
        raise WireError(f"not a {name}: {error}") from error
    return message


def check_types(kind: type[Any], store: Typestore) -> None:
    """Raise WireError when messages written with these types cannot be read as ours."""
    try:
        cdr_reader(kind.__name__, store, "<")
    except KeyError as error:
        raise WireError(f"{kind.__name__}: {error} is not defined") from error
