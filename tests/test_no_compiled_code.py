"""Who hands on what the pilot says calls nothing compiled.

The first compiled function that a process calls loads the compiler: seconds, and a quarter of a
minute on a busy machine. It was called by the console's thread that hears the pilot, at the first
take-off: the page said "No contact with the pilot" for 13 s.
"""

from __future__ import annotations

import importlib
import pkgutil

import pytest

from housefly._compiled_function import CompiledFunction


@pytest.mark.parametrize(
    "package", ["bus", "drones", "evidence", "homeassistant", "hub", "web", "wires"]
)
def test_no_module_calls_a_compiled_function(package: str) -> None:
    root = importlib.import_module(f"housefly.{package}")
    names = [found.name for found in pkgutil.walk_packages(root.__path__, f"{root.__name__}.")]
    compiled = [
        f"{name}.{word}"
        for name in names
        if not name.endswith("__main__")
        for word, value in vars(importlib.import_module(name)).items()
        if isinstance(value, CompiledFunction)
    ]
    assert names and compiled == []
