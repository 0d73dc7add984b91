"""Who may log in: named users with a role and a hashed password, in a file of this user alone."""

from __future__ import annotations

import json
import logging
import os
import re
import tempfile
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from typing import Any

from housefly.config.durable import sync_folder
from housefly.config.text import read_text_file, shortened
from housefly.errors import ConfigError
from housefly.web.access.passwords import hashed, is_hash
from housefly.web.access.roles import Role

_LOG = logging.getLogger(__name__)
_NAME = re.compile(r"[a-z][a-z0-9_-]{0,23}")
_OPEN_TO_OTHERS = 0o077
MAX_USERS = 1000


@dataclass(frozen=True, slots=True)
class User:
    """Somebody who may log in."""

    name: str
    role: Role
    password_hash: str

    @property
    def fingerprint(self) -> str:
        """Return what changes with the password and tells nothing about it."""
        return sha256(self.password_hash.encode()).hexdigest()[:16]


class UserBook:
    """The users of a file; a change of the file counts at the next look."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self._seen: tuple[int, int, int] | None = None
        self._users: dict[str, User] = {}

    def find(self, name: str) -> User | None:
        """Return a user, or None; a file that cannot be read has none."""
        try:
            self._refresh()
        except ConfigError as error:
            _LOG.error("nobody can log in: %s", error)
            self._users, self._seen = {}, None
        return self._users.get(name)

    def all(self) -> tuple[User, ...]:
        """Return everybody by name.

        Raises:
            ConfigError: the file is damaged, or others may read it.
        """
        self._refresh()
        return tuple(self._users[name] for name in sorted(self._users))

    def put(self, name: str, role: Role, password: str) -> None:
        """Add a user or replace one; raises ConfigError for a bad name, password or file."""
        if not _NAME.fullmatch(name):
            raise ConfigError(
                "NAME",
                f"is {shortened(name, 40)!r}; allowed: a small letter, then up to 23 small letters,"
                " digits, - or _",
            )
        self._refresh()
        if name not in self._users and len(self._users) >= MAX_USERS:
            raise ConfigError("NAME", f"would be one too many; allowed: {MAX_USERS} users")
        self._write({**self._users, name: User(name, role, hashed(password))})

    def set_role(self, name: str, role: Role) -> None:
        """Give a user another role; raises ConfigError for an unknown one or a bad file."""
        self._write({**self._users, name: replace(self._known(name), role=role)})

    def remove(self, name: str) -> None:
        """Remove a user; raises ConfigError for an unknown one or a bad file."""
        gone = self._known(name)
        self._write({key: user for key, user in self._users.items() if user != gone})

    def _known(self, name: str) -> User:
        self._refresh()
        if name not in self._users:
            known = shortened(", ".join(sorted(self._users)) or "nobody")
            raise ConfigError("NAME", f"is {shortened(name, 40)!r}, who is no user; known: {known}")
        return self._users[name]

    def _refresh(self) -> None:
        try:
            found = self._file.lstat()
        except FileNotFoundError:
            self._users, self._seen = {}, None
            return
        except (OSError, ValueError) as error:
            raise self._error(getattr(error, "strerror", None) or str(error)) from error
        seen = (found.st_ino, found.st_ctime_ns, found.st_size)
        if seen != self._seen:
            if found.st_mode & _OPEN_TO_OTHERS or found.st_uid not in (os.geteuid(), 0):
                raise self._error(
                    f"other users may read or change it; `chmod 600 {self._file}`, and give"
                    " everybody a new password"
                )
            self._users, self._seen = self._read(), seen

    def _read(self) -> dict[str, User]:
        try:
            tree = json.loads(read_text_file(self._file))
            users = [_user_of(entry) for entry in tree["users"]]
        except OSError as error:
            raise self._error(f"cannot be read ({error.strerror})") from error
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            raise self._error(
                f"is damaged ({shortened(str(error), 80)}); remove it and add the users again"
            ) from error
        return {user.name: user for user in users}

    def _write(self, users: dict[str, User]) -> None:
        tree = [
            {"name": user.name, "role": user.role.value, "password": user.password_hash}
            for _, user in sorted(users.items())
        ]
        try:
            self._file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            descriptor, name = tempfile.mkstemp(dir=self._file.parent)  # mode 0600
            with os.fdopen(descriptor, "w", encoding="utf-8") as fresh:
                json.dump({"users": tree}, fresh, indent=1)
                fresh.flush()
                os.fsync(fresh.fileno())
            Path(name).replace(self._file)
            sync_folder(self._file.parent)
        except OSError as error:
            raise self._error(f"cannot be written ({error.strerror})") from error

    def _error(self, problem: str) -> ConfigError:
        return ConfigError("users", problem, shortened(str(self._file)))


def _user_of(entry: Any) -> User:
    name, role, password_hash = str(entry["name"]), Role(entry["role"]), str(entry["password"])
    if not _NAME.fullmatch(name) or not is_hash(password_hash):
        raise ValueError(f"user {name[:24]!r}")
    return User(name, role, password_hash)
