"""Checks names and passwords: on one thread, at most so often, and no faster for a wrong name."""

from __future__ import annotations

import asyncio
import ipaddress
import logging
import secrets
from collections import OrderedDict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

from housefly.clock import Clock
from housefly.errors import ConfigError
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.passwords import LONGEST, hashed, matches
from housefly.web.access.users import User, UserBook
from housefly.web.http.rate_limit import CommandLimiter

_LOG = logging.getLogger(__name__)

TRIES_PER_MINUTE = 5.0
"""Of one address, and of one name."""
TRIES_OF_ALL_PER_MINUTE = 60.0
_KEPT = 1000
"""Addresses, and names, whose tries are remembered; those of the longest ago are forgotten."""
_MAX_WAITING = 4
_SHOWN_LENGTH = 24


@dataclass(frozen=True, slots=True)
class LoginRefusal:
    """Why nobody was let in, in words; ``wait`` [s] when it was tried too often."""

    words: str
    wait: float = 0.0


WRONG = LoginRefusal("No user has this name and this password.")


@dataclass(slots=True)
class _Tries:
    """One bucket of tries a key; a try is paid for before the password is looked at."""

    limiters: OrderedDict[str, CommandLimiter] = field(default_factory=OrderedDict)

    def wait(self, key: str, now: float) -> float:
        """Take a try; return 0, or how long to wait for the next [s]."""
        limiter = self.limiters.pop(key, None) or _limiter(TRIES_PER_MINUTE, now)
        self.limiters[key] = limiter
        while len(self.limiters) > _KEPT:
            self.limiters.popitem(last=False)
        return _wait(limiter, now)


class Logins:
    """Lets users in.

    Args:
        users: who there is.
        clock: of the limits.
        audit: where every try is written down.
    """

    def __init__(self, users: UserBook, clock: Clock, audit: AuditLog | None = None) -> None:
        self._users, self._clock, self._audit = users, clock, audit
        self._thread = ThreadPoolExecutor(1, "passwords")
        self._waiting = 0
        self._of_address, self._of_name = _Tries(), _Tries()
        self._of_all = _limiter(TRIES_OF_ALL_PER_MINUTE, clock.now())
        self._nobody = hashed(secrets.token_urlsafe(24))

    @property
    def is_open(self) -> bool:
        """Whether there is anybody who could log in; a damaged file may have somebody."""
        try:
            return bool(self._users.all())
        except ConfigError:
            return True

    async def log_in(self, name: str, password: str, address: str) -> User | LoginRefusal:
        """Return the user, or why not.

        Args:
            name: as typed.
            password: as typed.
            address: IP address of who asks.
        """
        wait = self._wait(name, address)
        if wait > 0.0 or self._waiting >= _MAX_WAITING:
            refusal = LoginRefusal("Too many tries: wait a minute.", max(1.0, wait))
            self._record(name, address, "login refused: too many tries")
            return refusal
        user = self._users.find(name)
        fitting = await self._matches(password, user.password_hash if user else self._nobody)
        if user is None or not fitting:
            self._record(name, address, "login refused: wrong name or password")
            return WRONG
        self._record(name, address, "logged in")
        return user

    def close(self) -> None:
        """Shut the thread down without waiting."""
        self._thread.shutdown(wait=False, cancel_futures=True)

    async def _matches(self, password: str, password_hash: str) -> bool:
        loop = asyncio.get_running_loop()
        self._waiting += 1
        try:
            return await loop.run_in_executor(
                self._thread, matches, password[: LONGEST + 1], password_hash
            )
        finally:
            self._waiting -= 1

    def _wait(self, name: str, address: str) -> float:
        now = self._clock.now()
        of_address = self._of_address.wait(network_of(address), now)
        if of_address > 0.0:
            return of_address
        return self._of_name.wait(name[:LONGEST], now) or _wait(self._of_all, now)

    def _record(self, name: str, address: str, what: str) -> None:
        _LOG.info("%r from %s: %s", name[:_SHOWN_LENGTH], address, what)
        if self._audit is not None:
            self._audit.record(name[:_SHOWN_LENGTH], "", f"{what} ({address})")


def network_of(address: str) -> str:
    """Return what one machine cannot change at will: an IPv4 address, the /64 of an IPv6 one."""
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if isinstance(found, ipaddress.IPv4Address):
        return address
    if found.ipv4_mapped is not None:
        return str(found.ipv4_mapped)
    return str(ipaddress.ip_network((found, 64), strict=False))


def _limiter(per_minute: float, now: float) -> CommandLimiter:
    return CommandLimiter(per_minute, now, rate=per_minute / 60.0, burst=per_minute)


def _wait(limiter: CommandLimiter, now: float) -> float:
    if limiter.spend(now):
        return 0.0
    return (1.0 - limiter.tokens) / limiter.rate
