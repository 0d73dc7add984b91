"""A path to a value in JSON: ``power``, ``ENERGY.Power.0``, ``params[0].value``."""

from __future__ import annotations

import re

_STEP = re.compile(r"(?P<key>[^\x00-\x1f.\[\]]{0,64})(?P<indices>(?:\[\d{1,4}\])*)")
_MOST_STEPS = 8
_SHOWN_KEYS = 8


class JsonPath:
    """Keys of nested objects with dots between them; an element of an array by its number.

    Args:
        text: the path; an element is ``name[0]`` or ``name.0``, and ``[0]`` at the beginning.

    Raises:
        ValueError: it is no path.
    """

    def __init__(self, text: str) -> None:
        self._text = text
        steps = [step for part in text.split(".") for step in _steps(part)]
        if not 0 < len(steps) <= _MOST_STEPS:
            raise ValueError(
                f"{text!r} is no path to a value; allowed: up to {_MOST_STEPS} keys with dots"
                " between them, an element of an array by its number, such as power, ENERGY.Power,"
                " ENERGY.Power.0 or params[0].value"
            )
        self._steps = tuple(steps)

    def __str__(self) -> str:
        return self._text

    def value_in(self, tree: object) -> object:
        """Return the value at the end of the path; raises LookupError that says what is there.

        A key that has dots itself goes before the path.
        """
        if isinstance(tree, dict) and self._text in tree:
            return tree[self._text]
        for number, step in enumerate(self._steps):
            inner = _inner(tree, step)
            if inner is _MISSING:
                there = ".".join(self._steps[: number + 1])
                raise LookupError(f"{there} is missing; {_contents(tree)}")
            tree = inner
        return tree


_MISSING = object()


def _steps(part: str) -> tuple[str, ...]:
    """Return the keys and numbers of what stands between two dots; none when it is no step."""
    match = _STEP.fullmatch(part)
    if match is None or not part:
        return ("",) * (_MOST_STEPS + 1)
    keys = (match["key"],) if match["key"] else ()
    return (*keys, *re.findall(r"\d+", match["indices"]))


def _inner(tree: object, step: str) -> object:
    if isinstance(tree, dict):
        return tree.get(step, _MISSING)
    if isinstance(tree, list) and step.isdecimal() and int(step) < len(tree):
        return tree[int(step)]
    return _MISSING


def _contents(tree: object) -> str:
    """Return what is there instead: the keys, or how many elements."""
    if isinstance(tree, dict):
        keys = [ascii(str(key)[:40])[1:-1] for key in list(tree)[:_SHOWN_KEYS]]
        more = " ..." if len(tree) > _SHOWN_KEYS else ""
        return f"there is {', '.join(keys)}{more}" if keys else "the object is empty"
    if isinstance(tree, list):
        return f"the array has {len(tree)} elements, from 0 on"
    return "what stands there holds no other value"
