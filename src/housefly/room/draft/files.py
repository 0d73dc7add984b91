"""The folder of a site that is being described: the draft is kept at every step."""

from __future__ import annotations

from pathlib import Path
from shutil import copyfile

from housefly.config.text import read_text_file
from housefly.errors import ConfigError, RoomError
from housefly.room.draft.codec import draft_from_json, draft_to_json
from housefly.room.draft.missing import missing
from housefly.room.draft.model import SiteDraft
from housefly.room.draft.texts import room_text, site_text

DRAFT_FILE = "draft.json"
SIMULATED_FILE = "simulated.toml"
"""The same room with the simulated drone, beside a site with real hardware."""


def load_draft(folder: Path) -> SiteDraft | None:
    """Return the draft that a folder holds, or None.

    Raises:
        ConfigError: the file is no draft.
        RoomError: it cannot be read.
    """
    path = folder / DRAFT_FILE
    try:
        text = read_text_file(path)
    except FileNotFoundError:
        return None
    except (OSError, UnicodeDecodeError) as error:
        raise RoomError(f"{path} cannot be read: {error}; mend it or move it away") from error
    return draft_from_json(text, str(path))


def save_draft(draft: SiteDraft, folder: Path) -> Path:
    """Keep a draft in a folder, whole or not at all; raises RoomError where it cannot."""
    return _written(folder / DRAFT_FILE, draft_to_json(draft) + "\n")


def write_site(draft: SiteDraft, folder: Path) -> tuple[Path, ...]:
    """Write the files of a site that lacks nothing, and keep its draft; return their paths.

    A file that was there and said something else is kept as one that ends in ``.old``.

    Raises:
        ConfigError: something is missing that hinders a flight.
        RoomError: a file cannot be written.
    """
    hindrances = [item for item in missing(draft) if item.hinders]
    if hindrances:
        first = hindrances[0]
        raise ConfigError(first.step.value, f"{first.words}; {first.mend}")
    texts = {"room.toml": room_text(draft), "site.toml": site_text(draft)}
    if draft.hardware:
        texts[SIMULATED_FILE] = site_text(draft, simulated=True)
    paths = []
    for name, text in texts.items():
        path = folder / name
        _keep_old(path, text)
        paths.append(_written(path, text))
    save_draft(draft, folder)
    return tuple(paths)


def _keep_old(path: Path, text: str) -> None:
    """Copy a file that says something else, whatever its bytes are."""
    try:
        if path.is_file() and path.read_bytes() != text.encode():
            copyfile(path, path.with_name(f"{path.name}.old"))
    except OSError as error:
        raise RoomError(f"{path} cannot be kept as .old: {error.strerror or error}") from error


def _written(path: Path, text: str) -> Path:
    new = path.with_name(f".{path.name}.new")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        new.write_text(text, encoding="utf-8")
        new.replace(path)
    except OSError as error:
        raise RoomError(f"{path} cannot be written: {error.strerror or error}") from error
    return path
