"""Parameters of a task: what may be given, and the sentence when something else was."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

from housefly.errors import TaskError
from housefly.tasks.api.values import ParameterInfo, ParameterValue, ReasonCode
from housefly.tasks.document.quantities import quantity_of, quantity_words

WORDS_MAX = 200
"""Longest text that a parameter takes [characters]."""
_FLAG_WORDS = {"true": True, "yes": True, "on": True, "false": False, "no": False, "off": False}


class ParameterType(Enum):
    """What a parameter takes."""

    PLACE = "place"
    THING = "thing"
    PLACE_OR_THING = "place_or_thing"
    PERSON = "person"
    PLACES = "places"
    NUMBER = "number"
    TEXT = "text"
    CHOICE = "choice"
    FLAG = "flag"


NAME_TYPES = frozenset(
    {
        ParameterType.PLACE,
        ParameterType.THING,
        ParameterType.PLACE_OR_THING,
        ParameterType.PERSON,
    }
)
"""Types that name one subject in the room; whether there is one, the room says when it runs."""


@dataclass(frozen=True, slots=True)
class TaskParameter:
    """One parameter of a task.

    Attributes:
        name, type, about: of the parameter.
        unit: of a number, or "".
        low, high: range of a number, in ``unit``.
        of: what a choice may be.
        default: its value when it is not given; None means that it stays empty.
        required: whether it must be given.
    """

    name: str
    type: ParameterType
    about: str = ""
    unit: str = ""
    low: float = -1e6
    high: float = 1e6
    of: tuple[str, ...] = ()
    default: ParameterValue | None = None
    required: bool = False

    def info(self) -> ParameterInfo:
        """Return it for whoever asks."""
        return ParameterInfo(
            name=self.name,
            type=self.type.value,
            about=self.about + (f" ({', '.join(self.of)})" if self.of else ""),
            unit=self.unit,
            default=self.default,
            required=self.required,
        )

    def checked(self, value: ParameterValue) -> ParameterValue:
        """Return a value as this parameter holds it.

        Raises:
            TaskError: BAD_PARAMETER; says what is allowed.
        """
        found = _CHECKS.get(self.type, _name)(self, value)
        if found is None:
            raise TaskError(
                f"{self.name}: {_shown(value)} is not {self.allowed()}",
                ReasonCode.BAD_PARAMETER.value,
            )
        return found

    def allowed(self) -> str:
        """Return what it takes, in words."""
        if self.type is ParameterType.NUMBER:
            low, high = quantity_words(self.low, ""), quantity_words(self.high, self.unit)
            return f"a number from {low} to {high}"
        if self.type is ParameterType.CHOICE:
            return f"one of {', '.join(self.of)}"
        return _ALLOWED[self.type]


_ALLOWED = {
    ParameterType.PLACE: "the name of a place",
    ParameterType.THING: "the name of a thing",
    ParameterType.PLACE_OR_THING: "the name of a place or a thing",
    ParameterType.PERSON: "the name of a person",
    ParameterType.PLACES: "names with commas between them",
    ParameterType.TEXT: f"a text of at most {WORDS_MAX} printable letters",
    ParameterType.FLAG: "yes or no",
}


def checked_parameters(
    parameters: tuple[TaskParameter, ...], given: Mapping[str, ParameterValue]
) -> dict[str, ParameterValue]:
    """Return all parameters of a task that have a value, defaults included.

    Raises:
        TaskError: BAD_PARAMETER; one is unknown, missing or wrong.
    """
    known = {parameter.name for parameter in parameters}
    for name in given:
        if name not in known:
            allowed = ", ".join(sorted(known)) or "none"
            raise TaskError(
                f"there is no parameter {_shown(name)}; allowed: {allowed}",
                ReasonCode.BAD_PARAMETER.value,
            )
    values: dict[str, ParameterValue] = {}
    for parameter in parameters:
        value = given.get(parameter.name, parameter.default)
        if value is not None and value != "":
            values[parameter.name] = parameter.checked(value)
        elif parameter.required:
            raise TaskError(
                f"{parameter.name} is missing: {parameter.allowed()}",
                ReasonCode.BAD_PARAMETER.value,
            )
    return values


def _is_words(value: object) -> bool:
    """Return whether something is printable text of a sensible length."""
    return isinstance(value, str) and len(value) <= WORDS_MAX and value.isprintable()


def _name(parameter: TaskParameter, value: ParameterValue) -> ParameterValue | None:
    if not _is_words(value):
        return None
    return str(value).strip() or None


def _text(parameter: TaskParameter, value: ParameterValue) -> ParameterValue | None:
    return value if _is_words(value) else None


def _number(parameter: TaskParameter, value: ParameterValue) -> ParameterValue | None:
    number = quantity_of(value, parameter.unit)
    return number if number is not None and parameter.low <= number <= parameter.high else None


def _choice(parameter: TaskParameter, value: ParameterValue) -> ParameterValue | None:
    return value if value in parameter.of else None


def _flag(parameter: TaskParameter, value: ParameterValue) -> ParameterValue | None:
    if isinstance(value, bool):
        return value
    return _FLAG_WORDS.get(value.strip().lower()) if isinstance(value, str) else None


_CHECKS = {
    ParameterType.NUMBER: _number,
    ParameterType.TEXT: _text,
    ParameterType.CHOICE: _choice,
    ParameterType.FLAG: _flag,
}


def _shown(value: object) -> str:
    return repr(value)[:80]
