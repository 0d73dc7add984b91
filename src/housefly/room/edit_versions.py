"""Versions of a room's edits as files ``0001.json``, ``0002.json``, ..., never changed or deleted.

Version 0 is the room without edits. Undo saves a new version equal to the previous one. A file that
cannot be read is moved aside, reported, and the version before it counts; its number is not used
again.
"""

from __future__ import annotations

import json
import os
import re
import secrets
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from housefly.config.durable import sync_folder
from housefly.config.edits import Edits
from housefly.errors import EditsError, StaleEdits
from housefly.room.edits import edits_from_tree

_NUMBERED = re.compile(r"^(\d{4,9})\.json")
_DAMAGED_SUFFIX = ".damaged"
_NO_EDITS = Edits()
_DAMAGES = (ValueError, KeyError, TypeError, OverflowError, RecursionError, EditsError)
"""What a file that nobody should have touched can make of its reader."""


@dataclass(frozen=True, slots=True)
class EditVersion:
    """One saved state.

    Attributes:
        number: rises by one or more; 0 is the room without edits.
        edits: what applies.
        equals: the number of the version that an undo went back to; its own number when it was
            saved by hand.
        saved_at: Unix time [s].
        by: who saved it, as people see it.
    """

    number: int = 0
    edits: Edits = _NO_EDITS
    equals: int = 0
    saved_at: float = 0.0
    by: str = ""


class EditVersions:
    """The versions in a folder; any number of processes may read and save.

    Args:
        folder: where they are; made when something is saved.
        now: Unix time [s].
    """

    def __init__(self, folder: Path, now: Callable[[], float] = time.time) -> None:
        self.folder, self._now = folder, now
        self.problem = ""
        """What was found damaged, or ""."""

    def newest(self) -> EditVersion:
        """Return the current version; raises EditsError when the folder cannot be read."""
        for number in sorted(self._numbers()[0], reverse=True):
            if (found := self._read(number)) is not None:
                return found
        return EditVersion()

    def save(self, edits: Edits, based_on: int, by: str = "") -> EditVersion:
        """Save a new version.

        Raises:
            StaleEdits: somebody saved after version ``based_on``.
            EditsError: the disk refuses.
        """
        return self._save(edits, based_on, None, by)

    def undo(self, based_on: int, by: str = "") -> EditVersion:
        """Save a version equal to the previous one, and so on back; raises as ``save``."""
        before = self.before(self._checked(based_on))
        if before is None:
            raise EditsError("there is nothing to undo: this is the room as its file has it")
        return self._save(before.edits, based_on, before.equals, by)

    def before(self, version: EditVersion) -> EditVersion | None:
        """Return the version that undo would go back to, or None."""
        if version.equals == 0:
            return None
        for number in sorted((n for n in self._numbers()[0] if n < version.equals), reverse=True):
            if (found := self._read(number)) is not None:
                return found
        return EditVersion()

    def _checked(self, based_on: int) -> EditVersion:
        newest = self.newest()
        if newest.number != based_on:
            who = f" by {newest.by}" if newest.by else ""
            raise StaleEdits(
                f"version {newest.number} was saved{who} in between: look at it, then change it"
                " again"
            )
        return newest

    def _save(self, edits: Edits, based_on: int, equals: int | None, by: str) -> EditVersion:
        good, bad = self._numbers()
        number = max((*good, *bad, 0)) + 1
        self._checked(
            based_on
        )  # after the number was chosen: who saves from now on takes it, and the link below fails
        version = EditVersion(number, edits, number if equals is None else equals, self._now(), by)
        text = json.dumps({**_head(version), "edits": edits.model_dump(mode="json")}, indent=1)
        draft = self.folder / f".{number:04d}.{secrets.token_hex(4)}.draft"
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            with draft.open("w", encoding="utf-8") as file:
                file.write(text + "\n")
                file.flush()
                os.fsync(file.fileno())
            # A link, unlike a rename, does not replace what another writer has put there meanwhile.
            os.link(draft, self._path(number))
            sync_folder(self.folder)
        except FileExistsError as error:
            raise StaleEdits(
                f"version {number} was saved in between: look at it, then change it again"
            ) from error
        except OSError as error:
            raise EditsError(
                f"the edits cannot be saved in {self.folder}: {error.strerror}"
            ) from error
        finally:
            with suppress(OSError):
                draft.unlink()
        return version

    def _path(self, number: int) -> Path:
        return self.folder / f"{number:04d}.json"

    def _numbers(self) -> tuple[set[int], set[int]]:
        """Return the numbers of the versions, and those of damaged ones."""
        try:
            names = [path.name for path in self.folder.iterdir()]
        except FileNotFoundError:
            return set(), set()
        except OSError as error:
            raise EditsError(
                f"the edits in {self.folder} cannot be read: {error.strerror}"
            ) from error
        found = {name: int(match.group(1)) for name in names if (match := _NUMBERED.match(name))}
        good = {number for name, number in found.items() if name == f"{number:04d}.json"}
        return good, set(found.values()) - good

    def _read(self, number: int) -> EditVersion | None:
        path = self._path(number)
        try:
            tree: Any = json.loads(path.read_text(encoding="utf-8"))
            version = EditVersion(
                number,
                edits_from_tree(tree["edits"]),
                int(tree["equals"]),
                float(tree["saved_at"]),
                str(tree["by"]),
            )
            if not 0 <= version.equals <= number:
                raise ValueError(f"equals is {version.equals}; allowed: 0 to {number}")
        except FileNotFoundError:
            return None  # another process has just moved it aside
        except OSError as error:
            raise EditsError(f"{path} cannot be read: {error.strerror}") from error
        except _DAMAGES as error:
            self._move_aside(path, error)
            return None
        return version

    def _move_aside(self, path: Path, error: Exception) -> None:
        aside = path.with_name(path.name + _DAMAGED_SUFFIX)
        if aside.exists():
            aside = path.with_name(f"{path.name}{_DAMAGED_SUFFIX}.{secrets.token_hex(4)}")
        with suppress(OSError):
            path.rename(aside)
        self.problem = (
            f"{path.name} in {self.folder} is damaged ({error!s:.160}): it is now {aside.name}, and"
            " the version before it counts"
        )


def _head(version: EditVersion) -> dict[str, Any]:
    return {
        "version": version.number,
        "equals": version.equals,
        "saved_at": version.saved_at,
        "by": version.by,
    }
