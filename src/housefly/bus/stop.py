"""STOP's own path: one small signed datagram on the loopback interface, past every queue of the bus.

Datagram: magic, time of sending [ns, monotonic clock of this machine], nonce, truncated HMAC-SHA256 over all of it.
The listener acts once on each authentic and fresh datagram and acknowledges every copy of it.
"""

from __future__ import annotations

import asyncio
import hashlib
import hmac
import ipaddress
import os
import secrets
import socket
import struct
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass

from housefly.errors import ConfigError, LinkError, WireError

Address = tuple[str, int]

SECRET_VARIABLE = "HOUSEFLY_STOP_SECRET"
"""Environment variable by which the launcher hands the secret to its processes."""

_STOP, _ACKNOWLEDGED = b"HFs1", b"HFa1"
_BODY = struct.Struct("<4sQ8s")
_TAG_SIZE = 16
_FRESH_NS = 2_000_000_000
"""Older datagrams are replays, or came too late to mean anything."""
_REPEATS = (0.005, 0.005, *[0.05] * 20)
"""Pauses [s] before each further copy, until an acknowledgement comes."""


def new_secret() -> bytes:
    """Return a fresh secret for one run of the launcher."""
    return secrets.token_bytes(32)


def secret_to_environment(secret: bytes) -> dict[str, str]:
    """Return the environment variable that hands the secret to a child process."""
    return {SECRET_VARIABLE: secret.hex()}


def secret_from_environment() -> bytes:
    """Return the secret that the launcher gave; raises ConfigError when it did not, or when it is too short."""
    try:
        secret = bytes.fromhex(os.environ.get(SECRET_VARIABLE, ""))
    except ValueError as error:
        raise ConfigError(SECRET_VARIABLE, "is not hexadecimal", "environment") from error
    if len(secret) < 16:
        raise ConfigError(SECRET_VARIABLE, "must hold at least 16 bytes in hexadecimal", "environment")
    return secret


@dataclass(frozen=True, slots=True)
class _Token:
    """What tells one STOP from another: its time [ns] and a nonce."""

    sent_ns: int
    nonce: bytes

    def signed(self, magic: bytes, secret: bytes) -> bytes:
        body = _BODY.pack(magic, self.sent_ns, self.nonce)
        return body + hmac.digest(secret, body, hashlib.sha256)[:_TAG_SIZE]


def _verified(data: bytes, magic: bytes, secret: bytes) -> _Token:
    """Return the token of an authentic datagram; raises WireError for any other."""
    if len(data) != _BODY.size + _TAG_SIZE:
        raise WireError(f"a datagram of {len(data)} bytes is not a STOP")
    found, sent_ns, nonce = _BODY.unpack_from(data)
    token = _Token(sent_ns, nonce)
    if found != magic or not hmac.compare_digest(token.signed(magic, secret), data):
        raise WireError("the signature is wrong")
    return token


class StopListener:
    """Waits for STOP in the pilot's asyncio loop.

    Args:
        address: loopback address and UDP port; port 0 chooses a free one.
        secret: shared with the senders.
        handler: called on the loop once for each STOP; must be quick.

    Raises:
        ConfigError: the address is not a loopback address.
    """

    def __init__(self, address: Address, secret: bytes, handler: Callable[[], None]) -> None:
        if not ipaddress.ip_address(address[0]).is_loopback:
            raise ConfigError("stop address", f"is {address[0]}; only a loopback address is allowed")
        self.address = address
        self.ignored = 0
        self._secret = secret
        self._handler = handler
        self._seen: dict[_Token, None] = {}
        self._transport: asyncio.DatagramTransport | None = None

    async def start(self) -> None:
        """Open the socket; raises LinkError when the port is taken."""
        try:
            self._transport, _ = await asyncio.get_running_loop().create_datagram_endpoint(
                lambda: _Protocol(self._received), local_addr=self.address
            )
        except OSError as error:
            raise LinkError(f"cannot listen for STOP on {self.address[0]}:{self.address[1]}: {error.strerror}") from error
        self.address = self._transport.get_extra_info("sockname")[:2]

    def close(self) -> None:
        """Close the socket; closing twice does no harm."""
        if self._transport is not None:
            self._transport.close()
            self._transport = None

    def _received(self, data: bytes, sender: Address) -> None:
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
            self._seen = {known: None for known in self._seen if now - known.sent_ns <= _FRESH_NS} | {token: None}
            self._handler()
        if self._transport is not None:
            self._transport.sendto(token.signed(_ACKNOWLEDGED, self._secret), sender)


class _Protocol(asyncio.DatagramProtocol):
    def __init__(self, received: Callable[[bytes, Address], None]) -> None:
        self._received = received

    def datagram_received(self, data: bytes, addr: Address) -> None:
        self._received(data, addr)


class StopSender:
    """Sends STOP from any thread.

    Args:
        address: where the listener is.
        secret: shared with the listener.
    """

    def __init__(self, address: Address, secret: bytes) -> None:
        self._address = address
        self._secret = secret

    def send(self) -> Future[bool]:
        """Send STOP now and return; copies follow in the background until it is acknowledged, for about a second.

        Returns:
            A future that becomes true with the acknowledgement, and false when none came.
        """
        link = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        link.connect(self._address)
        token = _Token(time.monotonic_ns(), secrets.token_bytes(8))
        datagram = token.signed(_STOP, self._secret)
        _transmit(link, datagram)
        outcome: Future[bool] = Future()
        threading.Thread(target=self._repeat, args=(link, token, datagram, outcome), name="stop", daemon=True).start()
        return outcome

    def _repeat(self, link: socket.socket, token: _Token, datagram: bytes, outcome: Future[bool]) -> None:
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
