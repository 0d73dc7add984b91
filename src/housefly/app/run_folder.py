"""Folders of a run: private, gone with the run, and tidied by the next one if it was killed."""

from __future__ import annotations

import atexit
import os
import re
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from housefly.hub.client.discovery import is_alive

_SOCKETS = "run"
_OWNED = re.compile(r"housefly-(?P<purpose>[a-z]+)-(?P<owner>\d+)-")
_QUIET = 60.0
"""In a folder that was not written to for this long no child of a killed run is at work [s]."""


def new_run_folder() -> Path:
    """Return a new folder (mode 0700) for a run's sockets, removed when this process ends.

    Folders of runs that were killed are removed too.
    """
    remove_left_behind()
    folder = _made(_SOCKETS)
    atexit.register(_remove, folder, os.getpid())
    return folder


@contextmanager
def temporary_run_folder(purpose: str) -> Iterator[Path]:
    """Yield a new folder (mode 0700) that is removed at the end of the block.

    Folders of runs that were killed are removed too.

    Args:
        purpose: what for, in small letters; it stands in the name.
    """
    remove_left_behind()
    folder = _made(purpose)
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def remove_left_behind() -> None:
    """Remove the folders of this user whose process is gone; logs when nobody writes them still."""
    for folder in Path(tempfile.gettempdir()).glob("housefly-*"):
        match = _OWNED.match(folder.name)
        if match is None:
            continue
        with suppress(OSError):
            is_ours = folder.lstat().st_uid == os.geteuid() and not folder.is_symlink()
            is_left = not is_alive(int(match["owner"]))
            if is_ours and is_left and (match["purpose"] == _SOCKETS or _is_quiet(folder)):
                shutil.rmtree(folder, ignore_errors=True)


def _made(purpose: str) -> Path:
    return Path(tempfile.mkdtemp(prefix=f"housefly-{purpose}-{os.getpid()}-"))


def _remove(folder: Path, owner: int) -> None:
    if os.getpid() == owner:  # not in a forked child
        shutil.rmtree(folder, ignore_errors=True)


def _is_quiet(folder: Path) -> bool:
    """Return whether nothing in a folder was written lately: children outlive a killed launcher."""
    written = max(file.lstat().st_mtime for file in (folder, *folder.rglob("*")))
    return time.time() - written > _QUIET
