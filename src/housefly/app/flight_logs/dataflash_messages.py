"""The messages of ArduPilot's dataflash log, which describes itself (LogStructure.h): pure."""

from __future__ import annotations

import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

DATAFLASH_MAGIC = b"\xa3\x95\x80"
_HEAD = DATAFLASH_MAGIC[:2]
_FMT = 128
_FMT_LAYOUT = struct.Struct("<BB4s16s64s")
_HEAD_SIZE = 3
_LAYOUTS: Mapping[str, str] = {
    "a": "64s", "b": "b", "B": "B", "h": "h", "H": "H", "i": "i", "I": "I", "f": "f", "d": "d",
    "n": "4s", "N": "16s", "Z": "64s", "c": "h", "C": "H", "e": "i", "E": "I", "L": "i",
    "M": "B", "q": "q", "Q": "Q", "g": "e",
}  # fmt: skip
_HUNDREDTHS = frozenset("cCeE")
_DEGREES_E7 = "L"


@dataclass(frozen=True, slots=True)
class DataflashMessage:
    """One message.

    Attributes:
        name: "ATT", "XKF1" ...
        fields: by name; texts are str.
        end: where it ends in the file [bytes].
        skipped: bytes before it that could not be read.
    """

    name: str
    fields: Mapping[str, float | str]
    end: int
    skipped: int = 0


@dataclass(frozen=True, slots=True)
class _Form:
    name: str
    layout: struct.Struct
    codes: str
    columns: tuple[str, ...]

    def fields(self, body: bytes) -> Mapping[str, float | str]:
        values = self.layout.unpack(body)
        return dict(zip(self.columns, map(_value, self.codes, values), strict=True))


def dataflash_messages(data: bytes) -> Iterator[DataflashMessage]:
    """Yield the messages of a log; what is damaged is skipped up to the next one that is whole.

    A log that is whole is one of which each message begins where the one before it ends.
    """
    forms: dict[int, _Form] = {}
    at = whole_until = 0
    while at + _HEAD_SIZE <= len(data):
        kind = data[at + 2]
        form = forms.get(kind)
        size = _FMT_LAYOUT.size if kind == _FMT else form.layout.size if form else None
        end = at + _HEAD_SIZE + (size or 0)
        if data[at : at + 2] != _HEAD or size is None or end > len(data):
            at = data.find(_HEAD, at + 1)
            if at < 0:
                return
            continue
        body = data[at + _HEAD_SIZE : end]
        if kind == _FMT:
            _learn(forms, body)
        elif form is not None:
            skipped = at - whole_until
            yield DataflashMessage(form.name, form.fields(body), end, skipped)
        at = whole_until = end


def _learn(forms: dict[int, _Form], body: bytes) -> None:
    """Keep the form that a FMT message describes; one that makes no sense is left out."""
    kind, length, name, codes, columns = _FMT_LAYOUT.unpack(body)
    form, named = _text(codes), tuple(_text(columns).split(","))
    if kind == _FMT or not form or not set(form) <= _LAYOUTS.keys() or len(form) != len(named):
        return
    layout = struct.Struct("<" + "".join(_LAYOUTS[code] for code in form))
    if layout.size + _HEAD_SIZE == length:
        forms[kind] = _Form(_text(name), layout, form, named)


def _value(code: str, value: float | bytes) -> float | str:
    if isinstance(value, bytes):
        return _text(value)
    if code in _HUNDREDTHS:
        return value / 100.0
    return value / 1e7 if code == _DEGREES_E7 else value


def _text(told: bytes) -> str:
    return told.split(b"\0")[0].decode("latin-1")
