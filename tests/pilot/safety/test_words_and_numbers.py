"""What the last gate says, word for word, and its numbers: both are changed on purpose only.

``words.txt`` holds what each rule says when it is broken first, ``numbers.txt`` every constant,
those of the drone included (``airframe.landing::sink_rate``).
"""

from __future__ import annotations

import ast
from importlib import import_module
from operator import attrgetter
from pathlib import Path

import pytest
from gate_cases import BROKEN, assessed
from gate_flight import RULES

from housefly.config.site import Site

FOLDER = Path(__file__).parent
WORDS = dict(line.split(": ", 1) for line in (FOLDER / "words.txt").read_text("utf-8").splitlines())
NUMBERS = dict(line.split() for line in (FOLDER / "numbers.txt").read_text("utf-8").splitlines())
OWNERS = {name.partition("::")[0] for name in NUMBERS}
PARTS = {owner for owner in OWNERS if owner.startswith("airframe.")}
MODULES = OWNERS - PARTS


@pytest.mark.parametrize("code", sorted(set(RULES) - {"flight_time_over"}))
def test_people_are_told_what_is_wrong_with_value_and_limit(code: str) -> None:
    change, _, observable = BROKEN[code]
    found = assessed(change, RULES[code].debounce + observable + 0.6)
    words = (rule.words for _, each in found for rule in each.broken if rule.code == code)
    assert next(words) == WORDS[code]


@pytest.mark.parametrize("module", sorted(MODULES))
def test_the_numbers_of_the_gate_are_these(module: str) -> None:
    loaded = import_module(f"housefly.pilot.{module}")
    source = ast.parse(Path(str(loaded.__file__)).read_text("utf-8"))
    assigned = [node for node in source.body if isinstance(node, ast.Assign)]
    names = [
        name.id
        for node in assigned
        for name in ast.walk(node.targets[0])
        if isinstance(name, ast.Name)
    ]
    values = {name: getattr(loaded, name) for name in names}
    found = {
        f"{module}::{name}": f"{value}"
        for name, value in values.items()
        if isinstance(value, int | float)
    }
    own = f"{module}::"
    assert found == {name: value for name, value in NUMBERS.items() if name.startswith(own)}


@pytest.mark.parametrize("part", sorted(PARTS))
def test_the_numbers_that_the_gate_takes_from_the_drone_are_these(part: str) -> None:
    constants = attrgetter(part)(Site().drone).model_dump()
    found = {f"{part}::{name}": f"{value}" for name, value in constants.items()}
    own = f"{part}::"
    assert found == {name: value for name, value in NUMBERS.items() if name.startswith(own)}
