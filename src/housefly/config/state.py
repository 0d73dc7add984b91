"""Where a site keeps what it learns, on this machine."""

from __future__ import annotations

import os
from pathlib import Path

from housefly.config.site import Site
from housefly.config.text import expanded
from housefly.errors import ConfigError

_DATABASE = "room.db"


def database_file(site: Site) -> Path:
    """Return the SQLite file of a site's memory, by default in the user's state folder.

    Raises ConfigError for a path that can be none of a file.
    """
    if site.hub.store and "://" not in site.hub.store:
        try:
            path = Path(site.hub.store).expanduser()
            is_possible = path.name not in ("", "..") and not path.is_dir()
        except (RuntimeError, OSError) as error:  # an unknown home, a name that is too long
            words = getattr(error, "strerror", None) or str(error)
            raise ConfigError("hub.store", f"is {site.hub.store!r}: {words}") from error
        if not is_possible:
            raise ConfigError("hub.store", f"is {site.hub.store!r}; allowed: the path of a file")
        return path
    state = Path(os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state")
    name = "".join(letter if letter.isalnum() else "-" for letter in site.name.lower())
    return state / "housefly" / name / _DATABASE


def users_file(site: Site) -> Path:
    """Return the file of those who may log in to a site's console."""
    if not site.web.users:
        return edits_folder(site).with_name("users.json")
    return expanded(site.web.users, "web.users")


def edits_folder(site: Site) -> Path:
    """Return where the versions of a site's edits are: beside its memory, apart from others."""
    file = database_file(site)
    return file.with_name("edits" if file.name == _DATABASE else f"{file.stem}-edits")


def tls_folder(site: Site) -> Path:
    """Return where a site's certificate and its authority are: beside its memory."""
    return edits_folder(site).with_name("tls")


def tasks_folder(site: Site) -> Path:
    """Return where a site keeps its queue, its rules' memory and its clips: beside its memory."""
    file = database_file(site)
    return file.with_name("tasks" if file.name == _DATABASE else f"{file.stem}-tasks")


def clips_folder(site: Site) -> Path:
    """Return where a site keeps its clips and snapshots, and the index of them."""
    return tasks_folder(site) / "clips"


def flights_folder(site: Site) -> Path:
    """Return where a site keeps the logs of its flights: beside its memory."""
    file = database_file(site)
    return file.with_name("flights" if file.name == _DATABASE else f"{file.stem}-flights")


def webhook_key_file(site: Site) -> Path:
    """Return the file of the key that webhooks of a site must show."""
    return tasks_folder(site) / "webhook-key"
