"""What the frame check of a site found, kept beside the site's memory, and whether it still holds.

It holds for the tracking section that it was made with: a digest of it is kept, too.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from housefly.config.drone import DRONE_NAME
from housefly.config.durable import sync_file, sync_folder
from housefly.config.site import Site
from housefly.config.state import database_file
from housefly.config.text import read_text_file
from housefly.config.toml import parse_toml
from housefly.config.tracking import TrackingConfig
from housefly.errors import ConfigError
from housefly.messages.preflight import FRAMES_NOT_NEEDED, FrameCheckState, FramesKnown
from housefly.messages.words import literal

_DATABASE = "room.db"
_WORDS_MAX = 200


@dataclass(frozen=True, slots=True)
class FrameCheckRecord:
    """The outcome of one frame check.

    Attributes:
        checked_at: when, ISO 8601 with its zone.
        tracking: digest of the tracking section.
        findings: what was wrong, in words; empty when nothing was.
        notes: what could not be checked, in words.
        values: what was measured, with the unit in the name.
    """

    checked_at: str
    tracking: str
    findings: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    values: tuple[tuple[str, float], ...] = ()


def tracking_digest(tracking: TrackingConfig) -> str:
    """Return the SHA-256 of a tracking section, with its defaults."""
    text = json.dumps(tracking.model_dump(mode="json"), sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def frame_check_file(site: Site) -> Path:
    """Return where the outcome is kept: beside the memory of the site, one for each drone."""
    file, drone = database_file(site), site.drone.name
    name = "frames" if drone == DRONE_NAME else f"frames-{drone}"
    return file.with_name(f"{name}.toml" if file.name == _DATABASE else f"{file.stem}-{name}.toml")


def write_frame_check(site: Site, record: FrameCheckRecord) -> Path:
    """Keep an outcome in place of the last one; return its file. Raises OSError."""
    path = frame_check_file(site)
    path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
    lines = [
        "# The last frame check of this site, written by housefly preflight --frames.",
        f"checked_at = {_text(record.checked_at)}",
        f"tracking = {_text(record.tracking)}  # digest of [tracking]: it holds for that one only",
        f"findings = {_list(record.findings)}",
        f"notes = {_list(record.notes)}",
        "",
        "[measured]",
        *(f"{name} = {value!r}" for name, value in record.values),
    ]
    fresh = path.with_suffix(".new")
    fresh.write_text("\n".join(lines) + "\n", encoding="utf-8")
    sync_file(fresh)
    kept = fresh.replace(path)
    sync_folder(path.parent)
    return kept


def read_frame_check(site: Site) -> FrameCheckRecord | None:
    """Return the last outcome; None where there is none.

    Raises:
        ConfigError: its file cannot be read.
    """
    path = frame_check_file(site)
    try:
        text = read_text_file(path)
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        raise ConfigError("frame check", f"cannot be read: {error}", str(path)) from error
    tree = parse_toml(text, "frame check", str(path))
    values = tree.get("measured", {})
    if not isinstance(values, dict) or not isinstance(tree.get("tracking"), str):
        raise ConfigError("frame check", "is none; run the check again", str(path))
    return FrameCheckRecord(
        str(tree.get("checked_at", ""))[:_WORDS_MAX],
        tree["tracking"],
        _texts(tree.get("findings")),
        _texts(tree.get("notes")),
        tuple((name, float(v)) for name, v in values.items() if _is_number(v)),
    )


def frames_known(site: Site) -> FramesKnown:
    """Return what is known of the frames of a site, for the pre-flight checks."""
    if site.twin.enabled:
        return FRAMES_NOT_NEEDED
    try:
        record = read_frame_check(site)
    except ConfigError as error:
        return FramesKnown(FrameCheckState.NEVER, literal(str(error)))
    if record is None:
        return FramesKnown(FrameCheckState.NEVER)
    if record.tracking != tracking_digest(site.tracking):
        return FramesKnown(FrameCheckState.STALE, literal(record.checked_at))
    if record.findings:
        return FramesKnown(FrameCheckState.WRONG, literal(record.findings[0]))
    return FramesKnown(FrameCheckState.RIGHT, literal(record.checked_at))


def _text(words: str) -> str:
    """Return words as a TOML string; names of bodies may hold anything."""
    sane = words.encode("utf-8", "replace").decode()
    return json.dumps(sane, ensure_ascii=False).replace("\x7f", "\\u007f")


def _list(words: tuple[str, ...]) -> str:
    return f"[{', '.join(map(_text, words))}]"


def _is_number(value: Any) -> bool:
    """Return whether a value is a number that a float holds."""
    return isinstance(value, float) or (isinstance(value, int) and abs(value) < 2**53)


def _texts(found: Any) -> tuple[str, ...]:
    return tuple(str(words)[:_WORDS_MAX] for words in found) if isinstance(found, list) else ()
