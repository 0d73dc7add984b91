"""Keeps what was flown, row by row, so that the same command goes on where it was cut off."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import housefly
from housefly.errors import RecordingError
from quality_gate.flown_row import FlownRow, row_from_json

KEPT_FILE = "rows.jsonl"


_FLYING = ("flown_track", "fly", "leg_measures", "legs", "preset_way", "quality_flight", "rooms")
"""Modules of this package that decide how a row is flown and measured."""


def tree_digest() -> str:
    """Return a digest of the code that flies: a row flown by other code is flown again."""
    folder = Path(str(housefly.__file__)).parent
    digest = hashlib.sha256()
    for part in ("pilot", "twin", "config", "room"):
        for file in sorted((folder / part).rglob("*.py")):
            digest.update(file.read_bytes())
    for name in _FLYING:
        digest.update(Path(__file__).with_name(f"{name}.py").read_bytes())
    return digest.hexdigest()[:12]


def kept_rows(folder: Path) -> dict[tuple[str, str, str], FlownRow]:
    """Return what a folder holds, by row, way and key; a line cut short at the end is left out.

    Raises:
        RecordingError: a line in the middle cannot be read.
    """
    path = folder / KEPT_FILE
    if not path.exists():
        return {}
    rows: dict[tuple[str, str, str], FlownRow] = {}
    lines = path.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        try:
            row = row_from_json(json.loads(line))
        except (ValueError, KeyError, TypeError) as error:
            if number == len(lines):
                break
            raise RecordingError(f"{path}, line {number}: {error}; remove it to go on") from error
        rows[row.row, row.way, row.key] = row
    return rows


def keep_row(folder: Path, row: FlownRow) -> None:
    """Add a row to a folder, which is made when absent; a line that was cut short is dropped."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / KEPT_FILE
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    if text and not text.endswith("\n"):
        path.write_text(text[: text.rfind("\n") + 1], encoding="utf-8")
    with path.open("a", encoding="utf-8") as file:
        file.write(json.dumps(row.to_json()) + "\n")
