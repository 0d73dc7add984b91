"""CDR encoding of the types in ``bus/msg``, exact to the last bit.

The fields of a dataclass and of its ``.msg`` text have the same names in the same order. What
differs is converted here: enums are numbered by the constants of the text, ``None`` is an empty
sequence, points and vectors are plain tuples.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import MISSING, fields
from enum import Enum
from functools import cache, lru_cache
from typing import Any, TypeVar, get_args, get_type_hints

import numpy as np
from rosbags.interfaces import Nodetype
from rosbags.serde import SerdeError
from rosbags.typesys.store import Typestore

from housefly import messages
from housefly.bus.interfaces import ros_name, type_store
from housefly.errors import WireError
from housefly.geometry import Vec2

_Message = TypeVar("_Message")
_Convert = Callable[[Any], Any]
_Conversion = tuple[_Convert, _Convert]
"""Conversion to the wire, and back."""


def to_cdr(message: object) -> bytes:
    """Return the CDR bytes of a message; raises WireError if a value does not fit its field."""
    name = type(message).__name__
    try:
        to_wire, _ = _record(name, type_store())
        return bytes(type_store().serialize_cdr(to_wire(message), ros_name(name)))
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
    store = store or type_store()
    try:
        _, from_wire = _record(name, store)
        message: _Message = from_wire(store.deserialize_cdr(data, ros_name(name)))
    except (
        SerdeError,
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
        _record(kind.__name__, store)
    except KeyError as error:
        raise WireError(f"{kind.__name__}: {error} is not defined") from error


def _same(value: Any) -> Any:
    return value


@cache
def _standard(name: str, store: Typestore) -> _Conversion | None:
    """Convert the standard types that our messages hold as tuples or as a Pose."""
    wire = store.types[name]
    if name in ("geometry_msgs/msg/Point", "geometry_msgs/msg/Vector3"):
        return lambda v: wire(*v), lambda w: (w.x, w.y, w.z)
    if name == ros_name("Point2"):
        return lambda v: wire(*v), lambda w: (w.x, w.y)
    if name == "geometry_msgs/msg/Quaternion":
        return lambda q: wire(q[1], q[2], q[3], q[0]), lambda w: (w.w, w.x, w.y, w.z)
    return None


def _nested(name: str, store: Typestore) -> _Conversion:
    return _standard(name, store) or _record(name.rsplit("/", 1)[1], store)


@cache
def _record(name: str, store: Typestore) -> _Conversion:
    """Convert a whole dataclass, field by field."""
    kind = getattr(messages, name)
    wire_name = "geometry_msgs/msg/Pose" if name == "Pose" else ros_name(name)
    constants, written = store.fielddefs[wire_name]
    hints = get_type_hints(kind)
    _check_fields(kind, [field for field, _ in written])
    numbers = {constant: int(value) for constant, _, value in constants}
    wire = store.types[wire_name]
    pairs = [
        (field, *_field(field, description, hints[field], numbers, store))
        for field, description in written
    ]
    out = [(field, to_wire) for field, to_wire, _ in pairs]
    back = [(field, from_wire) for field, _, from_wire in pairs]

    def to_wire(message: Any) -> Any:
        return wire(*[convert(getattr(message, field)) for field, convert in out])

    def from_wire(value: Any) -> Any:
        return kind(**{field: convert(getattr(value, field)) for field, convert in back})

    return to_wire, from_wire


def _check_fields(kind: type[Any], written: list[str]) -> None:
    """Raise WireError when a message cannot be made of the fields that were written."""
    ours = {field.name: field for field in fields(kind)}
    unknown = [name for name in written if name not in ours]
    lacking = [
        name
        for name, field in ours.items()
        if name not in written and field.default is MISSING and field.default_factory is MISSING
    ]
    if unknown or lacking:
        raise WireError(f"{kind.__name__}: other fields: {', '.join(unknown + lacking)}")


def _field(
    name: str, description: Any, hint: Any, numbers: dict[str, int], store: Typestore
) -> _Conversion:
    shape, content = description
    if shape == Nodetype.BASE:
        return (
            _enumerated(name, hint, numbers)
            if isinstance(hint, type) and issubclass(hint, Enum)
            else (_same, _same)
        )
    if shape == Nodetype.NAME:
        return _nested(content, store)
    (element, element_content), limit = content
    if element == Nodetype.NAME:
        return (
            _optional(*_nested(element_content, store))
            if limit == 1
            else _tuple(*_nested(element_content, store))
        )
    if limit == 1:
        return _OPTIONAL_NUMBER
    member = next(iter(get_args(hint)), None)
    if isinstance(member, type) and issubclass(member, Enum):
        return _enumerated_sequence(name, member, numbers, element_content[0])
    return _PLAIN_SEQUENCES[element_content[0]]


def _enumerated(name: str, kind: type[Enum], numbers: dict[str, int]) -> _Conversion:
    names = {member: f"{name.upper()}_{member.name}" for member in kind}
    code = {member: numbers[text] for member, text in names.items() if text in numbers}
    member_of = {number: member for member, number in code.items()}
    return code.__getitem__, member_of.__getitem__


def _enumerated_sequence(
    name: str, kind: type[Enum], numbers: dict[str, int], element: str
) -> _Conversion:
    """Convert a tuple of enum members; older recordings hold their values as text."""
    if element == "string":
        return lambda members: [member.value for member in members], lambda found: tuple(
            map(kind, found)
        )
    code, member_of = _enumerated(name, kind, numbers)
    return (
        lambda members: np.array([code(member) for member in members], dtype=np.uint8),
        lambda found: tuple(member_of(number) for number in found.tolist()),
    )


def _optional(to_wire: _Convert, from_wire: _Convert) -> _Conversion:
    def back(found: Any) -> Any:
        if len(found) > 1:
            raise ValueError(f"{len(found)} values where at most one is allowed")
        return from_wire(found[0]) if len(found) else None

    return lambda value: [] if value is None else [to_wire(value)], back


_OPTIONAL_NUMBER: _Conversion = (
    lambda value: np.array([] if value is None else [value], dtype=np.float64),
    _optional(_same, float)[1],
)


def _tuple(to_wire: _Convert, from_wire: _Convert) -> _Conversion:
    return lambda values: [to_wire(value) for value in values], lambda found: tuple(
        [from_wire(value) for value in found]
    )


@lru_cache(maxsize=4)
def _flat(points: tuple[Vec2, ...]) -> Any:
    return np.array(points, dtype=np.float64).reshape(
        -1
    )  # the same path comes a hundred times a second: hence the cache


def _points(flat: Any) -> tuple[Vec2, ...]:
    numbers = iter(flat.tolist())
    return tuple(zip(numbers, numbers, strict=True))


_PLAIN_SEQUENCES: dict[str, _Conversion] = {
    "string": (_same, tuple),
    "uint8": (lambda data: np.frombuffer(data, dtype=np.uint8), lambda found: found.tobytes()),
    "float64": (_flat, _points),
}
