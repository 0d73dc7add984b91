"""Files that a browser brings: a scan, a plan, a map with its picture; kept while the page runs."""

from __future__ import annotations

import re
from collections.abc import AsyncIterator
from pathlib import Path

from housefly.errors import RoomError
from housefly.messages.words import Words, figure

FILE_SIZE_MAX, FILES_MAX = 256 * 2**20, 16
"""Largest file [bytes], and most files."""
_NAME = re.compile(r"[\w][\w .()+-]{0,99}")


class Uploads:
    """The files of one page.

    Args:
        folder: where they are put; whoever starts the page removes it.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def path_of(self, name: str) -> Path:
        """Return where a file is; raises RoomError when there is none of that name."""
        path = self._folder / _checked(name)
        if not path.is_file():
            raise RoomError(Words("{name} did not arrive: choose the file again", name=repr(name)))
        return path

    async def keep(self, name: str, parts: AsyncIterator[bytes]) -> int:
        """Write a file and return its size [bytes].

        Raises:
            RoomError: its name is odd, or it is too large, or there are too many.
        """
        path = self._folder / _checked(name)
        others = [file for file in self._folder.iterdir() if file != path]
        if len(others) >= FILES_MAX:
            raise RoomError(
                Words("{n} files are here already: start the page again", n=figure(FILES_MAX))
            )
        try:
            return await _kept(path, parts)
        except BaseException:  # half a file, whose browser left or whose disk is full, is none
            path.unlink(missing_ok=True)
            raise


async def _kept(path: Path, parts: AsyncIterator[bytes]) -> int:
    size = 0
    with path.open("wb") as file:
        async for part in parts:
            size += len(part)
            if size > FILE_SIZE_MAX:
                raise RoomError(
                    Words(
                        "{name} is larger than {n} MiB: thin the scan out first, 5 cm between its"
                        " points are enough",
                        name=path.name,
                        n=figure(FILE_SIZE_MAX >> 20),
                    )
                )
            file.write(part)
    return size


def _checked(name: str) -> str:
    if not _NAME.fullmatch(name):
        raise RoomError(
            Words(
                "the file is called {name}; allowed: up to 100 letters, digits, spaces and"
                " . _ - + ( ), a letter or digit first",
                name=repr(name[:60]),
            )
        )
    return name
