"""How long clips are kept: by age, by the space they take, and never by a clock that leapt."""

from __future__ import annotations

import logging
import time
from pathlib import Path

from housefly.config.tasks import TasksConfig
from housefly.errors import HouseflyError
from housefly.evidence.clip_clock import PROOF_TIME, BelievedTime, ClockReading
from housefly.evidence.clip_store import ADOPTED, AuditEntry, ClipRow, ClipTable

_LOG = logging.getLogger(__name__)
_DAY = 86_400.0
_UNPLAYABLE_DAYS = 1.0
"""What a crash left and nothing here can play is kept so long, for whoever can."""
_GIGABYTE = 1e9


class ClipRetention:
    """Deletes what is too old and the oldest of what is too much; thread-safe.

    Args:
        table: of the clips.
        folder: of their files.
        config: how long and how much is kept.

    Attributes:
        notices: what people should know, in words: no space, a clock that leapt.
    """

    def __init__(self, table: ClipTable, folder: Path, config: TasksConfig) -> None:
        self.notices: tuple[str, ...] = ()
        self._table, self._folder, self._config = table, folder, config

    def keep_until(self, row: ClipRow) -> float | None:
        """Return when a clip is deleted [Unix time, s]; None is kept. Raises StoreError."""
        if row.kept:
            return None
        adopted = self._table.adopted_at(row.id)
        end = row.began_at + row.duration
        # What a clock that was wrong put into the future ages from when that was found out.
        since = adopted if adopted and end > adopted + _DAY else max(end, adopted)
        return since + self._days(row) * _DAY

    def tidy(self, reading: ClockReading, *, is_right: bool = False) -> tuple[str, ...]:
        """Delete what a clock that may be wrong allows to delete, and return the ids.

        Args:
            reading: of the clocks.
            is_right: whether a person says that the wall clock is right.

        Raises:
            StoreError: the index does not answer.
        """
        now = reading.now
        before = self._table.believed_time() or BelievedTime(self._newest(now))
        time_now = BelievedTime(now) if is_right else before.after(reading)
        self._table.believe(time_now)
        if time_now.doubted is None:
            self._age_future_clips_from(now)
        gone = self.expire(time_now.believed)
        self.update_notices()
        return gone

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
        space = sum(row.size for row in rows) - self._budget
        kept = sum(row.size for row in rows if row.kept)
        for row in reversed(rows):
            until = self.keep_until(row)
            excess = space - kept if row.began_at + row.duration > now - _DAY else space
            if until is None or (until > now and excess <= 0):
                continue
            try:
                self.remove(row)
            except OSError as error:
                _LOG.error("the clip %s cannot be deleted: %s", row.id, error)
                continue
            self._table.log(row.id, AuditEntry(now, "housefly", "expired"))
            space -= row.size
            gone.append(row.id)
        self.update_notices()
        return tuple(gone)

    def remove(self, row: ClipRow) -> None:
        """Delete a clip at once; raises OSError, StoreError."""
        (self._folder / row.file_name).unlink(missing_ok=True)
        self._table.remove(row.id)

    def update_notices(self) -> None:
        """Bring the notices up to date; an index that does not answer is one of them."""
        try:
            notices = (self._space_words(), self._clock_words())
        except HouseflyError as error:
            notices = (str(error), "")
        now = tuple(words for words in notices if words)
        for words in now:
            if words not in self.notices:
                _LOG.warning("%s", words)
        self.notices = now

    @property
    def _budget(self) -> float:
        return self._config.clip_space_gb * _GIGABYTE

    def _days(self, row: ClipRow) -> float:
        if row.cut_off and not row.duration:
            return min(_UNPLAYABLE_DAYS, self._config.clip_days)
        return self._config.clip_days if row.kind == "clip" else self._config.snapshot_days

    def _newest(self, now: float) -> float:
        """Return when the newest clip ended, or now: by that the first look at the clock goes."""
        rows = self._table.rows("whole", limit=1)
        return rows[0].began_at + rows[0].duration if rows else now

    def _age_future_clips_from(self, now: float) -> None:
        """Let the days of clips begin today that a wrong clock put into the future."""
        for row in self._table.rows("whole AND began_at > ?", now + _DAY):
            if not self._table.adopted_at(row.id):
                self._table.log(row.id, AuditEntry(now, "housefly", ADOPTED))

    def _space_words(self) -> str:
        rows = self._table.rows("whole")
        used, kept = sum(row.size for row in rows), sum(row.size for row in rows if row.kept)
        if used <= self._budget:
            return ""
        return (
            f"clips take {used / _GIGABYTE:.2g} GB, more than tasks.clip_space_gb ="
            f" {self._config.clip_space_gb:g}; {kept / _GIGABYTE:.2g} GB of that is kept until"
            " somebody deletes it: delete some of those that are kept"
        )

    def _clock_words(self) -> str:
        known = self._table.believed_time()
        if known is None or known.doubted is None:
            return ""
        days = (known.doubted - known.believed) / _DAY
        until = time.strftime("%Y-%m-%d %H:%M", time.localtime(known.doubted + PROOF_TIME))
        return (
            f"the clock went on by {days:.0f} days at once: no clip is deleted for its age before"
            f" {until}; if the clock is right, `housefly clips tidy --clock-is-right` does it now"
        )
