"""Which clips there are: found, kept, forgotten, and who watched them."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from housefly.config.tasks import TasksConfig
from housefly.errors import StoreError, TaskError
from housefly.evidence.clip_clock import ClockReading
from housefly.evidence.clip_export import ClipExport, exported
from housefly.evidence.clip_recovery import recover_clips
from housefly.evidence.clip_retention import ClipRetention
from housefly.evidence.clip_store import AuditEntry, ClipRow, ClipTable
from housefly.evidence.clip_values import (
    ClipInfo,
    ClipRefusal,
    ClipsAnswer,
    ClipsQuestion,
    DeleteClip,
    KeepClip,
)


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
        self._folder, self._wall = folder, wall
        self._table = ClipTable(folder)
        self._retention = ClipRetention(self._table, folder, config)

    @property
    def notices(self) -> tuple[str, ...]:
        """What people should know of the clips, in words; as of the last look."""
        return self._retention.notices

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
        """Return the clips that a question means, the newest first.

        Raises:
            TaskError: the clip that they should be older than is gone.
            StoreError: the index does not answer.
        """
        until = float("inf") if question.until is None else question.until
        before = self._whole(question.before) if question.before else None
        rows = self._table.rows(
            "whole AND began_at + duration >= ? AND began_at <= ?"
            " AND (? = '' OR place = ? COLLATE NOCASE) AND (? = '' OR thing = ? COLLATE NOCASE)"
            " AND (? = 0 OR task = ?) AND (? = '' OR EXISTS (SELECT 1 FROM json_each(people)"
            " WHERE value = ? COLLATE NOCASE)) AND (? = '' OR cause = ?)"
            " AND (? IS NULL OR (began_at, id) < (?, ?))",
            *(question.since, until, question.place, question.place),
            *(question.thing, question.thing, question.task, question.task),
            *(question.person, question.person, question.caused_by, question.caused_by),
            *((before.began_at, before.began_at, before.id) if before else (None, None, None)),
            limit=question.limit,
        )
        return ClipsAnswer(tuple(self._info(row) for row in rows))

    def file(self, name: str) -> Path:
        """Return the file of a clip; raises TaskError when there is none."""
        return self._folder / self._whole(name).file_name

    def info(self, name: str) -> ClipInfo:
        """Return what is known of a clip; raises TaskError when there is none."""
        return self._info(self._whole(name))

    def log_access(self, name: str, who: str, what: str = "watched") -> ClipInfo:
        """Write down who saw, copied or exported a clip; raises TaskError, StoreError."""
        row = self._whole(name)
        self._table.log(row.id, AuditEntry(self._wall(), who, what))
        return self._info(row)

    def export(self, names: Sequence[str], who: str) -> ClipExport:
        """Return clips to export, and write down who does; raises TaskError, StoreError."""
        return exported(self, names, who)

    def audit_log(self, name: str) -> tuple[AuditEntry, ...]:
        """Return who did what with a clip, also with one that is gone."""
        return self._table.audit_log(name)

    def keep(self, name: str, who: str, *, kept: bool = True) -> ClipInfo:
        """Keep a clip until somebody deletes it, or no longer; raises TaskError, StoreError."""
        row = replace(self._whole(name), kept=kept)
        self._table.put(row)
        self._table.log(row.id, AuditEntry(self._wall(), who, "kept" if kept else "not kept"))
        self._retention.update_notices()
        return self._info(row)

    def delete(self, name: str, who: str) -> ClipInfo:
        """Delete a clip at once, a kept one too; raises TaskError, StoreError."""
        row = self._whole(name)
        try:
            self._retention.remove(row)
        except OSError as error:
            raise StoreError(f"the clip {name} cannot be deleted: {error.strerror}") from error
        self._table.log(row.id, AuditEntry(self._wall(), who, "deleted"))
        self._retention.update_notices()
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
        """Delete what is too old at a time [Unix time, s], then the oldest of what is too much.

        Return their ids. May raise StoreError.
        """
        return self._retention.expire(now)

    def tidy(
        self, reading: ClockReading | None = None, *, is_right: bool = False
    ) -> tuple[str, ...]:
        """Delete what is too old now, as far as the clock is believed (``ClipRetention.tidy``)."""
        reading = ClockReading(self._wall()) if reading is None else reading
        return self._retention.tidy(reading, is_right=is_right)

    def recover(self) -> tuple[str, ...]:
        """Finish or remove what a crash left, and return the ids of clips that were finished.

        To be called before anything records. May raise StoreError and OSError.
        """
        return recover_clips(self._table, self._folder, self._wall)

    def _whole(self, name: str) -> ClipRow:
        rows = self._table.rows("id = ? AND whole", name)
        if not rows:
            raise TaskError(f"there is no clip {name!r}", ClipRefusal.NO_SUCH_CLIP.value)
        return rows[0]

    def _info(self, row: ClipRow) -> ClipInfo:
        return ClipInfo(
            *(row.id, row.kind, row.task, row.service, row.place, row.thing, row.people),
            *(row.cause, row.began_at, row.duration, row.size),
            keep_until=self._retention.keep_until(row),
            blanked=row.blanked,
            cut_off=row.cut_off,
            drone=row.drone,
        )
