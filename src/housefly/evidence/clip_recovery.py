"""What a crash left in the folder of clips: finished, taken up again, or removed."""

from __future__ import annotations

import logging
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from housefly.evidence.clip_store import ADOPTED, SUFFIXES, AuditEntry, ClipRow, ClipTable
from housefly.evidence.clip_writer import PART_SUFFIX, duration_of, finish_leftover

_LOG = logging.getLogger(__name__)
_NAME = re.compile(r"[0-9a-zA-Z-]{1,60}")
_KINDS = {suffix: kind for kind, suffix in SUFFIXES.items()}


def recover_clips(table: ClipTable, folder: Path, wall: Callable[[], float]) -> tuple[str, ...]:
    """Finish or remove what a crash left, and return the ids of clips that were finished.

    To be called before anything records. May raise StoreError and OSError.

    Args:
        table: of the clips.
        folder: of their files.
        wall: the time now [Unix time, s].
    """
    finished = []
    for row in table.rows("NOT whole"):
        try:
            is_there = _finish(folder / (row.id + PART_SUFFIX), folder / row.file_name)
        except OSError as error:
            _LOG.error("the clip %s is tried again at the next start: %s", row.id, error)
            continue
        if is_there:
            table.put(_measured(replace(row, cut_off=True), folder))
            finished.append(row.id)
        else:
            table.remove(row.id)
    for row in table.rows("whole"):
        if not (folder / row.file_name).exists():
            table.remove(row.id)
    finished += _adopted(table, folder, wall)
    return tuple(finished)


def _finish(part: Path, path: Path) -> bool:
    """Return whether there is something to keep; raises OSError when the disk refuses."""
    if part.exists():
        finish_leftover(part)
    if path.exists() and path.stat().st_size:
        return True
    path.unlink(missing_ok=True)
    return False


def _adopted(table: ClipTable, folder: Path, wall: Callable[[], float]) -> list[str]:
    """Take up files that no row knows, torn ones too; what is no picture is removed.

    Return the ids of those that were torn.
    """
    known = {row.id for row in table.rows()}
    torn = []
    for path in sorted(folder.iterdir()):
        name, dot, suffix = path.name.partition(".")
        if name in known or not _NAME.fullmatch(name):
            continue
        began = path.stat().st_mtime
        if is_torn := dot + suffix == PART_SUFFIX:
            try:
                finished = finish_leftover(path)
            except OSError as error:
                _LOG.error("the clip %s is tried again at the next start: %s", path, error)
                continue
            if finished is None:
                continue
            torn.append(name)
            suffix = finished.suffix.removeprefix(dot)
        if kind := _KINDS.get(dot + suffix):
            row = ClipRow(name, kind, 0, "", "", "", (), "", began, cut_off=is_torn)
            table.put(_measured(row, folder))
            # Whether somebody wanted it kept is lost: its days begin anew.
            table.log(name, AuditEntry(wall(), "housefly", ADOPTED))
        elif suffix.startswith(("mp4.", "jpg.")):
            path.unlink(missing_ok=True)
    return torn


def _measured(row: ClipRow, folder: Path) -> ClipRow:
    path = folder / row.file_name
    duration = duration_of(path) if row.kind == "clip" else 0.0
    return replace(row, duration=duration, size=path.stat().st_size, whole=True)
