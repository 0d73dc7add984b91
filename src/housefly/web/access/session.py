"""One session; and what is over for good, also over a restart of the console."""

from __future__ import annotations

import logging
import os
from dataclasses import dataclass
from pathlib import Path

from housefly.web.access.roles import Role

_LOG = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Session:
    """Somebody who is in.

    Attributes:
        name: of the session, by chance.
        grant: what it was opened with, as it stands in the cookie.
        role: what it may do now.
        user: who logged in; "" for one that a link opened.
    """

    name: str
    grant: str
    role: Role
    user: str = ""

    @property
    def owner(self) -> str:
        """Return who is meant when sessions are counted: the user, or a browser with a link."""
        return f"~{self.user}" if self.user else self.name


class EndedSessions:
    """Names of sessions that are over, and of one-time links that were used.

    Args:
        file: where they are kept over a restart; None keeps them in memory only.
    """

    def __init__(self, file: Path | None = None) -> None:
        self._file = file
        self._names: set[str] = set()
        if file is not None and file.is_file():
            self._names.update(file.read_text(encoding="ascii", errors="replace").split())

    def __contains__(self, name: str) -> bool:
        return name in self._names

    def add(self, name: str) -> None:
        """End a session."""
        self._names.add(name)
        if self._file is None:
            return
        try:
            flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_NOFOLLOW
            with os.fdopen(os.open(self._file, flags, 0o600), "a", encoding="ascii") as file:
                file.write(f"{name}\n")
        except OSError as error:
            _LOG.error("a logout, or a used link, is not kept over a restart: %s", error.strerror)
