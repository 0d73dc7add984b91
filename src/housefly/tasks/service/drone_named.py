"""Which drone a sentence names, and what is left of it without that name."""

from __future__ import annotations

import re
from collections.abc import Iterable

_WITH = r"(?:\b(?:with|by|using|mit)\s+)?"
"""What may stand before a name, in English and German; Japanese has its own behind it."""
_BEHIND = r"(?:で|に|は|を)?[\s,:、]*"


def drone_named(text: str, drones: Iterable[str]) -> tuple[str, str]:
    """Return a sentence without the name of a drone, and that name; "" where it names none.

    "look at the sofa with red" is "look at the sofa" and "red".

    Args:
        text: as somebody said it.
        drones: their names; of a single drone none is ever named.
    """
    names = tuple(drones)
    for name in sorted(names, key=len, reverse=True) if len(names) > 1 else ():
        pattern = rf"{_WITH}(?<![\w-]){re.escape(name)}(?![a-z0-9_-]){_BEHIND}"
        rest, count = re.subn(pattern, " ", text, count=1, flags=re.IGNORECASE | re.ASCII)
        if count:
            return " ".join(rest.split()), name
    return text, ""
