"""A connection to the hub's query server on this machine: a line of JSON each way."""

from __future__ import annotations

import socket
from contextlib import suppress


class LoopbackConnection:
    """Connects on the first question; not thread-safe.

    Args:
        port: of the hub's query server on loopback.
        key: bearer token of the run.
        timeout: of one question [s].
    """

    def __init__(self, port: int, key: str, timeout: float) -> None:
        self._port, self._key, self._timeout = port, key, timeout
        self._socket: socket.socket | None = None

    def ask(self, question: str) -> str:
        """Return the answer; retries once on a new connection; raises OSError if there is none."""
        if self._socket is not None:
            with suppress(ConnectionError):
                return self._asked(self._socket, question)
        self._socket = socket.create_connection(("127.0.0.1", self._port), self._timeout)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return self._asked(self._socket, f"{self._key}\n{question}")

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
