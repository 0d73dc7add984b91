"""Compiled code on disk is found again exactly when nothing that it was made from has changed."""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

from housefly._compile_cache import code_digest

SOURCES = {
    "room_facts": """
from enum import IntEnum
from typing import NamedTuple

class Phase(IntEnum):
    REST = 1
    MOVE = 2

class Limits(NamedTuple):
    low: float
    high: float = 3.0

WIDTH = 2.0
TABLE = (1.0, (2, 3.0))
""",
    "room_leaf": """
from housefly.numeric import compiled, compiled_with_arrays
from room_facts import Limits, Phase, TABLE, WIDTH
import room_facts

@compiled
def widened(value, factor=1.5):
    '''A docstring.'''
    if value < 0.0 and Phase.MOVE == 2:
        return Limits(TABLE[0], 1.0).low + TABLE[1][1]
    return factor * value * WIDTH + room_facts.WIDTH
""",
    "room_top": """
from housefly.numeric import compiled
from room_leaf import widened

@compiled
def doubled(value):
    return 2.0 * _inner(value)

@compiled
def _inner(value):
    return widened(value)
""",
}
NOTICED = {
    "a constant of an imported module": ("room_facts", "WIDTH = 2.0", "WIDTH = 2.5"),
    "a constant's type": ("room_facts", "WIDTH = 2.0", "WIDTH = 2"),
    "a number deep in a tuple": ("room_facts", "(2, 3.0)", "(2, 3.5)"),
    "an enum's value": ("room_facts", "MOVE = 2", "MOVE = 3"),
    "the order of fields": ("room_facts", "low: float\n", "middle: float\n    low: float\n"),
    "a field's default": ("room_facts", "high: float = 3.0", "high: float = 4.0"),
    "an argument's default": ("room_leaf", "factor=1.5", "factor=1.6"),
    "a callee's number": ("room_leaf", "value < 0.0", "value < 0.5"),
    "a callee's operator": ("room_leaf", "value * WIDTH", "value / WIDTH"),
    "a caller's number": ("room_top", "2.0 * _inner", "3.0 * _inner"),
    "how a callee is compiled": ("room_leaf", "@compiled", "@compiled_with_arrays"),
}
PLAIN = "def plain():\n    return 1"
OVERLOOKED = {
    "a docstring": ("room_leaf", "A docstring.", "Another one."),
    "a comment and the place in the file": ("room_leaf", "@compiled", "# why\n\n\n@compiled"),
    "a constant that it does not use": ("room_facts", "WIDTH = 2.0", "WIDTH = 2.0\nDEPTH = 1.0"),
    "a plain function beside it": (
        "room_top",
        "2.0 * _inner(value)",
        "2.0 * _inner(value)\n" + PLAIN,
    ),
}


def digest(folder: Path, monkeypatch: pytest.MonkeyPatch, *change: str) -> str:
    for name, text in SOURCES.items():
        if change and change[0] == name:
            assert change[1] in text
            text = text.replace(change[1], change[2])
        (folder / f"{name}.py").write_text(text)
        sys.modules.pop(name, None)
    monkeypatch.syspath_prepend(folder)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    top = importlib.import_module("room_top")
    return code_digest(top.doubled)


@pytest.mark.parametrize("change", NOTICED.values(), ids=NOTICED)
def test_what_changes_machine_code_changes_its_digest(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, change: tuple[str, str, str]
) -> None:
    assert digest(tmp_path, monkeypatch) != digest(tmp_path, monkeypatch, *change)


@pytest.mark.parametrize("change", OVERLOOKED.values(), ids=OVERLOOKED)
def test_what_machine_code_cannot_show_does_not_change_its_digest(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, change: tuple[str, str, str]
) -> None:
    assert digest(tmp_path, monkeypatch) == digest(tmp_path, monkeypatch, *change)


def test_compiled_code_follows_a_constant_of_an_imported_module_and_is_else_found_again(
    tmp_path: Path,
) -> None:
    for name, text in SOURCES.items():
        (tmp_path / f"{name}.py").write_text(text)
    assert in_a_new_process(tmp_path) == (2.0 * (1.5 * 2.0 + 2.0), 3)
    facts, leaf = tmp_path / "room_facts.py", tmp_path / "room_leaf.py"
    leaf.write_text(leaf.read_text().replace("@compiled", "# Only a comment.\n@compiled"))
    assert in_a_new_process(tmp_path) == (2.0 * (1.5 * 2.0 + 2.0), 0)
    facts.write_text(facts.read_text().replace("WIDTH = 2.0", "WIDTH = 4.0"))
    assert in_a_new_process(tmp_path) == (2.0 * (1.5 * 4.0 + 4.0), 3)


def in_a_new_process(folder: Path) -> tuple[float, int]:
    """Return the answer of compiled code, and how many functions were compiled for it."""
    kept = folder / "kept"
    before = set(kept.rglob("*.nbc"))
    done = subprocess.run(
        [sys.executable, "-c", "from room_top import doubled; print(doubled(1.0))"],
        env={**os.environ, "PYTHONPATH": str(folder), "NUMBA_CACHE_DIR": str(kept)},
        check=True,
        capture_output=True,
        text=True,
    )
    return float(done.stdout), len(set(kept.rglob("*.nbc")) - before)


ONLY_FOR_CALLERS = """
from room_top import _inner, doubled
doubled(1.0)
print(len(doubled.signatures), len(_inner.signatures))
print(_inner(1.0) == _inner.py_func(1.0), len(_inner.signatures))
"""


def test_machine_code_is_made_only_of_what_python_calls(tmp_path: Path) -> None:
    """At the second start the callee comes from disk, with the same values."""
    for name, text in SOURCES.items():
        (tmp_path / f"{name}.py").write_text(text)
    environment = {**os.environ, "PYTHONPATH": str(tmp_path), "NUMBA_CACHE_DIR": str(tmp_path)}
    for _ in range(2):
        done = subprocess.run(
            [sys.executable, "-c", ONLY_FOR_CALLERS],
            env=environment, capture_output=True, text=True, check=True,
        )  # fmt: skip
        assert done.stdout.split() == ["1", "0", "True", "1"]
    kept = [path.name for path in tmp_path.rglob("*.nbc")]
    assert sum(name.startswith("room_top._inner-") for name in kept) == 2, kept
