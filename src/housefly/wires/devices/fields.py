"""Keys of a device's JSON as table rows: each checks its value for type, range and unit."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol

from housefly.errors import UnknownState, WireError
from housefly.wires.devices.words import FLAG_WORDS, UNKNOWN_WORDS

ID_PATTERN = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.:-]{0,63}")
"""What ids of devices, things and tags look like."""
_SHOWN = 60
_NUMBER = re.compile(r"(?P<whole>[+-]?\d{1,15})(?:(?P<mark>[.,])(?P<rest>\d{1,12}))?"
                     r"(?P<power>[eE][+-]?\d{1,2})?\s?(?P<unit>[^\s\d]{0,4})")  # fmt: skip
_SIGNS = {"degrees Celsius": "°C"}

_Value = float | bool | str | tuple["JsonRecord", ...]


class JsonField(Protocol):
    """One key of a table of keys."""

    @property
    def required(self) -> bool:
        """Whether the key must be there."""
        ...

    def check(self, value: object, where: str) -> _Value:
        """Return the checked value.

        Raises:
            UnknownState: it is a state that the kind does not know, or the device does not know it.
            WireError: naming place, value and range.
        """
        ...


JsonSpec = Mapping[str, JsonField]


@dataclass(frozen=True, slots=True)
class JsonRecord:
    """A checked JSON object.

    Attributes:
        values: of the known keys that were there, and whose values were understood.
        unknown: the other keys, those of objects inside it too.
        refused: what was not understood, by key; what is wrong inside an object of a list stands
            under the key of the list.
        missing: required keys that are not there.
        incomplete: keys of lists of which an object was left out.
    """

    values: Mapping[str, _Value] = field(default_factory=dict)
    unknown: tuple[str, ...] = ()
    refused: Mapping[str, WireError] = field(default_factory=dict)
    missing: tuple[str, ...] = ()
    incomplete: tuple[str, ...] = ()

    def number(self, key: str) -> float:
        """Return a required number."""
        return float(self.values[key])  # type: ignore[arg-type]  # the table has checked it

    def number_or_none(self, key: str) -> float | None:
        """Return an optional number."""
        return self.number(key) if key in self.values else None

    def flag(self, key: str) -> bool | None:
        """Return a truth value; None when the key is absent or was not understood."""
        return bool(self.values[key]) if key in self.values else None

    def word(self, key: str) -> str:
        """Return a text; empty when the key is absent."""
        return str(self.values.get(key, ""))

    def rows(self, key: str) -> tuple[JsonRecord, ...]:
        """Return the objects of a list that were understood; empty when the key is absent."""
        value = self.values.get(key, ())
        return value if isinstance(value, tuple) else ()

    def count(self, key: str) -> float | None:
        """Return how many objects a list has; None when one of them was left out."""
        return None if key in self.incomplete else float(len(self.rows(key)))


@dataclass(frozen=True, slots=True)
class NumberField:
    """A finite number in an inclusive range, as JSON's or as a text with or without its unit."""

    low: float
    high: float
    unit: str = ""
    required: bool = True

    def check(self, value: object, where: str) -> float:
        """Return the number."""
        number = plain_number(value, self.unit) if isinstance(value, str) else value
        if (
            isinstance(number, bool)
            or not isinstance(number, int | float)
            or not self.low <= number <= self.high
        ):
            raise value_refusal(
                where, value, f"a number from {self.low:g} to {self.high:g} {self.unit}".rstrip()
            )
        return float(number)


@dataclass(frozen=True, slots=True)
class WordField:
    """A truth value that a device may also say as a word or a number, in any case."""

    words: Mapping[str, bool]
    allowed: str
    required: bool = True

    def check(self, value: object, where: str) -> bool:
        """Return the truth value."""
        word = _word_of(value)
        if word not in self.words:
            raise UnknownState(str(value_refusal(where, value, self.allowed)))
        return self.words[word]


