"""Which source flew the flights of a folder, and since when; all of a folder are of one source."""

from __future__ import annotations

import hashlib
import json
import os
import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Annotated

from pydantic import Field, TypeAdapter, ValidationError

import housefly
from housefly.errors import ConfigError, RecordingError

FLOWN_BY_FILE = "flown_by.json"
_UNKNOWN = "a source that is not known"

_PACKAGE = Path(housefly.__file__).parent
_LENGTH = 12
_LEFT_OUT = frozenset({"__pycache__", "node_modules"})
_NOT_INSTALLED = "web/client"
"""The source of the console's bundle: the bundle itself counts."""


@dataclass(frozen=True, slots=True)
class FlownBy:
    """What flies into a folder.

    Attributes:
        source: as ``source_digest`` names it.
        since: when the first flight began, local time.
    """

    source: Annotated[str, Field(pattern=r"^[0-9a-f]{12}$")]
    since: Annotated[str, Field(pattern=r"^[0-9]{4}-[0-9]{2}-[0-9]{2} [0-9]{2}:[0-9]{2}$")]

    def __str__(self) -> str:
        """Return it in words."""
        return f"source {self.source} since {self.since}"


_FLOWN_BY: TypeAdapter[FlownBy] = TypeAdapter(FlownBy)


def read_flown_by(folder: Path) -> FlownBy | None:
    """Return what flew into a folder, None where that is not known; raises RecordingError."""
    path = folder / FLOWN_BY_FILE
    if not path.exists():
        return None
    try:
        return _FLOWN_BY.validate_json(path.read_bytes())
    except ValidationError as error:
        raise RecordingError(
            f"{path} is damaged; without it the page says that the source is not known"
        ) from error


def claim_folder(folder: Path, *, has_flights: bool) -> None:
    """Write down that this source flies into a folder; raises ConfigError if another one did."""
    known, source = read_flown_by(folder), source_digest()
    if has_flights and (known is None or known.source != source):
        raise ConfigError(
            "--out",
            f"the flights in {folder} were flown by {known or _UNKNOWN}, and this is source"
            f" {source}: it cannot go on with them. Give another --out, remove the folder, or see"
            " its page alone with --seeds 0 --wires 0",
        )
    if not has_flights:
        folder.mkdir(parents=True, exist_ok=True)
        began = FlownBy(source, time.strftime("%Y-%m-%d %H:%M"))
        fresh = folder / f"{FLOWN_BY_FILE}.new"
        fresh.write_text(json.dumps(asdict(began)) + "\n", encoding="ascii")
        fresh.replace(folder / FLOWN_BY_FILE)


def flown_by_words(folder: Path) -> str:
    """Return what flew into a folder in words, and which source there is now if another one."""
    known, source = read_flown_by(folder), source_digest()
    if known is not None and known.source == source:
        return str(known)
    return f"{known or _UNKNOWN}; now it is {source}"


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
