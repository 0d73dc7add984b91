"""The folder of a run's sockets: short, private, and gone with the run."""

from __future__ import annotations

import atexit
import os
import shutil
import tempfile
from contextlib import suppress
from pathlib import Path

from housefly.hub.client.discovery import is_alive

_PREFIX = "housefly-run-"


def new_run_folder() -> Path:
    """Return a new folder (mode 0700) that is removed when this process ends.

    Folders of runs that were killed are removed too.
    """
    _remove_left_behind()
    folder = Path(tempfile.mkdtemp(prefix=f"{_PREFIX}{os.getpid()}-"))
    atexit.register(_remove, folder, os.getpid())
    return folder


def _remove(folder: Path, owner: int) -> None:
    if os.getpid() == owner:  # not in a forked child
        shutil.rmtree(folder, ignore_errors=True)


def _remove_left_behind() -> None:
    for folder in Path(tempfile.gettempdir()).glob(f"{_PREFIX}*"):
        with suppress(OSError, ValueError):
            owner = int(folder.name.removeprefix(_PREFIX).partition("-")[0])
            if folder.lstat().st_uid == os.geteuid() and not is_alive(owner):
                shutil.rmtree(folder, ignore_errors=True)
