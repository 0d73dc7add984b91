"""The key of the webhooks: one for a site, kept over restarts, for doorbells and other programs."""

from __future__ import annotations

import os
import secrets
from pathlib import Path

_SHORTEST = 20


def webhook_key(file: Path) -> str:
    """Return the key in a file that only this user can read, made if missing.

    Raises:
        OSError: it can be neither read nor written.
    """
    file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
    try:
        with os.fdopen(
            os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW, 0o600), "w"
        ) as made:
            made.write(secrets.token_urlsafe(32) + "\n")
    except FileExistsError:
        pass
    with os.fdopen(os.open(file, os.O_RDONLY | os.O_NOFOLLOW)) as kept:
        key = kept.read(1000).strip()
    # A damaged file opens nothing.
    return key if len(key) >= _SHORTEST and key.isascii() and key.isprintable() else ""
