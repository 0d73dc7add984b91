"""Whether a connection that a test holds is still open."""

from __future__ import annotations

import socket


def is_open(line: socket.socket) -> bool:
    """Return whether the other side has not closed a line that does not block."""
    try:
        return line.recv(1) != b""
    except BlockingIOError:
        return True
    except OSError:
        return False
