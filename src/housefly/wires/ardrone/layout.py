"""Packed little-endian structures as frozen dataclasses: each field names its own wire format.

``wire("3f")`` declares a tuple of three singles, ``wire("I")`` one unsigned integer; formats are
those of ``struct``.
"""

from __future__ import annotations

import re
import struct
from dataclasses import field, fields
from typing import Any, NamedTuple, Self

from housefly.errors import WireError

_FORMAT = re.compile(r"(\d*)([bBhHiIfd])")


def wire(form: str) -> Any:
    """Declare a dataclass field with its ``struct`` format; its default is zero."""
    found = _FORMAT.fullmatch(form)
    if found is None:
        raise TypeError(f"{form!r} is not one format letter with an optional count")
    zero: float = 0.0 if found[2] in "fd" else 0
    return field(default=(zero,) * int(found[1]) if found[1] else zero, metadata={"wire": form})


class _Plan(NamedTuple):
    codec: struct.Struct
    cuts: tuple[tuple[str, int, int], ...]
    """Name, start and count of each field among the unpacked values; count 0 is a plain value."""


_plans: dict[type, _Plan] = {}


def _plan(kind: type) -> _Plan:
    """Return the compiled layout of a structure class, made once."""
    known = _plans.get(kind)
    if known is None:
        known = _plans[kind] = _compile(kind)
    return known


def _compile(kind: type) -> _Plan:
    form, at = "<", 0
    cuts: list[tuple[str, int, int]] = []
    for item in fields(kind):
        letter: str = item.metadata["wire"]
        form += letter
        count = int(letter[:-1] or 0)
        cuts.append((item.name, at, count))
        at += count or 1
    return _Plan(struct.Struct(form), tuple(cuts))


class Structure:
    """Base of packed structures; subclasses are frozen, slotted dataclasses of ``wire`` fields."""

    __slots__ = ()

    @classmethod
    def size(cls) -> int:
        """Return the number of bytes on the wire."""
        return _plan(cls).codec.size

    @classmethod
    def decode(cls, payload: bytes | memoryview) -> Self:
        """Read the structure; raises WireError when the payload has another size."""
        codec, cuts = _plan(cls)
        if len(payload) != codec.size:
            raise WireError(f"{cls.__name__} takes {codec.size} bytes, got {len(payload)}")
        flat = codec.unpack(payload)
        return cls(*(flat[at : at + count] if count else flat[at] for _, at, count in cuts))

    def encode(self) -> bytes:
        """Return the structure's bytes; raises WireError when a value does not fit its field."""
        codec, cuts = _plan(type(self))
        flat: list[float] = []
        for name, _, count in cuts:
            value = getattr(self, name)
            flat.extend(value) if count else flat.append(value)
        try:
            return codec.pack(*flat)
        except (struct.error, OverflowError) as error:
            raise WireError(
                f"{type(self).__name__} has a value that does not fit: {error}"
            ) from error