@dataclass(frozen=True, slots=True)
class FlagField:
    """A truth value on our own topics."""

    required: bool = True

    def check(self, value: object, where: str) -> bool:
        """Return the truth value."""
        return WordField(FLAG_WORDS, "true or false").check(value, where)


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
    """A list of objects of one kind; one that is not understood does not take the others away."""

    spec: JsonSpec
    most: int = 64
    required: bool = True

    def check(self, value: object, where: str) -> tuple[JsonRecord, ...]:
        """Return the objects, those with refused or missing keys too."""
        if not isinstance(value, list) or len(value) > self.most:
            raise value_refusal(where, value, f"a list of up to {self.most} objects")
        return tuple(
            _row_of(self.spec, entry, f"{where}[{number}]") for number, entry in enumerate(value)
        )


def read_record(spec: JsonSpec, tree: object, where: str) -> JsonRecord:
    """Check a JSON object against a table of keys; a bad value leaves the others alone.

    Args:
        spec: the known keys.
        tree: what the JSON says.
        where: what to name in a complaint: topic and key so far.

    Raises:
        WireError: it is no object.
    """
    if not isinstance(tree, dict):
        raise value_refusal(where, tree, "a JSON object")
    values: dict[str, _Value] = {}
    refused: dict[str, WireError] = {}
    unknown, incomplete = [key for key in tree if key not in spec], list[str]()
    for key, row in spec.items():
        if key not in tree or (tree[key] is None and not row.required):
            continue
        try:
            value = known_value(row, tree[key], f"{where}.{key}")
        except WireError as error:
            refused[key] = error
            continue
        if isinstance(value, tuple):
            unknown += [name for record in value for name in record.unknown]
            if complaint := _first_complaint(value):
                refused[key] = complaint
            whole = tuple(record for record in value if not _is_broken(record, row))
            incomplete += [key] if len(whole) < len(value) else []
            value = whole
        values[key] = value
    missing = tuple(key for key, row in spec.items() if row.required and key not in tree)
    return JsonRecord(values, tuple(unknown), refused, missing, tuple(incomplete))


def known_value(row: JsonField, value: object, where: str) -> _Value:
    """Return a checked value; raises UnknownState when the device says that it does not know it."""
    try:
        return row.check(value, where)
    except WireError as error:
        if value is None or (isinstance(value, str) and value.strip().lower() in UNKNOWN_WORDS):
            shown = "null" if value is None else ascii(value)
            raise UnknownState(f"{where} is {shown}: the device does not know it") from error
        raise


def _row_of(spec: JsonSpec, entry: object, where: str) -> JsonRecord:
    """Return one object of a list; one that is none has nothing that was understood."""
    try:
        record = read_record(spec, entry, where)
    except WireError as error:
        return JsonRecord(refused={"": error}, missing=tuple(spec))
    absent = {key: WireError(f"{where}.{key} is missing") for key in record.missing}
    return JsonRecord(record.values, record.unknown, {**record.refused, **absent}, record.missing)


def _first_complaint(records: tuple[JsonRecord, ...]) -> WireError | None:
    return next((error for record in records for error in record.refused.values()), None)


def _is_broken(record: JsonRecord, field_of_rows: JsonField) -> bool:
    """Return whether an object of a list lacks a key that it needs."""
    spec = field_of_rows.spec if isinstance(field_of_rows, RowsField) else {}
    return any(row.required and key not in record.values for key, row in spec.items())


def _word_of(value: object) -> str:
    """Return a word, truth value or whole number in lower case; "" for anything else."""
    return str(value).strip().lower() if isinstance(value, str | bool | int) else ""


def plain_number(text: str, unit: str = "") -> float | None:
    """Return the number in a text: "21.5", "21,5", "21.5 °C"; None where it is not plain."""
    match = _NUMBER.fullmatch(text.strip())
    if match is None or match["unit"] not in ("", unit, _SIGNS.get(unit, "")):
        return None
    whole, rest = match["whole"], match["rest"] or "0"
    if match["mark"] == "," and len(rest) == 3 and whole.lstrip("+-0"):
        return None  # 1,420 is 1.42 in Berlin and 1420 in London
    return float(f"{whole}.{rest}{match['power'] or ''}")


def value_refusal(where: str, value: object, allowed: str) -> WireError:
    """Return the error about one value: where it stands, what it is, what is allowed."""
    shown = ascii(value)
    return WireError(
        f"{where} is {shown if len(shown) <= _SHOWN else shown[:_SHOWN] + '...'}; allowed:"
        f" {allowed}"
    )
