"""The file of the queue: what it keeps, what it refuses, and in which words."""

from __future__ import annotations

import os
import sqlite3
import stat
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.errors import StoreError
from housefly.tasks.api.questions import TaskHistoryQuestion
from housefly.tasks.api.values import (
    ENDED,
    Confirm,
    OnPreempt,
    PersonQuestion,
    Priority,
    ReasonCode,
    RehearsalReport,
    RequestSurface,
    TaskRequest,
    TaskStage,
    TaskStatus,
    TaskStepState,
    TaskStepStatus,
)
from housefly.tasks.scheduler import task_store
from housefly.tasks.scheduler.task_file import AFTER_DAMAGE
from housefly.tasks.scheduler.task_store import KeptTask, TaskStore
from housefly.tasks.scheduler.transitions import STAGES, QueueState
from housefly.tasks.scheduler.values import ScheduledTask, SchedulerLimits, TaskTraits

LIMITS = SchedulerLimits()
words = st.text(st.characters(codec="utf-8"), max_size=20)
times = st.floats(0.0, 4e9)
numbers = st.floats(allow_nan=False, allow_infinity=False)
parameters = st.dictionaries(words, words | st.booleans() | numbers, max_size=3)
questions = st.builds(
    PersonQuestion, words, words, st.just(("yes", "no", "later")), st.none() | times, words
)
points = st.tuples(st.floats(-9.0, 9.0), st.floats(-9.0, 9.0))
rehearsals = st.builds(
    RehearsalReport,
    st.booleans(),
    st.sampled_from(ReasonCode),
    words,
    st.lists(points, max_size=3).map(tuple),
    st.none() | times,
)
tasks = st.builds(
    ScheduledTask,
    id=st.integers(1, 2**53),
    request=st.builds(
        TaskRequest,
        words,
        parameters,
        words,
        st.sampled_from(RequestSurface),
        words,
        st.sampled_from(Confirm),
        st.sampled_from(Priority),
        st.none() | times,
    ),
    traits=st.builds(
        TaskTraits, words, st.booleans(), st.sampled_from(Confirm), st.sampled_from(OnPreempt)
    ),
    state=st.sampled_from(QueueState),
    asked_at=times,
    turn=st.integers(1, 2**53),
    fresh_at=times,
    code=st.sampled_from(ReasonCode),
    words=words,
    question=st.none() | questions,
    rehearsal=st.none() | rehearsals,
    started_at=st.none() | times,
    ended_at=st.none() | times,
)
steps = st.lists(
    st.builds(TaskStepStatus, words, words, st.sampled_from(TaskStepState)), max_size=3
).map(tuple)


def status_of(task: ScheduledTask, steps: tuple[TaskStepStatus, ...] = ()) -> TaskStatus:
    return TaskStatus(
        id=task.id,
        service=task.request.service,
        title=task.traits.title,
        parameters=task.request.parameters,
        state=task.stage,
        code=task.code,
        words=task.words,
        asked_by=task.request.asked_by,
        surface=task.request.surface,
        cause=task.request.cause,
        priority=task.request.priority,
        asked_at=task.asked_at,
        started_at=task.started_at,
        ended_at=task.ended_at,
        deadline=task.request.deadline,
        steps=steps,
        question=task.question,
        rehearsal=task.rehearsal,
        clips=("clip-1",),
        report=("all is well",),
    )


def task_of(
    number: int, state: QueueState = QueueState.QUEUED, service: str = "look", at: float = 0.0
) -> ScheduledTask:
    ended_at = None if STAGES[state] in (TaskStage.QUEUED, TaskStage.WAITING) else at + 1.0
    return ScheduledTask(
        number, TaskRequest(service), TaskTraits("Look"), state, at, number, at, ended_at=ended_at
    )


def keep(store: TaskStore, *kept: ScheduledTask) -> None:
    store.save(KeptTask(task, status_of(task)) for task in kept)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "house" / "tasks" / "tasks.db"


@given(task=tasks, steps=steps)
@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_a_task_comes_back_as_it_was(
    path: Path, task: ScheduledTask, steps: tuple[TaskStepStatus, ...]
) -> None:
    path.unlink(missing_ok=True)
    store = TaskStore(path)
    status = status_of(task, steps)
    store.save([KeptTask(task, status)])
    store.close()
    store = TaskStore(path)
    scheduler = store.load(LIMITS)
    is_open = STAGES[task.state] not in ENDED
    assert scheduler.tasks == ((task,) if is_open else ())
    assert scheduler.next_id == task.id + 1
    assert store.status(task.id) == status and store.notices == ()
    store.close()


def test_only_its_user_can_read_it(path: Path) -> None:
    store = TaskStore(path)
    keep(store, task_of(1))
    for file in path.parent.iterdir():
        assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700
    store.close()


def test_every_save_waits_for_the_disk(path: Path) -> None:
    store = TaskStore(path)
    assert next(iter(store._database.query("PRAGMA journal_mode")))[0] == "wal"
    assert next(iter(store._database.query("PRAGMA synchronous")))[0] == 2
    store.close()


def test_history_is_by_time_and_service_the_newest_first(path: Path) -> None:
    store = TaskStore(path)
    for number in range(1, 7):
        service = "look" if number % 2 else "patrol"
        keep(store, task_of(number, QueueState.DONE, service, at=10.0 * number))

    def ids(**question: object) -> list[int]:
        return [each.id for each in store.history(TaskHistoryQuestion(**question))]

    assert ids() == [6, 5, 4, 3, 2, 1]
    assert [each.id for each in store.newest_ended(3)] == [6, 5, 4]
    assert ids(since=20.0, until=50.0, service="look") == [5, 3]
    assert ids(service="'; DROP TABLE tasks; --") == []
    assert ids(limit=2) == [6, 5]
    assert ids(limit=2, before=5) == [4, 3], "the next page begins behind the last one"
    assert ids(before=1) == ids(before=99) == []
    keep(store, task_of(7, QueueState.DONE, "look", at=30.0))
    assert ids(before=4) == [7, 3, 2, 1], "asked for after the clock was set back"
    assert store.status(99) is None
    store.close()


