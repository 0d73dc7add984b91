"""Sends STOP: one socket, opened before anybody needs it, and one thread for the copies."""

from __future__ import annotations

import secrets
import selectors
import socket
import threading
import time
from concurrent.futures import Future, wait
from contextlib import suppress
from dataclasses import dataclass, field

from housefly.bus.stop import ACKNOWLEDGED, STOP_MAGIC, StopToken, stop_key, verified
from housefly.errors import LinkError, WireError

_REPEATS = (0.005, 0.005, *[0.05] * 20)
"""Pauses [s] before each further copy, until an acknowledgement arrives."""
_MAX_PENDING = 32
"""So many STOPs may wait for their acknowledgement; further ones are copies of the newest."""


@dataclass(eq=False, slots=True)
class _Sending:
    """A STOP that is not acknowledged yet: its datagram, and when the next copy is due [s]."""

    datagram: bytes
    due: float
    copies: int = 0
    outcome: Future[bool] = field(default_factory=Future)


class StopSender:
    """Sends STOP from any thread; ``close`` leaves no STOP half sent.

    A process that can open no further file and start no further thread can still send it.

    Args:
        host: where the listener is.
        port: its UDP port.
        secret: shared with the listener, at least 16 characters.

    Raises:
        ConfigError: the secret is too short.
        LinkError: there is no socket to be had.
    """

    def __init__(self, host: str, port: int, secret: str) -> None:
        self._secret = stop_key(secret)
        try:
            self._link = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            self._link.setblocking(False)
            self._link.connect((host, port))
            self._selector = selectors.DefaultSelector()
            self._selector.register(self._link, selectors.EVENT_READ)
        except OSError as error:
            raise LinkError(f"STOP cannot be sent to {host}:{port}: {error.strerror}") from error
        self._changed = threading.Condition()
        self._pending: dict[StopToken, _Sending] = {}
        self._closed = False
        self._thread = threading.Thread(target=self._run, name="stop", daemon=True)
        self._thread.start()

    def send(self) -> Future[bool]:
        """Send STOP now and return; copies follow for about a second until it is acknowledged.

        Returns:
            A future: True once acknowledged, False if not.
        """
        with self._changed:
            if len(self._pending) >= _MAX_PENDING:
                newest = next(reversed(self._pending.values()))
                self._transmit(newest.datagram)
                return newest.outcome
            token = StopToken(time.monotonic_ns(), secrets.token_bytes(8))
            datagram = token.signed(STOP_MAGIC, self._secret)
            self._transmit(datagram)
            sending = _Sending(datagram, time.monotonic() + _REPEATS[0])
            self._pending[token] = sending
            self._changed.notify()
            return sending.outcome

    def close(self) -> None:
        """Wait until every STOP is acknowledged or given up, at most about a second."""
        with self._changed:
            self._closed = True
            outcomes = [sending.outcome for sending in self._pending.values()]
            self._changed.notify()
        wait(outcomes)
        self._thread.join()
        self._selector.close()
        self._link.close()

    def _run(self) -> None:
        while True:
            with self._changed:
                while not self._pending:
                    if self._closed:
                        return
                    self._changed.wait()
                due = min(sending.due for sending in self._pending.values())
            if self._selector.select(max(0.0, due - time.monotonic())):
                self._receive()
            self._repeat()

    def _receive(self) -> None:
        try:
            token = verified(self._link.recv(256), ACKNOWLEDGED, self._secret)
        except (OSError, WireError):
            # Nobody listens yet, or somebody else talks to us: neither ends the wait.
            time.sleep(0.001)
            return
        with self._changed:
            sending = self._pending.pop(token, None)
        if sending is not None:
            sending.outcome.set_result(True)

    def _repeat(self) -> None:
        """Send the copies that are due, and give up what has had all of them."""
        now, lost = time.monotonic(), []
        with self._changed:
            for token, sending in tuple(self._pending.items()):
                if now < sending.due:
                    continue
                sending.copies += 1
                if sending.copies > len(_REPEATS):
                    lost.append(self._pending.pop(token))
                    continue
                self._transmit(sending.datagram)
                sending.due = now + _REPEATS[min(sending.copies, len(_REPEATS) - 1)]
        for sending in lost:
            sending.outcome.set_result(False)

    def _transmit(self, datagram: bytes) -> None:
        # The report that nobody listened to the copy before; the next copy may be heard.
        with suppress(OSError):
            self._link.send(datagram)
