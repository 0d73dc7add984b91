"""The path of STOP: one small signed datagram on loopback, past every queue of the bus.

Datagram: magic, time of sending [ns, monotonic clock of this machine], nonce, truncated
HMAC-SHA256 over all of it. The listener acts once on each authentic and fresh datagram and
acknowledges every copy of it; one on which it could not act is as good as not heard.
"""

from __future__ import annotations

import asyncio
import hashlib
import hmac
import ipaddress
import logging
import struct
import time
from collections.abc import Callable
from dataclasses import dataclass

from housefly.errors import ConfigError, LinkError, WireError

_log = logging.getLogger(__name__)
_Address = tuple[str, int]

STOP_MAGIC, ACKNOWLEDGED = b"HFs1", b"HFa1"
_BODY = struct.Struct("<4sQ8s")
_TAG_SIZE = 16
_FRESH_NS = 2_000_000_000
"""Older datagrams are replays, or too late to matter."""


def stop_key(secret: str) -> bytes:
    """Return the key of the path; raises ConfigError for a secret that is too short."""
    if len(secret) < 16:
        raise ConfigError("STOP secret", "must have at least 16 characters")
    return secret.encode()


@dataclass(frozen=True, slots=True)
class StopToken:
    """Identifies one STOP: its time [ns] and a nonce."""

    sent_ns: int
    nonce: bytes

    def signed(self, magic: bytes, secret: bytes) -> bytes:
        """Return the datagram."""
        body = _BODY.pack(magic, self.sent_ns, self.nonce)
        return body + hmac.digest(secret, body, hashlib.sha256)[:_TAG_SIZE]


def verified(data: bytes, magic: bytes, secret: bytes) -> StopToken:
    """Return the token of an authentic datagram; raises WireError for any other."""
    if len(data) != _BODY.size + _TAG_SIZE:
        raise WireError(f"a datagram of {len(data)} bytes is not a STOP")
    _, sent_ns, nonce = _BODY.unpack_from(data)
    token = StopToken(sent_ns, nonce)
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
        handler: called on the loop once for each STOP, and again by its copies while it fails; must
            be quick.
        is_held: whether a ``StopPort`` of this user keeps the port: then it is shared with that,
            and the caller sees to it that there is one listener only.

    Attributes:
        address: host and port, after ``start`` as chosen.
        ignored: datagrams that were not a fresh STOP of ours.

    Raises:
        ConfigError: the address is not a loopback address, or the secret is too short.
    """

    def __init__(
        self,
        host: str,
        port: int,
        secret: str,
        handler: Callable[[], None],
        *,
        is_held: bool = False,
    ) -> None:
        if not ipaddress.ip_address(host).is_loopback:
            raise ConfigError("STOP address", f"is {host}; only a loopback address is allowed")
        self.address: _Address = (host, port)
        self.ignored = 0
        self._secret = stop_key(secret)
        self._handler, self._is_held = handler, is_held
        self._seen: dict[StopToken, None] = {}
        self._transport: asyncio.DatagramTransport | None = None

    async def start(self) -> None:
        """Open the socket; raises LinkError if the port is taken."""
        try:
            self._transport, _ = await asyncio.get_running_loop().create_datagram_endpoint(
                lambda: _Protocol(self._received),
                local_addr=self.address,
                reuse_port=self._is_held or None,
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
            token = verified(data, STOP_MAGIC, self._secret)
        except WireError:
            self.ignored += 1
            return
        now = time.monotonic_ns()
        if abs(now - token.sent_ns) > _FRESH_NS:
            self.ignored += 1
            return
        if token not in self._seen:
            try:
                self._handler()
            except Exception:
                _log.exception("STOP could not be obeyed; its next copy tries again")
                return
            # Only now: a copy of what failed must act, and must not be acknowledged.
            self._seen = {
                known: None for known in self._seen if now - known.sent_ns <= _FRESH_NS
            } | {token: None}
        if self._transport is not None:
            self._transport.sendto(token.signed(ACKNOWLEDGED, self._secret), sender)


class _Protocol(asyncio.DatagramProtocol):
    def __init__(self, received: Callable[[bytes, _Address], None]) -> None:
        self._received = received

    def datagram_received(self, data: bytes, addr: _Address) -> None:
        self._received(data, addr)
