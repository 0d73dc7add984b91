"""Answers programs on the same machine over a line of their own: a question in JSON a line, an
answer in JSON a line.

Nobody stands between asker and hub, as pilot and console do on the bus and over HTTP. The first
line is the key of the run.
"""

from __future__ import annotations

import hmac
import socket
from collections.abc import Callable
from contextlib import suppress
from socketserver import StreamRequestHandler, ThreadingTCPServer
from threading import BoundedSemaphore, Lock, Thread

from housefly.errors import LinkError, WireError
from housefly.hub.api.room_json import refusal_to_json

MOST = 32
"""So many programs may ask at once."""
LONGEST = 64 * 1024
"""Of a question [bytes]."""
PATIENCE = 5.0
"""How long a program may take to show its key [s]."""


class Counter:
    """Serves on loopback from the start, on threads of its own, until closed.

    Args:
        answer: question to answer, both JSON; called on any thread.
        key: bearer token of the run.
        port: TCP port.

    Raises:
        LinkError: the port is taken.
    """

    def __init__(self, answer: Callable[[str], str], key: str, port: int) -> None:
        self.answer, self._key = answer, key.encode()
        self._lock, self._lines = Lock(), set[socket.socket]()
        try:
            self._server = _Server(("127.0.0.1", port), self)
        except OSError as error:
            raise LinkError(f"programs cannot ask on 127.0.0.1:{port}: {error.strerror}") from error
        Thread(target=self._server.serve_forever, name="counter", daemon=True).start()

    def close(self) -> None:
        """Hang up on everybody."""
        self._server.shutdown()
        self._server.server_close()
        with self._lock:
            for line in self._lines:
                with suppress(OSError):
                    line.shutdown(socket.SHUT_RDWR)

    def opens(self, key: bytes) -> bool:
        """Tell whether this is the key of the run."""
        return hmac.compare_digest(key.strip(), self._key)

    def came(self, line: socket.socket) -> None:
        """Note who is here."""
        with self._lock:
            self._lines.add(line)

    def left(self, line: socket.socket) -> None:
        """Note who has left."""
        with self._lock:
            self._lines.discard(line)


class _Server(ThreadingTCPServer):
    allow_reuse_address = True
    daemon_threads = True
    block_on_close = False

    def __init__(self, address: tuple[str, int], counter: Counter) -> None:
        self.counter, self.seats = counter, BoundedSemaphore(MOST)
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
    disable_nagle_algorithm = True
    server: _Server

    def handle(self) -> None:
        counter = self.server.counter
        counter.came(self.connection)
        try:
            with suppress(OSError):
                self._serve(counter)
        finally:
            counter.left(self.connection)

    def _serve(self, counter: Counter) -> None:
        self.connection.settimeout(PATIENCE)
        if not counter.opens(self.rfile.readline(LONGEST)):
            self._say(refusal_to_json(WireError("show the key of this run on the first line")))
            return
        self.connection.settimeout(None)
        while question := self.rfile.readline(LONGEST + 1):
            if len(question) > LONGEST:
                self._say(refusal_to_json(WireError(f"a question has at most {LONGEST} bytes")))
                return
            self._say(counter.answer(question.decode(errors="replace")))

    def _say(self, text: str) -> None:
        self.connection.sendall(text.encode() + b"\n")