def test_the_oldest_ended_tasks_are_forgotten_but_no_open_one_and_no_number(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(task_store, "HISTORY_MAX", 3)
    store = TaskStore(path)
    keep(store, task_of(1), *(task_of(number, QueueState.DONE) for number in range(2, 9)))
    assert [each.id for each in store.history(TaskHistoryQuestion())] == [8, 7, 6, 1]
    store.close()
    store = TaskStore(path)
    assert store.load(LIMITS).next_id == 9
    store.close()


def test_a_save_is_whole_or_not_at_all(path: Path) -> None:
    store = TaskStore(path)
    keep(store, task_of(1))
    bad = TaskRequest("\ud800")  # half a character: no database takes it
    broken = ScheduledTask(3, bad, TaskTraits("Look"), QueueState.QUEUED, 0.0, 3, 0.0)
    with pytest.raises(Exception):  # noqa: B017
        keep(store, task_of(2), broken)
    assert [task.id for task in store.load(LIMITS).tasks] == [1]
    keep(store, task_of(2))
    store.close()


def test_a_second_process_is_told_to_end_the_first(path: Path) -> None:
    store = TaskStore(path)
    with pytest.raises(StoreError, match=r"another process holds .*; end the other run of this"):
        TaskStore(path)
    keep(store, task_of(1))  # the first goes on undisturbed
    store.close()
    TaskStore(path).close()


def test_a_newer_file_is_refused_and_left_as_it_is(path: Path) -> None:
    TaskStore(path).close()
    with sqlite3.connect(path) as connection:
        connection.execute("INSERT INTO schema (version) VALUES (99)")
    connection.close()
    before = path.read_bytes()
    with pytest.raises(StoreError, match=r"is of version 99.*; install the newer Housefly"):
        TaskStore(path)
    assert path.read_bytes() == before


@pytest.mark.parametrize("damage", [b"", b"not a database at all, but long enough" * 200])
def test_a_damaged_file_is_kept_aside_and_no_number_comes_again(path: Path, damage: bytes) -> None:
    store = TaskStore(path)
    keep(store, task_of(41))
    store.close()
    content = path.read_bytes()
    path.write_bytes(damage or content[:4096] + b"\xff" * (len(content) - 4096))
    store = TaskStore(path)
    (notice,) = store.notices
    assert "damaged" in notice and "it is kept as tasks.db.damaged-" in notice
    assert notice.endswith("a new one was begun")
    scheduler = store.load(LIMITS)
    assert scheduler.tasks == () and scheduler.next_id == AFTER_DAMAGE + 1
    store.close()


def test_a_task_that_cannot_be_read_ends_and_hides_no_other(path: Path) -> None:
    store = TaskStore(path)
    keep(store, task_of(1), task_of(2))
    store.close()
    with sqlite3.connect(path) as connection:
        connection.execute("UPDATE tasks SET scheduled = '{}', status = '{}' WHERE id = 1")
    connection.close()
    store = TaskStore(path)
    assert [task.id for task in store.load(LIMITS).tasks] == [2]
    assert store.notices[0].startswith("task 1 cannot be read (")
    assert [each.id for each in store.history(TaskHistoryQuestion())] == [2]
    assert [task.id for task in store.load(LIMITS).tasks] == [2] and len(store.notices) == 1
    store.close()


def test_of_a_task_that_an_older_version_kept_nobody_knows_whether_it_flew(path: Path) -> None:
    store = TaskStore(path)
    keep(store, task_of(1, QueueState.DONE))
    store.close()
    with sqlite3.connect(path) as connection:
        connection.execute("UPDATE tasks SET status = json_remove(status, '$.flown')")
    connection.close()
    store = TaskStore(path)
    (old,) = store.history(TaskHistoryQuestion())
    assert (old.took_off_at, old.flown) == (None, None)
    store.close()


def test_a_file_that_may_only_be_read_says_what_to_do() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        TaskStore(folder / "tasks.db").close()
        (folder / "tasks.db").chmod(0o444)
        folder.chmod(0o555)
        said = said_by_nobody(lambda: TaskStore(folder / "tasks.db"))
        folder.chmod(0o700)
    assert "may only be read; make the file and its folder writable for this user" in said


def said_by_nobody(act: Callable[[], object]) -> str:
    """Return what a process without root's rights is told when it does something."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            if os.getuid() == 0:
                os.setgid(65534)
                os.setuid(65534)
            act()
        except StoreError as error:
            os.write(writing, str(error).encode())
        finally:
            os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as answer:
        said = answer.read()
    os.waitpid(child, 0)
    return said


def test_a_folder_that_cannot_be_made_says_what_to_do(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StoreError, match=r"cannot be made .*; give this site another hub.store"):
        TaskStore(tmp_path / "file" / "tasks" / "tasks.db")


def test_a_full_disk_says_so_and_keeps_what_was_kept(path: Path) -> None:
    store = TaskStore(path)
    keep(store, task_of(1))
    pages = next(iter(store._database.query("PRAGMA page_count")))[0]
    store._database.query(f"PRAGMA max_page_count = {pages}")
    with pytest.raises(StoreError, match="disk is full; make room on the disk"):
        keep(store, *(task_of(number, service="x" * 900) for number in range(2, 60)))
    assert [task.id for task in store.load(LIMITS).tasks] == [1]
    store.close()
