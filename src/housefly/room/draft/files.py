"""The folder of a site that is being described: the draft is kept at every step."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from pathlib import Path
from shutil import copyfile
from typing import Any

from housefly.config.site import site_from_tree
from housefly.config.text import read_text_file
from housefly.errors import ConfigError, RoomError
from housefly.messages.words import Words, joined
from housefly.room.draft.alignment import rigid_fit
from housefly.room.draft.codec import draft_from_json, draft_to_json
from housefly.room.draft.missing import missing
from housefly.room.draft.model import SiteDraft
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_tree
from housefly.room.draft.suggestions import clearance_profile
from housefly.room.files import room_to_toml, toml_string

DRAFT_FILE = "draft.json"
SITE_FILE = "site.toml"
SIMULATED_FILE = "simulated.toml"
"""The same room with the simulated drone, beside a site with real hardware."""

_DRONE_REMARKS = {
    "kind": "its model: driver and airframe",
    "address": "where it answers",
    "profile": "measured by housefly identify",
}
_TRACKING_WORDS = {
    "kind": "the protocol of the motion capture system",
    "address": "the machine that runs its software",
    "body": "the drone's name in that software",
}


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
        raise RoomError(
            Words(
                "{name} cannot be read: {why}; mend it or move it away",
                name=str(path),
                why=str(error),
            )
        ) from error
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
        raise ConfigError(first.step.value, joined("; ", (first.words, first.mend)))
    texts = {"room.toml": _room_text(draft), SITE_FILE: _site_text(draft)}
    if draft.hardware:
        texts[SIMULATED_FILE] = _site_text(draft, simulated=True)
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
        raise RoomError(
            Words(
                "{name} cannot be kept as .old: {why}",
                name=str(path),
                why=error.strerror or str(error),
            )
        ) from error


def _written(path: Path, text: str) -> Path:
    new = path.with_name(f".{path.name}.new")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        new.write_text(text, encoding="utf-8")
        new.replace(path)
    except OSError as error:
        raise RoomError(
            Words(
                "{name} cannot be written: {why}",
                name=str(path),
                why=error.strerror or str(error),
            )
        ) from error
    return path


def _room_text(draft: SiteDraft) -> str:
    """Return the text of ``room.toml``; raises ConfigError while the size is unknown."""
    return (
        "# Made by `housefly new`, which keeps what it was told in draft.json beside this file and"
        " writes this\n# file anew each time it is asked again.\n"
        + room_to_toml(room_of_draft(draft))
    )


def _site_text(draft: SiteDraft, *, simulated: bool | None = None) -> str:
    """Return the text of the site file, every key with a word on why it is there.

    Args:
        draft: what was said.
        simulated: whether drone and tracking are simulated; None is as the draft has it.

    Raises:
        ConfigError: a value is missing or out of range.
    """
    tree = site_tree(draft, simulated=simulated)
    checked = {key: value for key, value in tree.items() if key != "drone"}
    site_from_tree(checked)
    return "\n".join(_lines(draft, tree)) + "\n"


def _lines(draft: SiteDraft, tree: dict[str, Any]) -> Iterator[str]:
    is_real = not tree["twin"]["enabled"]
    yield "# A site of Housefly, made by `housefly new`. Lengths in metres, angles in radians."
    yield "# Change it as you like: every key and its range is in docs/site.md."
    yield ""
    yield f"name = {_value(tree['name'])}"
    yield ""
    yield "[room]"
    yield f'model = "."    # room.toml beside this file: {_size_words(draft)}'
    yield ""
    yield from _map_lines(draft, tree["map"])
    yield ""
    yield "[limits]"
    yield _line("speed", tree["limits"]["speed"], "cruise speed [m/s]")
    yield _line("height_max", tree["limits"]["height_max"], "highest height to fly at")
    if "tracking" in tree:
        yield ""
        yield from _tracking_lines(draft, tree["tracking"])
    if "drone" in tree:
        yield ""
        yield "[drone]"
        for key, value in tree["drone"].items():
            yield _line(key, value, _DRONE_REMARKS[key])
    yield ""
    yield "[twin]"
    words = "real drone, real tracking" if is_real else "drone and tracking are simulated"
    yield _line("enabled", not is_real, words)
    yield _line("visitor_present", False, "nobody waits at a door")


def _map_lines(draft: SiteDraft, keys: dict[str, Any]) -> Iterator[str]:
    half = 0.25
    low, high = draft.flight_height - half, draft.flight_height + half
    yield "[map]"
    words = f"what stands between {low:.2f} and {high:.2f} m is flown around"
    yield _line("flight_height", keys["flight_height"], words)
    yield f"# Distances: {clearance_profile(draft).remark}."
    yield _line("resolution", keys["resolution"], "edge of a map cell")
    yield _line("tracking_bound", keys["tracking_bound"], "largest expected distance from the path")
    yield _line("margin", keys["margin"], "kept from everything, besides")
    for zone in keys["virtual_obstacles"]:
        yield ""
        yield "[[map.virtual_obstacles]]"
        yield _line("rectangle", zone["rectangle"], "x_min, y_min, x_max, y_max")
        yield _line("reason", zone["reason"])


def _tracking_lines(draft: SiteDraft, keys: dict[str, Any]) -> Iterator[str]:
    yield "[tracking]"
    for key in keys:
        if key not in ("x", "y", "z", "yaw"):
            yield _line(key, keys[key], _TRACKING_WORDS.get(key, ""))
    if "yaw" not in keys:
        yield "# Its frame is taken to be the map's; `housefly preflight --frames` compares them."
        return
    left = ", ".join(f"{100 * part:.1f}" for part in rigid_fit(draft.frame_points).residuals)
    yield (
        f"# Where its origin is on the map, from {len(draft.frame_points)} points; left over:"
        f" {left} cm."
    )
    for key in ("x", "y", "z"):
        yield _line(key, keys[key])
    yield _line("yaw", keys["yaw"], f"{degrees(keys['yaw']):+.1f} deg")


def _size_words(draft: SiteDraft) -> str:
    assert draft.bounds is not None
    x_min, y_min, x_max, y_max = draft.bounds
    size = f"{x_max - x_min:.2f} m x {y_max - y_min:.2f} m, {draft.height:.2f} m high"
    return f"{size}; from {draft.source}" if draft.source else size


def _line(key: str, value: Any, words: str = "") -> str:
    line = f"{key} = {_value(value)}"
    return f"{line:<27} # {words}" if words else line


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return toml_string(value)
    if isinstance(value, list):
        return "[" + ", ".join(_value(item) for item in value) + "]"
    return repr(value)
