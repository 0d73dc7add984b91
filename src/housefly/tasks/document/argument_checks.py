"""Arguments of steps: from what stands in a document to values, with what is allowed in words."""

from __future__ import annotations

import re
from collections.abc import Callable

from housefly.tasks.document.marked_yaml import MarkedValue
from housefly.tasks.document.parameters import NAME_TYPES, ParameterType
from housefly.tasks.document.quantities import quantity_of
from housefly.tasks.document.step_forms import EVERY, ArgumentType, StepArgument
from housefly.tasks.document.steps import ArgumentValue, ParameterUse
from housefly.tasks.document.templates import lone_name

NAME = re.compile(r"[a-z][a-z0-9_]{0,39}")
"""Names of tasks, parameters and replies."""
SPEECH_MAX = 500
"""Longest text of a step [characters]."""
LIST_MAX = 50
"""Longest list of names or choices."""
UNIT_OF = {
    ArgumentType.TIME: "s",
    ArgumentType.LENGTH: "m",
    ArgumentType.ANGLE: "deg",
    ArgumentType.COUNT: "",
}
"""Units of arguments that are numbers."""
FITTING: dict[ArgumentType, frozenset[ParameterType]] = {
    ArgumentType.SUBJECT: NAME_TYPES | {ParameterType.TEXT, ParameterType.CHOICE},
    ArgumentType.TEXT: frozenset(ParameterType),
    ArgumentType.NAMES: frozenset({ParameterType.PLACES}),
    ArgumentType.FLAG: frozenset({ParameterType.FLAG}),
    ArgumentType.CHOICE: frozenset({ParameterType.CHOICE, ParameterType.TEXT}),
    ArgumentType.WORDS: frozenset({ParameterType.PLACES}),
    ArgumentType.POINT: frozenset(),
    **dict.fromkeys(UNIT_OF, frozenset({ParameterType.NUMBER})),
}
"""Which parameters may stand where; an argument type that is missing takes none."""


def words_of_line(marked: MarkedValue) -> str | None:
    """Return a single value as one printable line, None when it is none."""
    if isinstance(marked.value, (tuple, dict)) or (marked.value is None and not marked.text):
        return None
    text = marked.text.rstrip("\n")
    return text if len(text) <= SPEECH_MAX and text.isprintable() else None


def number_fault(argument: StepArgument, number: float | None) -> str:
    """Return what is wrong with a number, in words, or ""."""
    unit = UNIT_OF[argument.type]
    is_whole = argument.type is not ArgumentType.COUNT or number == int(number or 0)
    if number is None or not is_whole:
        return f"expected {argument.type.value}"
    if not argument.low <= number <= argument.high:
        return f"allowed: {argument.low:g} to {argument.high:g} {unit}".rstrip()
    return ""


def argument_of(argument: StepArgument, marked: MarkedValue) -> ArgumentValue | None:
    """Return an argument's value, or None when something else stands there."""
    reader = _READERS.get(argument.type)
    return reader(argument, marked) if reader else None


def _text(argument: StepArgument, marked: MarkedValue) -> ArgumentValue | None:
    words = words_of_line(marked)
    return words if words or argument.type is ArgumentType.TEXT else None


def _number(argument: StepArgument, marked: MarkedValue) -> ArgumentValue | None:
    if isinstance(marked.value, str) and (name := lone_name(marked.value)):
        return ParameterUse(name)
    if isinstance(marked.value, (str, float)):
        return quantity_of(marked.value, UNIT_OF[argument.type])
    return None


def _flag(argument: StepArgument, marked: MarkedValue) -> ArgumentValue | None:
    if isinstance(marked.value, str) and (name := lone_name(marked.value)):
        return ParameterUse(name)
    return marked.value if isinstance(marked.value, bool) else None


def _choice(argument: StepArgument, marked: MarkedValue) -> ArgumentValue | None:
    if isinstance(marked.value, str) and (name := lone_name(marked.value)):
        return ParameterUse(name)
    return marked.text if marked.text in argument.of else None


def _name(argument: StepArgument, marked: MarkedValue) -> ArgumentValue | None:
    return marked.text if NAME.fullmatch(marked.text) else None


def _list(argument: StepArgument, marked: MarkedValue) -> ArgumentValue | None:
    if isinstance(marked.value, str) and (name := lone_name(marked.value)):
        return ParameterUse(name)
    if argument.type is ArgumentType.NAMES and marked.text in EVERY:
        return marked.text
    if not isinstance(marked.value, tuple) or not 1 <= len(marked.value) <= LIST_MAX:
        return None
    words = [words_of_line(item) for item in marked.value]
    return None if not all(words) else tuple(str(each) for each in words)


def _point(argument: StepArgument, marked: MarkedValue) -> ArgumentValue | None:
    if not isinstance(marked.value, tuple) or len(marked.value) != 2:
        return None
    numbers = [item.value for item in marked.value]
    found = tuple(quantity_of(n, "m") for n in numbers if isinstance(n, (str, float)))
    x, y = (*found, None, None)[:2]
    inside = x is not None and y is not None and max(abs(x), abs(y)) <= argument.high
    return (x, y) if x is not None and y is not None and inside else None


def _given(argument: StepArgument, marked: MarkedValue) -> ArgumentValue | None:
    if not isinstance(marked.value, dict):
        return None
    found: dict[str, str | float | bool] = {}
    for name, item in marked.value.items():
        if not isinstance(item.value, (str, float, bool)) or not item.text.isprintable():
            return None
        found[name] = item.value
    return found


_READERS: dict[ArgumentType, Callable[[StepArgument, MarkedValue], ArgumentValue | None]] = {
    ArgumentType.SUBJECT: _text,
    ArgumentType.TEXT: _text,
    ArgumentType.WORDS: _list,
    ArgumentType.NAMES: _list,
    ArgumentType.NAME: _name,
    ArgumentType.TIME: _number,
    ArgumentType.LENGTH: _number,
    ArgumentType.ANGLE: _number,
    ArgumentType.COUNT: _number,
    ArgumentType.FLAG: _flag,
    ArgumentType.CHOICE: _choice,
    ArgumentType.GIVEN: _given,
    ArgumentType.POINT: _point,
}
