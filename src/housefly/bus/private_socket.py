"""A Unix socket between two processes of a run: who may talk there, and how messages are cut.

Each message is magic, kind, size of its body [bytes], body.
"""

from __future__ import annotations

import os
import socket
import struct
from pathlib import Path

from housefly.errors import LinkError, WireError

_HEADER = struct.Struct("<4sBI")


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


def framed(magic: bytes, kind: int, body: bytes) -> bytes:
    """Return a message with its header."""
    return _HEADER.pack(magic, kind, len(body)) + body


class FrameCutter:
    """Cuts a stream into messages.

    Args:
        magic: of both ends, four bytes.
        kinds: how many there are.
        body_max: longest body accepted [bytes].
    """

    def __init__(self, magic: bytes, kinds: int, body_max: int) -> None:
        self._magic, self._kinds, self._body_max = magic, kinds, body_max
        self._buffer = bytearray()

    def feed(self, data: bytes) -> list[tuple[int, bytes]]:
        """Append the next bytes; return kind and body of each message now complete, oldest first.

        Raises:
            WireError: no message of ours; the connection is of no use any more.
        """
        self._buffer += data
        messages: list[tuple[int, bytes]] = []
        while len(self._buffer) >= _HEADER.size:
            magic, kind, size = _HEADER.unpack_from(self._buffer)
            if magic != self._magic or kind >= self._kinds or size > self._body_max:
                raise WireError("the two ends do not speak the same language")
            end = _HEADER.size + size
            if len(self._buffer) < end:
                break
            messages.append((kind, bytes(memoryview(self._buffer)[_HEADER.size : end])))
            del self._buffer[:end]
        return messages
