"""Keeps the queue and the history in one file: what was acknowledged outlives any crash.

Each ``save`` is on the disk when it returns (SQLite's write-ahead log, synchronous FULL): neither
``kill -9`` nor a power cut takes back what it was told. One process at a time holds the file; the
kernel frees it when that process is gone.
"""

from __future__ import annotations

import logging
import re
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from pydantic import TypeAdapter, ValidationError

from housefly.errors import StoreError
from housefly.hub.store.database import Row
from housefly.tasks.api.questions import TaskHistoryQuestion
from housefly.tasks.api.values import ENDED, TaskStatus
from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.task_file import COUNT_FROM, open_task_file, with_remedy
from housefly.tasks.scheduler.values import ScheduledTask, SchedulerLimits

_log = logging.getLogger(__name__)

TASK_FILE = "tasks.db"
"""Its name, in the folder of a site's tasks."""
HISTORY_MAX = 20_000
"""Tasks that are kept; the oldest ended ones go first."""
_STATUS: TypeAdapter[TaskStatus] = TypeAdapter(TaskStatus)
_SCHEDULED: TypeAdapter[ScheduledTask] = TypeAdapter(ScheduledTask)
_FOREVER = float("inf")
_SAVE = (
    "INSERT INTO tasks (id, service, asked_at, ended_at, status, scheduled)"
    " VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (id) DO UPDATE SET ended_at = excluded.ended_at,"
    " status = excluded.status, scheduled = excluded.scheduled"
)
_NEXT_ID = "SELECT value FROM counters WHERE name = 'next_id'"
_FORGET = "DELETE FROM tasks WHERE id <= ? AND scheduled IS NULL"
_OPEN = "SELECT id, scheduled FROM tasks WHERE scheduled IS NOT NULL ORDER BY id"
_ONE = "SELECT status FROM tasks WHERE id = ?"
_ENDED = (
    "SELECT status FROM tasks WHERE ended_at IS NOT NULL ORDER BY ended_at DESC, id DESC LIMIT ?"
)
_HISTORY = (
    "SELECT status FROM tasks WHERE asked_at >= ? AND asked_at <= ? AND (? = '' OR service = ?)"
    " AND (? = 0 OR (asked_at, id) < (SELECT asked_at, id FROM tasks WHERE id = ?))"
    " ORDER BY asked_at DESC, id DESC LIMIT ?"
)


@dataclass(frozen=True, slots=True)
class KeptTask:
    """A task as it is kept: as the scheduler needs it, and as people see it."""

    task: ScheduledTask
    status: TaskStatus


