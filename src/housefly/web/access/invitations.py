"""One-time links that expire, for another browser.

They are signed, not stored: the terminal makes them as well as the console, and a console that
restarts knows them still. What was used is kept, so that a picture of a link opens nothing.
"""

from __future__ import annotations

import hmac
import secrets
import struct
from base64 import urlsafe_b64decode, urlsafe_b64encode
from dataclasses import dataclass
from hashlib import sha256

from housefly.clock import Clock
from housefly.web.access.roles import Role
from housefly.web.access.session import EndedSessions

INVITATION_LIFE = 600.0
"""How long a link waits for its browser [s]."""
_HEAD = struct.Struct(">BI12s")
"""Role, the second after which it is over, chance."""
_SIGNATURE_SIZE = 16
_ROLES = tuple(Role)


@dataclass(frozen=True, slots=True)
class Invitation:
    """One link.

    Attributes:
        token: what its address carries.
        name: of the link; no secret.
        role: what its browser may do.
        until: when it is over, on the machine's monotonic clock [s].
    """

    token: str
    name: str
    role: Role
    until: float


class Invitations:
    """Makes links and takes each once.

    Args:
        secret: of the run; whoever knows it makes links.
        clock: of the machine, the same for all processes of the run.
        ended: where used links are kept, beside the sessions that are over.
    """

    def __init__(self, secret: str, clock: Clock, ended: EndedSessions | None = None) -> None:
        self._key = hmac.digest(secret.encode(), b"housefly invitation", sha256)
        self._clock = clock
        self._ended = EndedSessions() if ended is None else ended

    def new(self, role: Role) -> Invitation:
        """Return a fresh link."""
        until = int(self._clock.now() + INVITATION_LIFE)
        chance = secrets.token_bytes(12)
        head = _HEAD.pack(_ROLES.index(role), until, chance)
        token = urlsafe_b64encode(head + self._signature(head)).decode()
        return Invitation(token, chance.hex(), role, float(until))

    def redeemed(self, token: str) -> Invitation | None:
        """Return the link of a token and use it up; None for one that opens nothing (any more)."""
        found = self._read(token)
        if found is None or found.name in self._ended or self._clock.now() > found.until:
            return None
        self._ended.add(found.name)
        return found

    def _read(self, token: str) -> Invitation | None:
        try:
            raw = urlsafe_b64decode(token.encode("ascii"))
        except ValueError:  # no ASCII, or no base64
            return None
        head, signature = raw[: _HEAD.size], raw[_HEAD.size :]
        if not hmac.compare_digest(signature, self._signature(head)):
            return None
        role, until, chance = _HEAD.unpack(head)
        return Invitation(token, chance.hex(), _ROLES[role], float(until))

    def _signature(self, head: bytes) -> bytes:
        return hmac.digest(self._key, head, sha256)[:_SIGNATURE_SIZE]
