"""Every template of words in the source, by its syntax: what the pages need in each language."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import house
from housefly.messages.words import JOINED

MAKER = "Words"
_OF_NEW_SITE = (
    "app/new_site/",
    "config/",
    "room/draft/",
    "room/edits.py",
    "room/ros_",
    "tracking/live_check.py",
    "web/new_site/",
)
"""What is said here reaches the page of a new site, or a terminal, and no console as words."""
_OF_BOTH = (
    "bus/reconnect.py",
    "drones/ardrone/driver.py",
    "drones/ardrone/limits_keeper.py",
    "drones/ardrone/settings.py",
    "drones/repeating_driver.py",
    "tracking/",
)
"""What tracking and drone say of themselves: to the live tests of the page of a new site, too."""


class Made(NamedTuple):
    """One place where words are made: its file and line, its template and the names that are given.

    ``template`` is None where it is no literal.
    """

    file: str
    line: int
    template: str | None
    names: tuple[str, ...]

    @property
    def is_on_console(self) -> bool:
        """Whether a console may show it."""
        return not self.file.startswith(_OF_NEW_SITE)

    @property
    def is_on_new_page(self) -> bool:
        """Whether the page of a new site may show it."""
        return self.file.startswith((*_OF_NEW_SITE, *_OF_BOTH))


@cache
def made_words(folder: Path = house.PACKAGE) -> tuple[Made, ...]:
    """Return every ``Words(...)`` of the source but those of ``messages/words.py``."""
    return tuple(_made_in(folder))


def _made_in(folder: Path) -> Iterator[Made]:
    for path in sorted(folder.rglob("*.py")):
        if path.name == "words.py" and path.parent.name == "messages":
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and _name(node.func) == MAKER:
                yield _made(path.relative_to(folder).as_posix(), node)


def console_templates() -> set[str]:
    """Return every template that a console may show."""
    made = made_words()
    return {one.template for one in made if one.template and one.is_on_console} | _JOINED


def new_page_templates() -> set[str]:
    """Return every template that the page of a new site may show."""
    made = made_words()
    return {one.template for one in made if one.template and one.is_on_new_page} | _JOINED


def short_name(english: str) -> int:
    """Return the name that the build gives a template, as ``client/src/messages/short.ts``."""
    number = 0
    for letter in english:
        number = ((number ^ ord(letter)) * 0x1000193) & 0xFFFFFFFF
    return number % 36**5


_JOINED = set(JOINED.values())


def _made(file: str, call: ast.Call) -> Made:
    (first, *_) = call.args or [None]
    is_literal = isinstance(first, ast.Constant) and isinstance(first.value, str)
    template = first.value if is_literal and isinstance(first, ast.Constant) else None
    return Made(file, call.lineno, template, tuple(one.arg or "**" for one in call.keywords))


def _name(function: ast.expr) -> str:
    return function.id if isinstance(function, ast.Name) else getattr(function, "attr", "")