class TaskStore:
    """The tasks of a site, in one file; one thread at a time uses it.

    Attributes:
        notices: what was wrong with the file and what was done, in words.
        problem: why the queue cannot be kept, in words, or "".
    """

    def __init__(self, path: Path) -> None:
        """Open or create the file; a damaged one is moved aside and a new one begun.

        Raises:
            StoreError: it cannot be opened, another process holds it, it may only be read, or a
                newer version made it; says what to do.
        """
        self._path, self.problem = path, ""
        self._unsaved: dict[int, KeptTask] = {}
        with with_remedy(self._path):
            self._database, self.notices = open_task_file(path)

    def load(self, limits: SchedulerLimits) -> Scheduler:
        """Return the scheduler as it was saved last; ``Scheduler.restarted`` says what now.

        An open task that cannot be read ends here, and a notice says so.
        """
        with with_remedy(self._path):
            rows = tuple(self._database.query(_OPEN))
            next_id = int(next(iter(self._database.query(_NEXT_ID)))[0])
        tasks = []
        for task_id, text in rows:
            try:
                tasks.append(_SCHEDULED.validate_json(str(text)))
            except ValidationError as error:
                self._give_up(int(task_id), str(error.errors()[0]["msg"]))
        return Scheduler(limits, next_id, tuple(tasks))

    def save(self, tasks: Iterable[KeptTask]) -> None:
        """Keep tasks as they are now, all or none; on return they are on the disk.

        Raises:
            StoreError: the disk refuses; nothing of it was kept.
        """
        tasks = tuple(tasks)
        rows = [_row(kept) for kept in tasks]
        if not rows:
            return
        newest = max(kept.task.id for kept in tasks)
        with with_remedy(self._path), self._database.transaction():
            self._database.many(_SAVE, rows)
            self._database.query(COUNT_FROM, (newest + 1,))
            self._database.query(_FORGET, (newest - HISTORY_MAX,))

    def keep(self, tasks: Iterable[KeptTask]) -> None:
        """Save tasks, with all that was refused before; a disk that refuses ends no flight."""
        self._unsaved |= {kept.task.id: kept for kept in tasks}
        try:
            self.save(self._unsaved.values())
            self.problem, self._unsaved = "", {}
        except StoreError as error:
            if str(error) != self.problem:
                _log.error("the queue is not kept: %s", error)
            self.problem = str(error)

    def retry(self) -> None:
        """Save what was refused, as soon as there is room."""
        if self._unsaved:
            self.keep(())

    def history(self, question: TaskHistoryQuestion) -> tuple[TaskStatus, ...]:
        """Return tasks that were asked for between two times, open ones too, the newest first."""
        until = _FOREVER if question.until is None else question.until
        span = (question.since, until, question.service, question.service)
        values = (*span, question.before, question.before, question.limit)
        return self._statuses(_HISTORY, values)

    def newest_ended(self, limit: int) -> tuple[TaskStatus, ...]:
        """Return the tasks that ended last, the newest first."""
        return self._statuses(_ENDED, (limit,))

    def status(self, task_id: int) -> TaskStatus | None:
        """Return one task as it was saved last; None if it is not kept."""
        return next(iter(self._statuses(_ONE, (task_id,))), None)

    def forget(self, mention: re.Pattern[str]) -> int:
        """Delete the ended tasks and the notices that mention somebody; return how many tasks."""
        with with_remedy(self._path):
            kept = self._database.query("SELECT id, status FROM tasks WHERE scheduled IS NULL")
            gone: list[Row] = [(task,) for task, status in kept if mention.search(str(status))]
            notices = [words for words in self.kept_notices() if not mention.search(words)]
            self._database.many("DELETE FROM tasks WHERE id = ?", gone)
            self.save_notices(notices)
            self._database.scrub()
        return len(gone)

    def save_notices(self, notices: Iterable[str]) -> None:
        """Keep what people want to be told, instead of what was kept before.

        Raises:
            StoreError: the disk refuses; what was kept stays.
        """
        rows: list[Row] = [(number, text) for number, text in enumerate(notices)]
        with with_remedy(self._path), self._database.transaction():
            self._database.query("DELETE FROM notices")
            self._database.many("INSERT INTO notices (number, notice) VALUES (?, ?)", rows)

    def kept_notices(self) -> tuple[str, ...]:
        """Return what people want to be told, as it was kept last."""
        with with_remedy(self._path):
            rows = self._database.query("SELECT notice FROM notices ORDER BY number")
        return tuple(str(text) for (text,) in rows)

    def close(self) -> None:
        """Close the file, for another process."""
        self._database.close()

    def _statuses(self, sql: str, values: Row) -> tuple[TaskStatus, ...]:
        with with_remedy(self._path):
            rows = self._database.query(sql, values)
        found = []
        for (text,) in rows:
            with suppress(ValidationError):  # one bad row hides no other
                found.append(_STATUS.validate_json(str(text)))
        return tuple(found)

    def _give_up(self, task_id: int, problem: str) -> None:
        with with_remedy(self._path):
            self._database.query("UPDATE tasks SET scheduled = NULL WHERE id = ?", (task_id,))
        notice = f"task {task_id} cannot be read ({problem}): it does not go on"
        self.notices = (*self.notices, notice)


def _row(kept: KeptTask) -> Row:
    task, status = kept.task, kept.status
    scheduled = None if task.stage in ENDED else _SCHEDULED.dump_json(task).decode()
    return (
        task.id,
        task.request.service,
        task.asked_at,
        task.ended_at,
        _STATUS.dump_json(status).decode(),
        scheduled,
    )
