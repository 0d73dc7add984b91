"""Reads one task document."""

from __future__ import annotations

from dataclasses import replace
from enum import Enum
from typing import TypeVar

from housefly.errors import TaskError
from housefly.tasks.api.values import Confirm, OnPreempt, ParameterValue
from housefly.tasks.document.argument_checks import NAME, words_of_line
from housefly.tasks.document.marked_yaml import MarkedValue, read_marked_yaml
from housefly.tasks.document.parameters import ParameterType, TaskParameter
from housefly.tasks.document.quantities import UNITS, quantity_of
from housefly.tasks.document.step_forms import TIME_MAX
from housefly.tasks.document.step_parser import EACH, StepParser, names_found
from housefly.tasks.document.task_document import RETURN_HOME, TaskDocument

KEYS = (
    *("name", "title", "about", "parameters", "steps", "on_cancel"),
    *("confirm", "on_preempt", "time_limit", "overrides"),
)
"""What may stand at the top of a document."""
_PARAMETER_KEYS = ("type", "about", "unit", "min", "max", "of", "default", "required")
_PARAMETERS_MAX = 20
_AnEnum = TypeVar("_AnEnum", bound=Enum)


def read_task(text: str, source: str = "") -> TaskDocument:
    """Return the document in a YAML text; tasks that it calls are not looked for.

    Raises:
        TaskError: BAD_PARAMETER; names file, line, and what is allowed.
    """
    return _DocumentParser(source).document(read_marked_yaml(text, source))


