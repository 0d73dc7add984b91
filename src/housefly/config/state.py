"""Where a site keeps what it learns, on this machine."""

from __future__ import annotations

import os
from pathlib import Path

from housefly.config.site import Site

_DATABASE = "room.db"


def database_file(site: Site) -> Path:
    """Return the SQLite file of a site's memory, by default in the user's state folder."""
    if site.hub.store and "://" not in site.hub.store:
        return Path(site.hub.store).expanduser()
    state = Path(os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state")
    name = "".join(letter if letter.isalnum() else "-" for letter in site.name.lower())
    return state / "housefly" / name / _DATABASE


def edits_folder(site: Site) -> Path:
    """Return where the versions of a site's edits are: beside its memory, apart from others."""
    file = database_file(site)
    return file.with_name("edits" if file.name == _DATABASE else f"{file.stem}-edits")
