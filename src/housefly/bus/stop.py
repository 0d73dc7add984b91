"""The path of STOP: one small signed datagram on loopback, past every queue of the bus.

Datagram: magic, time of sending [ns, monotonic clock of this machine], nonce, truncated
HMAC-SHA256 over all of it. The listener acts once on each authentic and fresh datagram and
acknowledges every copy of it.
"""

from __future__ import annotations

import asyncio
import hashlib
import hmac
import ipaddress
import secrets
import socket
import struct
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future, wait
from dataclasses import dataclass
from types import TracebackType
from typing import Self

from housefly.errors import ConfigError, LinkError, WireError

_Address = tuple[str, int]

_STOP, _ACKNOWLEDGED = b"HFs1", b"HFa1"
_BODY = struct.Struct("<4sQ8s")
_TAG_SIZE = 16
_FRESH_NS = 2_000_000_000
"""Older datagrams are replays, or too late to matter."""
_REPEATS = (0.005, 0.005, *[0.05] * 20)
"""Pauses [s] before each further copy, until an acknowledgement arrives."""


def _key(secret: str) -> bytes:
    if len(secret) < 16:
        raise ConfigError("STOP secret", "must have at least 16 characters")
    return secret.encode()


@dataclass(frozen=True, slots=True)
class _Token:
    """Identifies one STOP: its time [ns] and a nonce."""

    sent_ns: int
    nonce: bytes

    def signed(self, magic: bytes, secret: bytes) -> bytes:
        body = _BODY.pack(magic, self.sent_ns, self.nonce)
        return body + hmac.digest(secret, body, hashlib.sha256)[:_TAG_SIZE]


def _verified(data: bytes, magic: bytes, secret: bytes) -> _Token:
    """Return the token of an authentic datagram; raises WireError for any other."""
    if len(data) != _BODY.size + _TAG_SIZE:
        raise WireError(f"a datagram of {len(data)} bytes is not a STOP")
    _, sent_ns, nonce = _BODY.unpack_from(data)
    token = _Token(sent_ns, nonce)
    # The signature covers the magic too, so this comparison is the whole check.
    if not hmac.compare_digest(token.signed(magic, secret), data):
        raise WireError("the signature is wrong")
    return token


class StopListener:
    """Waits for STOP in the pilot's asyncio loop.

    Args:
        host: loopback address.
        port: UDP port; 0 chooses a free one.
        secret: shared with the senders, at least 16 characters.
        handler: called on the loop once for each STOP; must be quick.

    Attributes:
        address: host and port, after ``start`` as chosen.
        ignored: datagrams that were not a fresh STOP of ours.

    Raises:
        ConfigError: the address is not a loopback address, or the secret is too short.
    """

    def __init__(self, host: str, port: int, secret: str, handler: Callable[[], None]) -> None:
        if not ipaddress.ip_address(host).is_loopback:
            raise ConfigError("STOP address", f"is {host}; only a loopback address is allowed")
        self.address: _Address = (host, port)
        self.ignored = 0
        self._secret = _key(secret)
        self._handler = handler
        self._seen: dict[_Token, None] = {}
        self._transport: asyncio.DatagramTransport | None = None

    async def start(self) -> None:
        """Open the socket; raises LinkError if the port is taken."""
        try:
            self._transport, _ = await asyncio.get_running_loop().create_datagram_endpoint(
                lambda: _Protocol(self._received), local_addr=self.address
            )
        except OSError as error:
            raise LinkError(
                f"cannot listen for STOP on {self.address[0]}:{self.address[1]}: {error.strerror}"
            ) from error
        self.address = self._transport.get_extra_info("sockname")[:2]

    def close(self) -> None:
        """Close the socket; closing twice does no harm."""
        if self._transport is not None:
            self._transport.close()
            self._transport = None

    def _received(self, data: bytes, sender: _Address) -> None:
        try:
            token = _verified(data, _STOP, self._secret)
        except WireError:
            self.ignored += 1
            return
        now = time.monotonic_ns()
        if abs(now - token.sent_ns) > _FRESH_NS:
            self.ignored += 1
            return
        if token not in self._seen:
            self._seen = {
                known: None for known in self._seen if now - known.sent_ns <= _FRESH_NS
            } | {token: None}
            self._handler()
        if self._transport is not None:
            self._transport.sendto(token.signed(_ACKNOWLEDGED, self._secret), sender)


class _Protocol(asyncio.DatagramProtocol):
    def __init__(self, received: Callable[[bytes, _Address], None]) -> None:
        self._received = received

    def datagram_received(self, data: bytes, addr: _Address) -> None:
        self._received(data, addr)


class StopSender:
    """Sends STOP from any thread; as a context manager it leaves no STOP half sent.

    Args:
        host: where the listener is.
        port: its UDP port.
        secret: shared with the listener, at least 16 characters.

    Raises:
        ConfigError: the secret is too short.
    """

    def __init__(self, host: str, port: int, secret: str) -> None:
        self._address: _Address = (host, port)
        self._secret = _key(secret)
        self._pending: set[Future[bool]] = set()

    def send(self) -> Future[bool]:
        """Send STOP now and return; copies follow for about a second until it is acknowledged.

        Returns:
            A future: True once acknowledged, False if not.
        """
        link = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        link.connect(self._address)
        token = _Token(time.monotonic_ns(), secrets.token_bytes(8))
        datagram = token.signed(_STOP, self._secret)
        _transmit(link, datagram)
        outcome: Future[bool] = Future()
        self._pending.add(outcome)
        outcome.add_done_callback(self._pending.discard)
        threading.Thread(
            target=self._repeat, args=(link, token, datagram, outcome), name="stop", daemon=True
        ).start()
        return outcome

    def close(self) -> None:
        """Wait until every STOP is acknowledged or given up, at most about a second."""
        wait(tuple(self._pending))

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _repeat(
        self, link: socket.socket, token: _Token, datagram: bytes, outcome: Future[bool]
    ) -> None:
        with link:
            for pause in _REPEATS:
                if self._acknowledged(link, token, pause):
                    outcome.set_result(True)
                    return
                _transmit(link, datagram)
        outcome.set_result(False)

    def _acknowledged(self, link: socket.socket, token: _Token, patience: float) -> bool:
        deadline = time.monotonic() + patience
        while (left := deadline - time.monotonic()) > 0:
            link.settimeout(left)
            try:
                if _verified(link.recv(256), _ACKNOWLEDGED, self._secret) == token:
                    return True
            except TimeoutError:
                return False
            except (OSError, WireError):
                # Nobody listens yet, or somebody else talks to us: neither ends the wait.
                time.sleep(min(0.001, left))
        return False


def _transmit(link: socket.socket, datagram: bytes) -> None:
    try:
        link.send(datagram)
    except OSError:
        # The report that nobody listened to the copy before; the next copy may be heard.
        return
