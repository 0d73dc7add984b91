"""Writes a task document as YAML; reading it gives the same document."""

from __future__ import annotations

from typing import Any

import yaml

from housefly.tasks.api.values import Confirm, OnPreempt
from housefly.tasks.document.argument_checks import UNIT_OF
from housefly.tasks.document.parameters import TaskParameter
from housefly.tasks.document.quantities import quantity_words
from housefly.tasks.document.step_forms import (
    CONDITION_FORMS,
    FORMS,
    ArgumentType,
    StepArgument,
)
from housefly.tasks.document.step_parser import STEP_WORDS
from housefly.tasks.document.steps import (
    ArgumentValue,
    ConditionKind,
    ParameterUse,
    TaskCondition,
    TaskStep,
)
from housefly.tasks.document.task_document import RETURN_HOME, TaskDocument


def task_to_yaml(document: TaskDocument) -> str:
    """Return a document as YAML."""
    tree: dict[str, Any] = {"name": document.name, "title": document.title}
    if document.about:
        tree["about"] = document.about
    if document.parameters:
        tree["parameters"] = {each.name: _parameter(each) for each in document.parameters}
    tree["steps"] = [_step(step) for step in document.steps]
    if document.on_cancel != RETURN_HOME:
        tree["on_cancel"] = [_step(step) for step in document.on_cancel]
    if document.confirm is not Confirm.AUTO:
        tree["confirm"] = document.confirm.value
    if document.on_preempt is not OnPreempt.RESUME:
        tree["on_preempt"] = document.on_preempt.value
    if document.time_limit is not None:
        tree["time_limit"] = _seconds(document.time_limit)
    if document.overrides:
        tree["overrides"] = True
    return yaml.dump(tree, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=100)


class _Inline(dict[str, Any]):
    """A mapping that stands on one line."""


class _Dumper(yaml.SafeDumper):
    """Writes lists of plain values on one line, and steps each on its own."""

    def represent_inline(self, tree: _Inline) -> yaml.MappingNode:
        return self.represent_mapping("tag:yaml.org,2002:map", tree, flow_style=True)

    def represent_words(self, words: list[Any]) -> yaml.SequenceNode:
        is_plain = bool(words) and not any(isinstance(each, (dict, list)) for each in words)
        is_steps = any(isinstance(each, str) and each in STEP_WORDS for each in words)
        flow = is_plain and not is_steps
        return self.represent_sequence("tag:yaml.org,2002:seq", words, flow_style=flow)


_Dumper.add_representer(_Inline, _Dumper.represent_inline)
_Dumper.add_representer(list, _Dumper.represent_words)


def _parameter(parameter: TaskParameter) -> dict[str, Any] | str:
    tree = _Inline(type=parameter.type.value)
    usual = TaskParameter(parameter.name, parameter.type)
    for key, name in (("about", "about"), ("unit", "unit"), ("min", "low"), ("max", "high")):
        if getattr(parameter, name) != getattr(usual, name):
            tree[key] = getattr(parameter, name)
    if parameter.of:
        tree["of"] = list(parameter.of)
    if parameter.default is not None:
        tree["default"] = parameter.default
    elif not parameter.required:
        tree["required"] = False
    return tree


def _step(step: TaskStep) -> dict[str, Any] | str:
    form = FORMS[step.kind]
    extras = {word: [_step(each) for each in block] for word, block in step.blocks.items() if word}
    tree: dict[str, Any] = {}
    if "" in step.blocks:
        tree[step.kind.value] = [_step(each) for each in step.blocks[""]]
    else:
        tree[step.kind.value] = _arguments(form.arguments, step.arguments)
    tree.update(extras)
    if step.name:
        tree["name"] = step.name
    if step.timeout is not None:
        tree["timeout"] = _number(step.timeout, "s")
    if step.may_fail:
        tree["may_fail"] = True
    is_bare = tree == {step.kind.value: {}}
    return step.kind.value if is_bare else tree


def _arguments(known: tuple[StepArgument, ...], given: dict[str, ArgumentValue]) -> Any:
    values = _Inline({a.name: _value(a, given[a.name]) for a in known if a.name in given})
    is_main_only = len(values) == 1 and known[0].name in values
    main = values.get(known[0].name) if known else None
    is_condition = bool(known) and known[0].type is ArgumentType.CONDITION
    if is_main_only and (is_condition or not isinstance(main, dict)):
        return main
    return values


def _value(argument: StepArgument, value: ArgumentValue) -> Any:
    if isinstance(value, TaskCondition):
        return _condition(value)
    if isinstance(value, ParameterUse):
        return f"${value.name}"
    if isinstance(value, tuple):
        return list(value)
    if isinstance(value, dict):
        return _Inline(value)
    if argument.type in UNIT_OF and isinstance(value, float):
        return _number(value, UNIT_OF[argument.type])
    return value


def _number(value: float | ParameterUse, unit: str) -> Any:
    if isinstance(value, ParameterUse):
        return f"${value.name}"
    # Short where that is exact; otherwise the number itself, which counts in the unit anyway.
    words = quantity_words(value, unit)
    return words if unit and float(f"{value:g}") == value else value


def _seconds(value: float) -> Any:
    return _number(value, "s")


def _condition(condition: TaskCondition) -> dict[str, Any]:
    kind = condition.kind
    if kind is ConditionKind.NOT:
        return _Inline({kind.value: _condition(condition.parts[0])})
    if kind in (ConditionKind.ALL, ConditionKind.ANY):
        return {kind.value: [_condition(part) for part in condition.parts]}
    return _Inline({kind.value: _arguments(CONDITION_FORMS[kind], condition.arguments)})
