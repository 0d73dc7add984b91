"""The table of the last gate in words, as ``docs/safety.md`` shows it."""

from __future__ import annotations

from housefly.config.airframe import Ability
from housefly.pilot.safety.rules import SAFETY_RULES

HEADER = ("| rule | wrong is | counts | after | answer | ends |", "|---|---|---|---|---|---|")


def rules_table() -> str:
    """Return one line a rule, worst first."""
    rows = []
    for rule in SAFETY_RULES:
        after = f"{rule.debounce:g} s" if rule.debounce else "at once"
        ends = rule.clears.value + (f", after {rule.lasts:g} s" if rule.lasts else "")
        rows.append(
            f"| `{rule.code}` | {rule.condition} | {rule.scope.value} | {after}"
            f" | {rule.mode.value} | {ends} |"
        )
    return "\n".join((*HEADER, *rows))


def needs_table() -> str:
    """Return what each rule needs that a drone may lack, and what stands in for it."""
    lines: dict[tuple[str, str], list[str]] = {}
    for rule in SAFETY_RULES:
        if rule.needs:
            needs = " and ".join(one.value for one in Ability if one in rule.needs)
            lines.setdefault((needs, rule.instead), []).append(f"`{rule.code}`")
    rows = [
        f"| {needs} | {', '.join(codes)} | {instead} |" for (needs, instead), codes in lines.items()
    ]
    head = ("| a drone without | is not held against | but by |", "|---|---|---|")
    return "\n".join((*head, *rows))
