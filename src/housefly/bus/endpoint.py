"""Where the bus of a run is: a Unix socket in a folder that only its user may enter."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from housefly.errors import LinkError

_SCHEME = "unixsock-stream/"
_MAX_PATH = 100
"""Longest path of a Unix socket [bytes]; the kernel takes 107."""


def endpoint_in(folder: Path) -> str:
    """Return the endpoint of a bus in a folder; raises LinkError if its path is too long."""
    path = str(folder / "bus")
    if len(os.fsencode(path)) > _MAX_PATH:
        raise LinkError(f"{path} is too long for a socket; allowed: {_MAX_PATH} bytes")
    return _SCHEME + path


def check_endpoint(endpoint: str) -> None:
    """Raise LinkError for an endpoint that somebody else could reach or hold."""
    if not endpoint.startswith(_SCHEME):
        raise LinkError(
            f"the bus cannot be at {endpoint!r}: only a Unix socket ({_SCHEME}PATH) tells who"
            " connects"
        )
    refuse_shared_folder(Path(endpoint.removeprefix(_SCHEME)).parent)


def refuse_shared_folder(folder: Path) -> None:
    """Raise LinkError unless a folder exists, is ours, and nobody else may enter it."""
    try:
        found = folder.stat()
    except OSError as error:
        raise LinkError(f"{folder} cannot hold the run's sockets: {error.strerror}") from error
    if found.st_uid != os.geteuid() or stat.S_IMODE(found.st_mode) & 0o077:
        raise LinkError(
            f"{folder} must belong to this user, and no other may enter it (mode 0700): whoever"
            " reaches the bus can fly the drone"
        )
