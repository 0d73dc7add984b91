"""Passwords as salted scrypt hashes (RFC 7914), in the text form of password hashing (PHC)."""

from __future__ import annotations

import hmac
import re
import secrets
from base64 import b64decode, b64encode
from hashlib import scrypt

from housefly.errors import ConfigError

SHORTEST, LONGEST = 10, 256
"""Length of a password [characters]."""
COST_LOG2, _BLOCK, _PARALLEL = 15, 8, 3
"""32 MiB and some 0.2 s: what OWASP recommends where 128 MiB are too many."""
_MAX_COST_LOG2, _MAX_BLOCK, _MAX_PARALLEL = 18, 16, 16
_SALT_SIZE, _KEY_SIZE = 16, 32
_FORM = re.compile(
    r"\$scrypt\$ln=(\d{1,2}),r=(\d{1,2}),p=(\d{1,2})\$([A-Za-z0-9+/]{22})\$([A-Za-z0-9+/]{43})"
)


def hashed(password: str) -> str:
    """Return a password's hash with a fresh salt; raises ConfigError for one too short or long."""
    if not SHORTEST <= len(password) <= LONGEST:
        raise ConfigError(
            "password",
            f"has {len(password)} characters; allowed: {SHORTEST} to {LONGEST} (four words that do"
            " not belong together are easy to keep in mind)",
        )
    salt = secrets.token_bytes(_SALT_SIZE)
    key = _derived(password, salt, COST_LOG2, _BLOCK, _PARALLEL)
    costs = f"ln={COST_LOG2},r={_BLOCK},p={_PARALLEL}"
    return f"$scrypt${costs}${_text(salt)}${_text(key)}"


def is_hash(text: str) -> bool:
    """Return whether a text is a hash of ours with costs that this machine can bear."""
    found = _FORM.fullmatch(text)
    return (
        found is not None
        and 1 <= int(found[1]) <= _MAX_COST_LOG2
        and 1 <= int(found[2]) <= _MAX_BLOCK
        and 1 <= int(found[3]) <= _MAX_PARALLEL
    )


def matches(password: str, hash_text: str) -> bool:
    """Return whether a password has a hash; takes as long for a wrong one as for the right one."""
    found = _FORM.fullmatch(hash_text)
    if found is None or len(password) > LONGEST:
        return False
    salt, key = _bytes(found[4]), _bytes(found[5])
    derived = _derived(password, salt, int(found[1]), int(found[2]), int(found[3]))
    return hmac.compare_digest(derived, key)


def _derived(password: str, salt: bytes, cost_log2: int, block: int, parallel: int) -> bytes:
    cost = 2**cost_log2
    return scrypt(
        password.encode(errors="surrogatepass"),
        salt=salt,
        n=cost,
        r=block,
        p=parallel,
        maxmem=128 * block * (cost + parallel + 2) + 2**20,
        dklen=_KEY_SIZE,
    )


def _text(data: bytes) -> str:
    return b64encode(data).decode().rstrip("=")


def _bytes(text: str) -> bytes:
    return b64decode(text + "=" * (-len(text) % 4))
