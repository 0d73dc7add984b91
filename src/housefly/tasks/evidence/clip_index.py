"""Which clips there are: found, kept, forgotten, and who watched them."""

from __future__ import annotations

import logging
import re
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from housefly.config.tasks import TasksConfig
from housefly.errors import StoreError, TaskError
from housefly.tasks.api.answers import ClipInfo, ClipsAnswer
from housefly.tasks.api.questions import ClipsQuestion, DeleteClip, KeepClip
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.evidence.clip_store import ADOPTED, ClipRow, ClipTable, ClipView
from housefly.tasks.evidence.clip_writer import (
    CLIP_SUFFIX,
    PART_SUFFIX,
    duration_of,
    finish_leftover,
)
from housefly.tasks.evidence.snapshots import SNAPSHOT_SUFFIX

_LOG = logging.getLogger(__name__)
SUFFIXES = {"clip": CLIP_SUFFIX, "snapshot": SNAPSHOT_SUFFIX}
"""Kinds of evidence and how their files end."""
_NAME = re.compile(r"[0-9a-zA-Z-]{1,60}")
_DAY = 86_400.0
_GIGABYTE = 1e9


class ClipIndex:
    """The clips and snapshots of a folder; safe for several threads and processes.

    Args:
        folder: of the files; made if missing, mode 0700.
        config: how long and how much is kept.
        wall: the time now [Unix time, s].

    Raises:
        StoreError: the index cannot be opened.
    """

    def __init__(
        self, folder: Path, config: TasksConfig, wall: Callable[[], float] = time.time
    ) -> None:
        self._folder, self._config, self._wall = folder, config, wall
        self._table = ClipTable(folder)

    def close(self) -> None:
        """Close the index."""
        self._table.close()

    def answer(self, question: ClipsQuestion | KeepClip | DeleteClip) -> ClipsAnswer:
        """Return the answer to a question; raises TaskError, StoreError."""
        match question:
            case ClipsQuestion():
                return self.find(question)
            case KeepClip():
                return ClipsAnswer((self.keep(question.clip, question.by, kept=question.keep),))
            case DeleteClip():
                return ClipsAnswer((self.delete(question.clip, question.by),))

    def find(self, question: ClipsQuestion) -> ClipsAnswer:
        """Return the clips that a question means, the newest first; raises StoreError."""
        until = float("inf") if question.until is None else question.until
        rows = self._table.rows(
            "whole AND began_at + duration >= ? AND began_at <= ?"
            " AND (? = '' OR place = ? COLLATE NOCASE) AND (? = '' OR thing = ? COLLATE NOCASE)"
            " AND (? = 0 OR task = ?) AND (? = '' OR EXISTS (SELECT 1 FROM json_each(people)"
            " WHERE value = ? COLLATE NOCASE))",
            *(question.since, until, question.place, question.place),
            *(question.thing, question.thing, question.task, question.task),
            *(question.person, question.person),
        )
        return ClipsAnswer(tuple(self._info(row) for row in rows[: question.limit]))

    def file(self, name: str) -> Path:
        """Return the file of a clip; raises TaskError when there is none."""
        return self._path(self._whole(name))

    def info(self, name: str) -> ClipInfo:
        """Return what is known of a clip; raises TaskError when there is none."""
        return self._info(self._whole(name))

    def watched(self, name: str, who: str, what: str = "watched") -> ClipInfo:
        """Write down who saw, copied or exported a clip; raises TaskError, StoreError."""
        row = self._whole(name)
        self._table.saw(row.id, ClipView(self._wall(), who, what))
        return self._info(row)

    def views(self, name: str) -> tuple[ClipView, ...]:
        """Return who did what with a clip, also with one that is gone."""
        return self._table.views(name)

    def keep(self, name: str, who: str, *, kept: bool = True) -> ClipInfo:
        """Keep a clip until somebody deletes it, or no longer; raises TaskError, StoreError."""
        row = replace(self._whole(name), kept=kept)
        self._table.put(row)
        self._table.saw(row.id, ClipView(self._wall(), who, "kept" if kept else "not kept"))
        return self._info(row)

    def delete(self, name: str, who: str) -> ClipInfo:
        """Delete a clip at once, a kept one too; raises TaskError, StoreError."""
        row = self._whole(name)
        try:
            self._remove(row)
        except OSError as error:
            raise StoreError(f"the clip {name} cannot be deleted: {error.strerror}") from error
        self._table.saw(row.id, ClipView(self._wall(), who, "deleted"))
        return self._info(row)

    def begin(self, row: ClipRow) -> None:
        """Write down that a clip is being written; raises StoreError."""
        self._table.put(row)

    def finish(self, row: ClipRow) -> None:
        """Write down that a clip is whole; raises StoreError."""
        self._table.put(replace(row, whole=True))

    def forget(self, name: str) -> None:
        """Take back what was begun; raises StoreError."""
        self._table.remove(name)

    def expire(self, now: float) -> tuple[str, ...]:
        """Delete what is too old, then the oldest of what is too much; return their ids.

        Kept ones stay, and count as space, but not against those of the last day: else each new
        one would go as soon as it is whole. What cannot be deleted is tried again the next time.
        May raise StoreError.

        Args:
            now: [Unix time, s].
        """
        gone = []
        rows = self._table.rows("whole")  # the newest first
        space = sum(row.size for row in rows) - self._config.clip_space_gb * _GIGABYTE
        kept = sum(row.size for row in rows if row.kept)
        for row in reversed(rows):
            until = self._keep_until(row)
            excess = space - kept if row.began_at + row.duration > now - _DAY else space
            if until is None or (until > now and excess <= 0):
                continue
            try:
                self._remove(row)
            except OSError as error:
                _LOG.error("the clip %s cannot be deleted: %s", row.id, error)
                continue
            self._table.saw(row.id, ClipView(now, "housefly", "expired"))
            space -= row.size
            gone.append(row.id)
        if space > 0:
            _LOG.warning(
                "clips take more than tasks.clip_space_gb = %g: delete some of those that are kept",
                self._config.clip_space_gb,
            )
        return tuple(gone)

    def recover(self) -> tuple[str, ...]:
        """Finish or remove what a crash left, and return the ids of clips that were finished.

        To be called before anything records. May raise StoreError and OSError.
        """
        finished = []
        for row in self._table.rows("NOT whole"):
            path = self._path(row)
            part = path.with_name(row.id + PART_SUFFIX)
            try:
                if part.exists():
                    finish_leftover(part)
            except OSError as error:
                _LOG.error("the clip %s is tried again at the next start: %s", row.id, error)
                continue
            if path.exists() and path.stat().st_size:
                self._table.put(_measured(row, path))
                finished.append(row.id)
            else:
                path.unlink(missing_ok=True)
                self._table.remove(row.id)
        for row in self._table.rows("whole"):
            if not self._path(row).exists():
                self._table.remove(row.id)
        self._adopt_files()
        return tuple(finished)

    def _adopt_files(self) -> None:
        """Take up whole files that no row knows, and remove torn ones: nothing lies for ever."""
        known = {row.id for row in self._table.rows()}
        kinds = {suffix: kind for kind, suffix in SUFFIXES.items()}
        for path in sorted(self._folder.iterdir()):
            name, dot, suffix = path.name.partition(".")
            if name in known or not _NAME.fullmatch(name):
                continue
            if kind := kinds.get(dot + suffix):
                row = ClipRow(name, kind, 0, "", "", "", (), "", path.stat().st_mtime)
                self._table.put(_measured(row, path))
                # Whether somebody wanted it kept is lost: its days begin anew.
                self._table.saw(name, ClipView(self._wall(), "housefly", ADOPTED))
            elif suffix.startswith(("mp4.", "jpg.")):
                path.unlink(missing_ok=True)

    def _whole(self, name: str) -> ClipRow:
        rows = self._table.rows("id = ? AND whole", name)
        if not rows:
            raise TaskError(f"there is no clip {name!r}", ReasonCode.BAD_PARAMETER.value)
        return rows[0]

    def _path(self, row: ClipRow) -> Path:
        return self._folder / f"{row.id}{SUFFIXES[row.kind]}"

    def _remove(self, row: ClipRow) -> None:
        self._path(row).unlink(missing_ok=True)
        self._table.remove(row.id)

    def _keep_until(self, row: ClipRow) -> float | None:
        days = self._config.clip_days if row.kind == "clip" else self._config.snapshot_days
        since = max(row.began_at + row.duration, self._table.adopted_at(row.id))
        return None if row.kept else since + days * _DAY

    def _info(self, row: ClipRow) -> ClipInfo:
        return ClipInfo(
            *(row.id, row.kind, row.task, row.service, row.place, row.thing, row.people),
            *(row.cause, row.began_at, row.duration, row.size),
            keep_until=self._keep_until(row),
            blanked=row.blanked,
        )


def _measured(row: ClipRow, path: Path) -> ClipRow:
    duration = duration_of(path) if row.kind == "clip" else 0.0
    return replace(row, duration=duration, size=path.stat().st_size, whole=True)
