"""Text from outside: files of a sane kind and size, and words without control characters."""

from __future__ import annotations

import errno
import os
import re
import stat
from collections.abc import Iterable
from difflib import SequenceMatcher, get_close_matches
from pathlib import Path
from typing import Any

from housefly.errors import ConfigError

_MAX_FILE_SIZE = 16 * 2**20
"""Largest text file that is read [bytes]."""
_PART = 2**20
"""Read at once [bytes]."""
_MAX_LENGTH = 4096
"""Longest text of one value, a path for example [characters]."""
_SIMILARITY_MIN, _SUGGESTIONS_MAX = 0.6, 3
"""Names at least this similar (0 to 1) are suggested, and so many at most."""
_MAX_DEPTH = 40
"""Deepest nesting of one value."""
_NUMBER = re.compile(r"\d+(?:[.,]\d+)*")
_MAX_SLASHES = 256
"""Most slashes in one value: folders are made one inside the other."""


def read_text_file(path: Path) -> str:
    """Return the content of an UTF-8 file.

    Raises:
        OSError: it cannot be read, is a device or a pipe, or is larger than 16 MiB.
        UnicodeDecodeError: it is not UTF-8.
    """
    return read_file(path).decode("utf-8")


def read_file(path: Path, size_max: int = _MAX_FILE_SIZE) -> bytes:
    """Return the bytes of a file of at most so many.

    Raises:
        OSError: it cannot be read, is a device or a pipe, or is larger.
    """
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    except (ValueError, UnicodeEncodeError) as error:
        raise OSError(errno.EINVAL, f"no possible name ({error})") from error
    with os.fdopen(descriptor, "rb") as file:
        found = os.fstat(descriptor)
        if stat.S_ISDIR(found.st_mode):
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        if not stat.S_ISREG(found.st_mode):
            raise OSError(errno.EINVAL, "no ordinary file")
        parts, left = list[bytes](), size_max + 1
        while part := file.read(min(left, _PART)):  # a read takes the memory that it may fill
            parts.append(part)
            left -= len(part)
    if left <= 0:
        raise OSError(errno.EFBIG, f"larger than {size_max / 2**20:.3g} MiB")
    return b"".join(parts)


def expanded(name: str, key: str) -> Path:
    """Return a path with its ``~`` expanded; raises ConfigError for the home of nobody."""
    try:
        return Path(name).expanduser()
    except RuntimeError as error:
        raise ConfigError(key, f"is {shortened(name)!r}: {error}") from error


def is_file(path: Path) -> bool:
    """Return whether a path is an ordinary file; an impossible name is none."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def refuse_odd_values(tree: Any, source: str = "", key: str = "", depth: int = 0) -> None:
    """Raise ConfigError for a text that no key may hold, and for endless nesting."""
    if depth > _MAX_DEPTH:
        raise ConfigError(shortened(key, 60), f"is nested deeper than {_MAX_DEPTH} levels", source)
    if isinstance(tree, str):
        _check(tree, key, source)
    elif isinstance(tree, dict):
        for name, value in tree.items():
            _check(str(name), f"{key or 'a'} key", source)
            refuse_odd_values(value, source, f"{key}.{name}" if key else str(name), depth + 1)
    elif isinstance(tree, list | tuple):
        for number, value in enumerate(tree):
            refuse_odd_values(value, source, f"{key}.{number}", depth + 1)


def _check(text: str, key: str, source: str) -> None:
    if len(text) > _MAX_LENGTH:
        raise ConfigError(
            key, f"has {len(text)} characters; allowed: {_MAX_LENGTH} at most", source
        )
    if text.count("/") > _MAX_SLASHES:
        raise ConfigError(
            key, f"has {text.count('/')} slashes; allowed: {_MAX_SLASHES} at most", source
        )
    if any(ord(letter) < 32 or letter == "\x7f" for letter in text):
        raise ConfigError(key, f"is {shortened(text)!r}; allowed: no control characters", source)
    if any("\ud800" <= letter <= "\udfff" for letter in text):
        raise ConfigError(key, f"is {shortened(text)!r}; allowed: text in UTF-8", source)


def shortened(text: str, length: int = 200) -> str:
    """Return a text of at most so many characters, for an error message."""
    return text if len(text) <= length else f"{text[: length - 4]} ..."


def without_numbers(words: str) -> str:
    """Return words with a # for each number: reasons that differ only in a number are one."""
    return _NUMBER.sub("#", words)


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Return ": did you mean 'fly'?" for what looks like a slip of the pen, or ""."""
    close = names_like(word, known)
    return f": did you mean {close}?" if close else ""


def names_like(word: str, known: Iterable[str]) -> str:
    """Return "'fly' or 'ply'" for what looks like a slip of the pen, or ""."""
    names = {name.casefold(): name for name in known}
    wanted = word.casefold()
    close = get_close_matches(wanted, names, _SUGGESTIONS_MAX, _SIMILARITY_MIN)
    likeness = [SequenceMatcher(None, one, wanted).ratio() for one in close]
    best = [one for one, alike in zip(close, likeness, strict=True) if alike > likeness[0] - 0.1]
    return _either([repr(names[one]) for one in best]) if best else ""


def _either(words: list[str]) -> str:
    *first, last = words
    return f"{', '.join(first)} or {last}" if first else last
