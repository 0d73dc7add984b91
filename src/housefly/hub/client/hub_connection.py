"""A connection to the hub's query server on this machine: a line of JSON each way."""

from __future__ import annotations

import socket
from contextlib import suppress


class HubConnection:
    """Connects on the first question; not thread-safe.

    Args:
        path: of the hub's Unix socket.
        key: bearer token of the run.
        timeout: of one question [s].
    """

    def __init__(self, path: str, key: str, timeout: float) -> None:
        self._path, self._key, self._timeout = path, key, timeout
        self._socket: socket.socket | None = None

    def ask(self, question: str) -> str:
        """Return the answer; retries once on a new connection; raises OSError if there is none."""
        if self._socket is not None:
            with suppress(ConnectionError):
                return self._asked(self._socket, question)
        line = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            line.settimeout(self._timeout)
            line.connect(self._path)
        except OSError:
            line.close()
            raise
        self._socket = line
        return self._asked(line, f"{self._key}\n{question}")

    def close(self) -> None:
        """Close the connection."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def _asked(self, line: socket.socket, text: str) -> str:
        answer = bytearray()
        try:
            line.sendall(text.encode() + b"\n")
            while not answer.endswith(b"\n"):
                part = line.recv(65536)
                if not part:
                    raise ConnectionResetError("the hub hung up")
                answer += part
        except OSError:
            self.close()  # what comes late must not be taken for the answer to the next question
            raise
        return answer.decode()
