"""Every template of words in the source, by its syntax: what the pages need in each language."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import house
from housefly.messages.words import JOINED

MAKER = "Words"


class Made(NamedTuple):
    """One place where words are made: where, its template and the names that are given.

    ``template`` is None where it is no literal.
    """

    where: str
    template: str | None
    names: tuple[str, ...]


def made_words(folder: Path = house.PACKAGE) -> Iterator[Made]:
    """Yield every ``Words(...)`` of the source but those of ``messages/words.py``."""
    for path in sorted(folder.rglob("*.py")):
        if path.name == "words.py" and path.parent.name == "messages":
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and _name(node.func) == MAKER:
                yield _made(path, node)


def templates() -> set[str]:
    """Return every template of the source."""
    return {made.template for made in made_words() if made.template} | set(JOINED.values())


def _made(path: Path, call: ast.Call) -> Made:
    (first, *_) = call.args or [None]
    is_literal = isinstance(first, ast.Constant) and isinstance(first.value, str)
    template = first.value if is_literal and isinstance(first, ast.Constant) else None
    return Made(f"{path}:{call.lineno}", template, tuple(one.arg or "**" for one in call.keywords))


def _name(function: ast.expr) -> str:
    return function.id if isinstance(function, ast.Name) else getattr(function, "attr", "")
