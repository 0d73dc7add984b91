"""Who may talk over a Unix socket: programs of the user who started the run."""

from __future__ import annotations

import os
import socket
import struct
from pathlib import Path

from housefly.errors import LinkError


def is_own_user(link: socket.socket) -> bool:
    """Return whether the program at the other end of a Unix socket runs as our user, or as root."""
    if not hasattr(socket, "SO_PEERCRED"):
        return True  # the folder's mode has to do
    credentials = link.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
    _, user, _ = struct.unpack("3i", credentials)
    return user in (os.geteuid(), 0)


def check_private(folder: Path) -> None:
    """Raise LinkError unless a folder belongs to our user, and nobody else can enter it."""
    status = folder.stat()
    if status.st_uid != os.geteuid() or status.st_mode & 0o077:
        raise LinkError(
            f"{folder} must belong to you alone (mode 0700): the processes of a run meet there"
        )