class _DocumentParser:
    def __init__(self, source: str) -> None:
        self._source = source
        self._steps = StepParser(source, {})

    def document(self, marked: MarkedValue) -> TaskDocument:
        tree = self._mapping(marked, "a task with name and steps", KEYS, "a task")
        for key in ("name", "steps"):
            if key not in tree:
                raise self._error(marked, f"a task needs {key}:")
        parameters = self._parameters(tree.get("parameters"))
        found = names_found(tree["steps"])
        if "on_cancel" in tree:
            found |= names_found(tree["on_cancel"])
        self._steps = StepParser(self._source, {p.name: p for p in parameters}, found)
        name = self._name(tree["name"])
        on_cancel = tree.get("on_cancel")
        return TaskDocument(
            name=name,
            title=self._line(tree.get("title"), 80) or name.replace("_", " "),
            about=self._line(tree.get("about"), 300),
            parameters=parameters,
            steps=self._steps.steps(tree["steps"]),
            on_cancel=RETURN_HOME if on_cancel is None else self._steps.steps(on_cancel),
            confirm=self._enum(tree.get("confirm"), Confirm.AUTO),
            on_preempt=self._enum(tree.get("on_preempt"), OnPreempt.RESUME),
            time_limit=self._time(tree.get("time_limit")),
            overrides=self._flag(tree.get("overrides")),
            source=self._source,
        )

    def _parameters(self, marked: MarkedValue | None) -> tuple[TaskParameter, ...]:
        if marked is None or marked.value is None:
            return ()
        if not isinstance(marked.value, dict) or len(marked.value) > _PARAMETERS_MAX:
            raise self._error(
                marked,
                f"parameters: expected at most {_PARAMETERS_MAX} names, each with a type,"
                " such as subject: place_or_thing",
            )
        return tuple(self._parameter(name, item) for name, item in marked.value.items())

    def _parameter(self, name: str, marked: MarkedValue) -> TaskParameter:
        if not NAME.fullmatch(name) or name == EACH:
            raise self._error(marked, f"{name[:60]!r} is no name of a parameter: {_NAME_WORDS}")
        if isinstance(marked.value, str):
            marked = MarkedValue(marked.line, {"type": marked})
        tree = self._mapping(marked, "a type, such as place", _PARAMETER_KEYS, f"parameter {name}")
        if "type" not in tree:
            raise self._error(marked, f"parameter {name} needs a type: {_TYPE_WORDS}")
        type_ = self._enum(tree["type"], ParameterType.TEXT)
        low, high = self._range(tree, type_)
        parameter = TaskParameter(
            name=name,
            type=type_,
            about=self._line(tree.get("about"), 200),
            unit=self._unit(tree.get("unit")),
            of=self._choices(tree.get("of"), type_, marked),
            low=low,
            high=high,
        )
        return self._with_default(parameter, tree)

    def _with_default(
        self, parameter: TaskParameter, tree: dict[str, MarkedValue]
    ) -> TaskParameter:
        """Return the parameter; one without a default must be given unless it says otherwise."""
        marked = tree.get("default")
        if marked is None:
            is_required = "required" not in tree or self._flag(tree["required"])
            return replace(parameter, required=is_required)
        if "required" in tree and self._flag(tree["required"]):
            raise self._error(marked, f"{parameter.name} is required and has a default")
        if isinstance(marked.value, (tuple, dict)):
            raise self._error(marked, f"{parameter.name}: default: {parameter.allowed()}")
        value: ParameterValue = marked.value if isinstance(marked.value, bool) else marked.text
        try:
            return replace(parameter, default=parameter.checked(value))
        except TaskError as error:
            raise self._error(marked, f"default of {error}") from None

    def _range(self, tree: dict[str, MarkedValue], type_: ParameterType) -> tuple[float, float]:
        found: dict[str, float] = {}
        for key, name in (("min", "low"), ("max", "high")):
            if key not in tree:
                continue
            marked = tree[key]
            unit = tree["unit"].text if "unit" in tree else ""
            number = (
                quantity_of(marked.value, unit) if isinstance(marked.value, (str, float)) else None
            )
            if type_ is not ParameterType.NUMBER or number is None:
                raise self._error(
                    marked, f"{key}: expected a number, of a parameter of type number"
                )
            found[name] = number
        low, high = found.get("low", -1e6), found.get("high", 1e6)
        if low > high:
            raise self._error(next(iter(tree.values())), "min lies above max")
        return low, high

    def _choices(
        self, marked: MarkedValue | None, type_: ParameterType, parent: MarkedValue
    ) -> tuple[str, ...]:
        is_choice = type_ is ParameterType.CHOICE
        if marked is None:
            if is_choice:
                raise self._error(parent, "a choice needs of: [one, another]")
            return ()
        items = marked.value if isinstance(marked.value, tuple) else ()
        words = tuple(words_of_line(item) or "" for item in items)
        if not is_choice or not 1 <= len(words) <= 50 or not all(words):
            raise self._error(marked, "of: expected 1 to 50 words, of a parameter of type choice")
        return words

    def _unit(self, marked: MarkedValue | None) -> str:
        if marked is None:
            return ""
        if marked.text not in UNITS:
            raise self._error(marked, f"unit: allowed: {', '.join(UNITS)}")
        return marked.text

    def _name(self, marked: MarkedValue) -> str:
        if not NAME.fullmatch(marked.text):
            raise self._error(marked, f"name: expected {_NAME_WORDS}")
        return marked.text

    def _line(self, marked: MarkedValue | None, longest: int) -> str:
        if marked is None:
            return ""
        words = words_of_line(marked)
        if words is None or len(words) > longest:
            raise self._error(marked, f"expected one line of at most {longest} printable letters")
        return words

    def _flag(self, marked: MarkedValue | None) -> bool:
        if marked is None:
            return False
        if not isinstance(marked.value, bool):
            raise self._error(marked, "expected true or false")
        return marked.value

    def _time(self, marked: MarkedValue | None) -> float | None:
        if marked is None:
            return None
        value = marked.value
        seconds = quantity_of(value, "s") if isinstance(value, (str, float)) else None
        if seconds is None or not 1.0 <= seconds <= TIME_MAX:
            raise self._error(marked, "time_limit: expected a time from 1 s to 24 h")
        return seconds

    def _enum(self, marked: MarkedValue | None, usual: _AnEnum) -> _AnEnum:
        if marked is None:
            return usual
        words = {member.value: member for member in type(usual)}
        if marked.text not in words:
            raise self._steps.unknown(marked, "there is no", marked.text, words)
        return words[marked.text]

    def _mapping(
        self, marked: MarkedValue, expected: str, keys: tuple[str, ...], what: str
    ) -> dict[str, MarkedValue]:
        if not isinstance(marked.value, dict):
            raise self._error(marked, f"expected {expected}")
        for key, item in marked.value.items():
            if key not in keys:
                raise self._steps.unknown(item, f"{what} has no", key, keys)
        return marked.value

    def _error(self, marked: MarkedValue, problem: str) -> TaskError:
        return self._steps.error(marked, problem)


_NAME_WORDS = "small letters, digits and _, at most 40, a letter first"
_TYPE_WORDS = ", ".join(each.value for each in ParameterType)
