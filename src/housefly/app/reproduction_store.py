"""What a reproduction has made already, in its folder: a run that was stopped goes on from there.

flights/NAME/    the recording of a flight, with made_from.json once it is complete
batch/           blocks of simulated drones
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from hashlib import sha256
from pathlib import Path

import housefly
from housefly.lab.reproduction.kept_flights import KeptFlights

_MADE_FROM = "made_from.json"
_DRAWING = ("lab/reproduction", "web")
"""Folders whose sources change no flight."""


class ReproductionStore:
    """The folder of a reproduction; what was made from other inputs or other code does not count.

    Args:
        folder: made if need be.
        inputs: what is reproduced, site and room, as text.
        fresh: whether to throw away what is there.

    Raises:
        OSError: the folder cannot be written to.
    """

    def __init__(self, folder: Path, inputs: str, *, fresh: bool = False) -> None:
        self._folder = folder
        self._made_from = {"inputs": _digest(inputs), "sources": sources_digest()}
        folder.mkdir(parents=True, exist_ok=True)
        if fresh:
            for name in ("flights", "batch"):
                with suppress(FileNotFoundError):
                    shutil.rmtree(folder / name)

    def flight_folder(self, name: str) -> Path:
        """Return where the recording of a flight goes."""
        return self._folder / "flights" / name

    def is_kept(self, name: str, settings: object = "") -> bool:
        """Return whether a flight is there, complete and made from the same settings."""
        try:
            text = (self.flight_folder(name) / _MADE_FROM).read_text(encoding="utf-8")
            return bool(json.loads(text) == self._inputs(settings))
        except (OSError, ValueError):
            return False

    def begin(self, name: str) -> Path:
        """Return the folder for a flight that is flown now; until ``keep`` it is not complete."""
        folder = self.flight_folder(name)
        with suppress(FileNotFoundError):
            (folder / _MADE_FROM).unlink()
        return folder

    def keep(self, name: str, settings: object = "") -> None:
        """Declare a flight complete."""
        path = self.flight_folder(name) / _MADE_FROM
        part = path.with_suffix(f".{os.getpid()}.part")
        part.write_text(json.dumps(self._inputs(settings), indent=1) + "\n", encoding="utf-8")
        part.replace(path)

    def batch(self, on_kept: Callable[[int], None]) -> KeptFlights:
        """Return what flies drones in batches; ``on_kept`` is told how many were there already."""
        return KeptFlights(self._folder / "batch", self._made_from["sources"], on_kept)

    def _inputs(self, settings: object) -> dict[str, str]:
        return {**self._made_from, "settings": repr(settings)}


@cache
def sources_digest() -> str:
    """Return a name for the state of every source that a flight depends on, as of the first call.

    What is edited while a program runs does not change that program.
    """
    package = Path(housefly.__file__).parent
    digest = sha256()
    for path in sorted(package.rglob("*.py")):
        name = path.relative_to(package).as_posix()
        if not name.startswith(_DRAWING):
            digest.update(name.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def _digest(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:16]
