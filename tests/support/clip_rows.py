"""Clips whose files hold nothing, for tests of their index."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_result import ClipOrigin
from housefly.evidence.clip_store import ClipRow, new_clip_row
from housefly.evidence.clip_values import ClipsQuestion

NOW = 1_790_000_000.0
DAY = 86_400.0


def added(index: ClipIndex, folder: Path, row: ClipRow, size: int = 10) -> str:
    """Add a clip whose file holds nothing but zeros."""
    suffix = ".mp4" if row.kind == "clip" else ".jpg"
    (folder / (row.id + suffix)).write_bytes(bytes(size))
    index.finish(replace(row, size=size))
    return row.id


def clip(at: float, kind: str = "clip", **known: object) -> ClipRow:
    return replace(new_clip_row(kind, at, ClipOrigin(3, "look", "event-1")), **known)


def found(index: ClipIndex, **wanted: object) -> list[str]:
    return [info.id for info in index.find(ClipsQuestion(**wanted)).clips]
