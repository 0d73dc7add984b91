"""Answers programs of this user over a Unix socket: a line of JSON each way.

It bypasses the pilot and the console, which the bus and HTTP go through. The first line is the key
of the run.
"""

from __future__ import annotations

import hmac
import socket
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from socketserver import StreamRequestHandler, ThreadingUnixStreamServer
from threading import BoundedSemaphore, Lock, Thread

from housefly.bus.endpoint import refuse_shared_folder
from housefly.errors import LinkError, WireError
from housefly.hub.api.json import refusal_to_json

MAX_CONNECTIONS = 32
"""At most this many programs are connected."""
MAX_QUESTION_SIZE = 64 * 1024
"""Longest question [bytes]."""
_KEY_TIMEOUT = 5.0
"""How long a program may take to send its key [s]."""


class QueryServer:
    """Serves on a Unix socket, on threads of its own, until closed.

    Args:
        answer: maps a question to an answer, both JSON; called on any thread.
        key: bearer token of the run.
        path: of the socket, in a folder that only this user may enter; one that a killed hub left
            behind is replaced.

    Raises:
        LinkError: the socket cannot be made, or others could reach it.
    """

    def __init__(self, answer: Callable[[str], str], key: str, path: Path) -> None:
        self.answer, self._key = answer, key.encode()
        self._lock, self._connections = Lock(), set[socket.socket]()
        refuse_shared_folder(path.parent)
        try:
            path.unlink(missing_ok=True)
            self._server = _Server(str(path), self)
        except OSError as error:
            raise LinkError(f"programs cannot ask at {path}: {error.strerror or error}") from error
        Thread(target=self._server.serve_forever, name="server", daemon=True).start()

    def close(self) -> None:
        """Close all connections."""
        self._server.shutdown()
        self._server.server_close()
        with self._lock:
            for line in self._connections:
                with suppress(OSError):
                    line.shutdown(socket.SHUT_RDWR)

    def accepts_key(self, key: bytes) -> bool:
        """Return whether this is the key of the run."""
        return hmac.compare_digest(key.strip(), self._key)

    def add_connection(self, line: socket.socket) -> None:
        """Register an open connection."""
        with self._lock:
            self._connections.add(line)

    def remove_connection(self, line: socket.socket) -> None:
        """Forget a closed connection."""
        with self._lock:
            self._connections.discard(line)


class _Server(ThreadingUnixStreamServer):
    daemon_threads = True
    block_on_close = False

    def __init__(self, address: str, server: QueryServer) -> None:
        self.server, self.seats = server, BoundedSemaphore(MAX_CONNECTIONS)
        super().__init__(address, _Line)

    def verify_request(self, request: object, client_address: object) -> bool:
        return self.seats.acquire(blocking=False)

    def process_request_thread(
        self, request: socket.socket | tuple[bytes, socket.socket], client_address: object
    ) -> None:
        try:
            super().process_request_thread(request, client_address)
        finally:
            self.seats.release()


class _Line(StreamRequestHandler):
    server: _Server

    def handle(self) -> None:
        server = self.server.server
        server.add_connection(self.connection)
        try:
            with suppress(OSError):
                self._serve(server)
        finally:
            server.remove_connection(self.connection)

    def _serve(self, server: QueryServer) -> None:
        self.connection.settimeout(_KEY_TIMEOUT)
        if not server.accepts_key(self.rfile.readline(MAX_QUESTION_SIZE)):
            self._say(refusal_to_json(WireError("show the key of this run on the first line")))
            return
        self.connection.settimeout(None)
        while question := self.rfile.readline(MAX_QUESTION_SIZE + 1):
            if len(question) > MAX_QUESTION_SIZE:
                self._say(
                    refusal_to_json(WireError(f"a question has at most {MAX_QUESTION_SIZE} bytes"))
                )
                return
            self._say(server.answer(question.decode(errors="replace")))

    def _say(self, text: str) -> None:
        self.connection.sendall(text.encode() + b"\n")
