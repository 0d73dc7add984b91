"""Reads files of rules, and says which of them ask for what there is not."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any

from pydantic import Field

from housefly.config.section import Section
from housefly.config.text import did_you_mean, read_text_file, refuse_odd_values
from housefly.config.validation import validated
from housefly.errors import ConfigError, TaskError
from housefly.tasks.api.values import ParameterInfo, ServiceInfo
from housefly.tasks.document.marked_yaml import MarkedValue, read_marked_yaml
from housefly.tasks.rules.impossible import impossibilities
from housefly.tasks.rules.rule import Rule

MAX_RULES = 200
"""Each is looked at for each event."""


class RuleFile(Section):
    """A file of rules."""

    rules: tuple[Rule, ...] = Field(default=(), max_length=MAX_RULES)


def parse_rules(text: str, source: str = "") -> tuple[Rule, ...]:
    """Return the rules of a YAML text; raises ConfigError that names the first bad key."""
    try:
        tree = _plain(read_marked_yaml(text, source))
    except TaskError as error:
        raise ConfigError("rules", str(error)) from error
    refuse_odd_values(tree, source, "rules")
    rules = validated(RuleFile, tree, "rules", source).rules
    names = [rule.name for rule in rules]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise ConfigError("rules", f"two of them have the name {twice[0]!r}", source)
    return rules


def read_rules(path: Path) -> tuple[Rule, ...]:
    """Return the rules of a file; raises ConfigError when it cannot be read or is wrong."""
    try:
        text = read_text_file(path)
    except (OSError, UnicodeDecodeError) as error:
        words = getattr(error, "strerror", None) or str(error)
        raise ConfigError("tasks.rules", f"cannot be read ({words})", str(path)) from error
    return parse_rules(text, str(path))


def shipped_rules() -> tuple[Rule, ...]:
    """Return the rules that every house has."""
    file = files("housefly.tasks.rules") / "shipped" / "rules.yaml"
    return parse_rules(file.read_text(encoding="utf-8"), "rules.yaml")


def rules_of(path: Path | None) -> tuple[Rule, ...]:
    """Return the shipped rules and those of a file; a rule takes the place of its namesake."""
    own = read_rules(path) if path else ()
    names = {rule.name for rule in own}
    return (*(rule for rule in shipped_rules() if rule.name not in names), *own)


def rule_problems(rules: Iterable[Rule], services: Mapping[str, ServiceInfo]) -> tuple[str, ...]:
    """Return what rules ask for or wait for that there is not, a sentence each."""
    return tuple(
        f"rule {rule.name}: {problem}" for rule in rules for problem in _problems(rule, services)
    )


def _plain(marked: MarkedValue) -> Any:
    value = marked.value
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return value


def _problems(rule: Rule, services: Mapping[str, ServiceInfo]) -> Iterable[str]:
    yield from impossibilities(rule)
    service = services.get(rule.then.service)
    if service is None:
        asked = rule.then.service
        meant = did_you_mean(asked, services) or f"; there is: {', '.join(sorted(services))}"
        yield f"there is no service {asked!r}{meant}"
        return
    known: dict[str, ParameterInfo] = {item.name: item for item in service.parameters}
    for name in rule.then.parameters:
        if name not in known:
            allowed = ", ".join(known) or "none"
            yield f"{service.name} has no parameter {name!r}; it has: {allowed}"
    for item in service.parameters:
        if item.required and item.name not in rule.then.parameters:
            yield f"{service.name} needs the parameter {item.name!r}"
