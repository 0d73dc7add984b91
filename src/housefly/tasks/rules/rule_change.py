"""What a person changed of a rule on a page: beside its file, which stays as it was written."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Annotated, Literal

from pydantic import Field

from housefly.config.section import Section
from housefly.config.tasks import ModeName
from housefly.errors import TaskError
from housefly.tasks.api.values import ParameterValue, ReasonCode
from housefly.tasks.rules.rule import Name, Rule

_Short = Annotated[str, Field(max_length=200)]


class RuleChange(Section):
    """The values that take the place of a rule's own; None, and what is not named, stays."""

    enabled: bool | None = None
    confirm: Literal["auto", "ask", "never"] | None = None
    mode: Annotated[tuple[ModeName, ...], Field(max_length=5)] | None = None
    parameters: dict[Name, ParameterValue] = Field(default_factory=dict, max_length=20)
    by: _Short = ""

    def and_then(self, later: RuleChange) -> RuleChange:
        """Return this change with a later one on top."""
        given = later.model_dump(exclude_none=True)
        given["parameters"] = {**self.parameters, **later.parameters}
        return self.model_copy(update=given)

    def words(self) -> str:
        """Return what it says: "off, ask, mode home or away, subject sofa"."""
        parts = [
            *([] if self.enabled is None else ["on" if self.enabled else "off"]),
            *([self.confirm] if self.confirm else []),
            *([] if self.mode is None else [f"mode {' or '.join(self.mode) or 'any'}"]),
            *(f"{name} {value}" for name, value in self.parameters.items()),
        ]
        return ", ".join(parts)


def changed(rule: Rule, change: RuleChange) -> Rule:
    """Return a rule with a change; raises TaskError BAD_PARAMETER for what it cannot take."""
    for name, value in change.parameters.items():
        if is_reference(rule.then.parameters.get(name)) or is_reference(value):
            raise TaskError(
                f"{name} of the rule {rule.name}: its trigger gives it; allowed: change its file",
                ReasonCode.BAD_PARAMETER.value,
            )
    parameters = {**rule.then.parameters, **change.parameters}
    kept = {name: value for name, value in parameters.items() if value != ""}
    update: dict[str, object] = {"then": rule.then.model_copy(update={"parameters": kept})}
    if change.enabled is not None:
        update["enabled"] = change.enabled
    if change.confirm is not None:
        update["confirm"] = change.confirm
    if change.mode is not None:
        update["conditions"] = rule.conditions.model_copy(update={"mode": change.mode})
    return rule.model_copy(update=update)


def is_reference(value: ParameterValue | None) -> bool:
    """Return whether a parameter takes its value from the trigger."""
    return isinstance(value, str) and value.startswith("$")


def with_changes(
    rules: Iterable[Rule], changes: Mapping[str, RuleChange]
) -> tuple[tuple[Rule, ...], tuple[str, ...]]:
    """Return rules with what was changed of them, and what no longer fits, in words."""
    found, problems = [], []
    for rule in rules:
        try:
            found.append(changed(rule, changes[rule.name]) if rule.name in changes else rule)
        except TaskError as error:
            problems.append(f"a change of the page is left aside: {error}")
            found.append(rule)
    return tuple(found), tuple(problems)


def asking_first(rules: Iterable[Rule]) -> tuple[Rule, ...]:
    """Return rules of which none flies without a yes."""
    return tuple(
        rule.model_copy(update={"confirm": "ask"}) if rule.confirm == "auto" else rule
        for rule in rules
    )
