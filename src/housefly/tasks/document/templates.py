"""Texts with parameters in them: ``$name`` is replaced, ``$$`` is a dollar sign."""

from __future__ import annotations

import re
from collections.abc import Callable

_USE = re.compile(r"\$(?:(\$)|([a-z][a-z0-9_]*))?")
_WHOLE = re.compile(r"\$([a-z][a-z0-9_]*)")


def names_in(text: str) -> tuple[str, ...]:
    """Return the names that a text uses, in order."""
    return tuple(match[2] for match in _USE.finditer(text) if match[2])


def lone_name(text: str) -> str:
    """Return the name when the whole text is ``$name``, else ""."""
    match = _WHOLE.fullmatch(text.strip())
    return match[1] if match else ""


def stray_dollar(text: str) -> bool:
    """Return whether a dollar sign stands before neither a name nor another one."""
    return any(not match[1] and not match[2] for match in _USE.finditer(text))


def with_values(text: str, value_of: Callable[[str], str | None]) -> str:
    """Return a text with its names replaced; a name without a value (None) stays as it is.

    ``$$`` stays, too: ``plain_text`` is the last step.
    """

    def replaced(match: re.Match[str]) -> str:
        value = value_of(match[2]) if match[2] else None
        return match[0] if value is None else value

    return _USE.sub(replaced, text)


def escaped(text: str) -> str:
    """Return a text that means itself."""
    return text.replace("$", "$$")


def plain_text(text: str, value_of: Callable[[str], str]) -> str:
    """Return a text for people: every name replaced, ``$$`` a dollar sign."""
    return _USE.sub(lambda match: value_of(match[2]) if match[2] else "$", text)
