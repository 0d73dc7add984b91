"""One short word for the source of Housefly: what flew before a change has another one."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator
from pathlib import Path

import housefly

_PACKAGE = Path(housefly.__file__).parent
_LENGTH = 12
_LEFT_OUT = frozenset({"__pycache__", "node_modules"})
_NOT_INSTALLED = "web/client"
"""The source of the console's bundle: the bundle itself counts."""


def source_digest(package: Path = _PACKAGE) -> str:
    """Return the first characters of the SHA-256 of a package's files, names and contents."""
    digest = hashlib.sha256()
    for name in sorted(_names(package)):
        content = hashlib.sha256((package / name).read_bytes()).hexdigest()
        digest.update(f"{content} {name}\n".encode(errors="surrogateescape"))
    return digest.hexdigest()[:_LENGTH]


def _names(package: Path) -> Iterator[str]:
    """Yield the names of all files within the package, code and data."""
    for place, folders, files in os.walk(package):
        within = Path(place).relative_to(package)
        folders[:] = [
            name
            for name in folders
            if name not in _LEFT_OUT and (within / name).as_posix() != _NOT_INSTALLED
        ]
        yield from ((within / name).as_posix() for name in files)
