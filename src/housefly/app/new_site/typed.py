"""Numbers, sizes and keys out of a typed line; what they are not is refused in words."""

from __future__ import annotations

import re
from math import radians

from housefly.errors import ConfigError

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
_BY = r"\s*(?:m\s*)?(?:[x\u00d7]\s*|\s)"
SIZE = re.compile(rf"({_NUMBER}){_BY}({_NUMBER})(?:{_BY}({_NUMBER}))?(?:\s*m)?")
"""LENGTHxWIDTH or LENGTHxWIDTHxHEIGHT; a comma may be a decimal one, and so parts nothing."""
_KEYED = re.compile(r"""\s([a-z]+)=("[^"]*"|'[^']*'|\S+)""")


def after_word(word: str, text: str) -> str:
    """Return what stands behind a word at the beginning of a line, "" without it."""
    return text[len(word) + 1 :].strip() if text.startswith(f"{word} ") else ""


def split_keys(text: str, known: tuple[str, ...]) -> tuple[str, dict[str, str]]:
    """Return a text without its key=value words, and these; values with spaces have quotes."""
    keys = {key: unquoted(value) for key, value in _KEYED.findall(f" {text}") if key in known}
    rest = _KEYED.sub(lambda match: "" if match[1] in known else match[0], f" {text}").strip()
    return rest, keys


def unquoted(text: str) -> str:
    """Return a text without the quotes around it."""
    is_quoted = len(text) > 1 and text[0] == text[-1] and text[0] in "\"'"
    return text[1:-1] if is_quoted else text


def typed_number(text: str, key: str) -> float:
    """Return a number; raises ConfigError with its key."""
    if not re.fullmatch(_NUMBER, text):
        raise ConfigError(key, f"is {text!r}; allowed: a number")
    return float(text)


def typed_numbers(text: str, count: int, key: str, form: str) -> tuple[float, ...]:
    """Return so many numbers between commas [m]; raises ConfigError with the form."""
    parts = [part.strip() for part in text.split(",")]
    if len(parts) != count or not all(re.fullmatch(_NUMBER, part) for part in parts):
        raise ConfigError(key, f"is {text!r}; allowed: {form}, {count} numbers in metres")
    return tuple(float(part) for part in parts)


def typed_pair(text: str, key: str) -> tuple[float, float]:
    """Return x,y [m]; raises ConfigError."""
    x, y = typed_numbers(text, 2, key, "x,y")
    return x, y


def typed_angle(text: str) -> float:
    """Return an angle typed in degrees [rad]; raises ConfigError."""
    if text.endswith("deg"):
        return round(radians(typed_number(text[:-3], "angle")), 5)
    raise ConfigError("angle", f"is {text!r}; allowed: degrees, such as 90deg")


def unknown_words(name: str, names: list[str]) -> str:
    """Return in words that a name is not among those there are."""
    return f"nothing is called {name!r}; there are: {', '.join(names) or 'none'}"
