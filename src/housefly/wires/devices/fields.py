"""Keys of a device's JSON as table rows: each checks its value for type, range and unit."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol

from housefly.errors import WireError

ID_PATTERN = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.:-]{0,63}")
"""What ids of devices, things and tags look like."""
_SHOWN = 60

_Value = float | bool | str | tuple["JsonRecord", ...]


class JsonField(Protocol):
    """One key of a table of keys."""

    @property
    def required(self) -> bool:
        """Whether the key must be there."""
        ...

    def check(self, value: object, where: str) -> _Value:
        """Return the checked value; raises WireError naming place, value and range."""
        ...


JsonSpec = Mapping[str, JsonField]


@dataclass(frozen=True, slots=True)
class JsonRecord:
    """A checked JSON object.

    Attributes:
        values: of the known keys that were there.
        unknown: the other keys, those of objects inside it too.
    """

    values: Mapping[str, _Value] = field(default_factory=dict)
    unknown: tuple[str, ...] = ()

    def number(self, key: str) -> float:
        """Return a required number."""
        return float(self.values[key])  # type: ignore[arg-type]  # the table has checked it

    def number_or_none(self, key: str) -> float | None:
        """Return an optional number."""
        return self.number(key) if key in self.values else None

    def flag(self, key: str) -> bool:
        """Return a truth value; False when the key is absent."""
        return bool(self.values.get(key, False))

    def word(self, key: str) -> str:
        """Return a text; empty when the key is absent."""
        return str(self.values.get(key, ""))

    def rows(self, key: str) -> tuple[JsonRecord, ...]:
        """Return a list of objects; empty when the key is absent."""
        value = self.values.get(key, ())
        return value if isinstance(value, tuple) else ()


@dataclass(frozen=True, slots=True)
class NumberField:
    """A finite number in an inclusive range."""

    low: float
    high: float
    unit: str = ""
    required: bool = True

    def check(self, value: object, where: str) -> float:
        """Return the number."""
        if (
            isinstance(value, bool)
            or not isinstance(value, int | float)
            or not self.low <= value <= self.high
        ):
            raise value_refusal(
                where, value, f"a number from {self.low:g} to {self.high:g} {self.unit}".rstrip()
            )
        return float(value)


@dataclass(frozen=True, slots=True)
class FlagField:
    """A truth value."""

    required: bool = True

    def check(self, value: object, where: str) -> bool:
        """Return the truth value."""
        if not isinstance(value, bool):
            raise value_refusal(where, value, "true or false")
        return value


@dataclass(frozen=True, slots=True)
class WordField:
    """A truth value that a device may also say as a word or a number, in any case."""

    words: Mapping[str, bool]
    allowed: str
    required: bool = True

    def check(self, value: object, where: str) -> bool:
        """Return the truth value."""
        word = str(value).lower() if isinstance(value, str | bool | int) else ""
        if word not in self.words:
            raise value_refusal(where, value, self.allowed)
        return self.words[word]


@dataclass(frozen=True, slots=True)
class IdField:
    """An id of a thing, tag or person."""

    required: bool = True

    def check(self, value: object, where: str) -> str:
        """Return the id."""
        if not isinstance(value, str) or not ID_PATTERN.fullmatch(value):
            raise value_refusal(where, value, "an id of 1 to 64 letters, digits and _ . : -")
        return value


@dataclass(frozen=True, slots=True)
class ChoiceField:
    """One of a few words."""

    words: tuple[str, ...]
    required: bool = True

    def check(self, value: object, where: str) -> str:
        """Return the word."""
        if not isinstance(value, str) or value not in self.words:
            raise value_refusal(
                where, value, "one of " + ", ".join(f'"{word}"' for word in self.words)
            )
        return value


@dataclass(frozen=True, slots=True)
class RowsField:
    """A list of objects of one kind."""

    spec: JsonSpec
    most: int = 64
    required: bool = True

    def check(self, value: object, where: str) -> tuple[JsonRecord, ...]:
        """Return the objects."""
        if not isinstance(value, list) or len(value) > self.most:
            raise value_refusal(where, value, f"a list of up to {self.most} objects")
        return tuple(
            read_record(self.spec, entry, f"{where}[{number}]")
            for number, entry in enumerate(value)
        )


def read_record(spec: JsonSpec, tree: object, where: str) -> JsonRecord:
    """Check a JSON object against a table of keys.

    Args:
        spec: the known keys.
        tree: what the JSON says.
        where: what to name in a complaint: topic and key so far.

    Raises:
        WireError: naming the place, the value and what is allowed.
    """
    if not isinstance(tree, dict):
        raise value_refusal(where, tree, "a JSON object")
    values = {
        key: row.check(tree[key], f"{where}.{key}")
        for key, row in spec.items()
        if tree.get(key) is not None
    }
    missing = [key for key, row in spec.items() if row.required and key not in values]
    if missing:
        raise WireError(f"{where}.{missing[0]} is missing")
    nested = [
        name
        for value in values.values()
        if isinstance(value, tuple)
        for record in value
        for name in record.unknown
    ]
    return JsonRecord(values, (*(key for key in tree if key not in spec), *nested))


def value_refusal(where: str, value: object, allowed: str) -> WireError:
    """Return the error about one value: where it stands, what it is, what is allowed."""
    shown = ascii(value)
    return WireError(
        f"{where} is {shown if len(shown) <= _SHOWN else shown[:_SHOWN] + '...'}; allowed:"
        f" {allowed}"
    )
