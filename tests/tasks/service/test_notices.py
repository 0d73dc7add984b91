"""What people want to be told: kept over a restart, told once, and nobody's room taken."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from pathlib import Path
from threading import RLock

import pytest
from task_stage import TaskStage

from housefly.messages import RoomEvent
from housefly.tasks.api.questions import Sentence
from housefly.tasks.api.values import RequestSurface
from housefly.tasks.intents.intent_reply import Notice
from housefly.tasks.rules.trigger import EventTrigger
from housefly.tasks.scheduler.task_store import TaskStore
from housefly.tasks.service.notices import MOST, MOST_OF_ONE, Notices

BELL = Notice("The bell is ringing.", ("bell pressed",))
DAY = 86400.0


@pytest.fixture
def store(tmp_path: Path) -> Iterator[TaskStore]:
    made = TaskStore(tmp_path / "tasks.db")
    yield made
    made.close()


def reopened(store: TaskStore, now: Callable[[], float] = time.time) -> Notices:
    return Notices(store, RLock(), now)


def test_who_wants_to_be_called_is_called_after_a_restart_and_once(tmp_path: Path) -> None:
    first = TaskStage(tmp_path)
    assert "tell" in first.ask(Sentence("call me when the bell rings", by="kim")).words
    first.close()  # what kill -9 leaves is the same: it was written at once
    for told in (1, 0):
        stage = TaskStage(tmp_path)
        bell = RoomEvent("bell pressed", "doorbell", stage.wall(), "doorbell")
        stage.service.desk.heard(EventTrigger(bell))
        assert len(stage.told("said")) == told
        stage.close()


def test_a_time_that_came_while_nothing_ran_is_told_late_but_not_days_late(
    store: TaskStore,
) -> None:
    now = [1000.0]
    notices = reopened(store, lambda: now[0])
    assert notices.add(Notice("soon", at=2000.0), "kim")
    assert notices.add(Notice("later", at=2000.0 + 2 * DAY), "kim")
    now[0] = 5000.0
    assert reopened(store, lambda: now[0]).due_by_time() == ("soon",)
    now[0] = 2000.0 + 3.5 * DAY
    assert reopened(store, lambda: now[0]).due_by_time() == ()
    assert store.kept_notices() == ()


def test_what_nothing_makes_due_is_forgotten_after_a_day(store: TaskStore) -> None:
    now = [1000.0]
    notices = reopened(store, lambda: now[0])
    notices.add(BELL, "kim")
    now[0] += DAY + 1.0
    notices.due_by_time()
    assert notices.due("bell pressed", "doorbell") == () and store.kept_notices() == ()


def test_the_same_wish_twice_is_one_and_two_people_are_told_in_one_sentence(
    store: TaskStore,
) -> None:
    notices = reopened(store)
    for who in ("kim", "kim", "ann"):
        assert notices.add(BELL, who)
    assert len(store.kept_notices()) == 2
    assert notices.due("bell pressed", "doorbell") == ("The bell is ringing.",)


def test_nobody_takes_the_room_of_others(store: TaskStore) -> None:
    notices = reopened(store)
    notices.add(BELL, "kim")
    kept = [notices.add(Notice(f"n {k}", ("x",)), "mqtt ") for k in range(200)]
    assert kept.count(True) == MOST_OF_ONE
    for k in range(200):
        notices.add(Notice(f"n {k}", ("x",)), f"browser {k}")
    assert len(store.kept_notices()) == MOST
    assert notices.due("bell pressed", "doorbell") == ("The bell is ringing.",)


def test_a_notice_too_many_is_refused_in_words(tmp_path: Path) -> None:
    stage = TaskStage(tmp_path, hub__enabled=False)
    words = [
        stage.ask(Sentence(f"remind me in {k} minutes", surface=RequestSurface.MQTT)).words
        for k in range(2, 14)
    ]
    assert [("too much" in one) for one in words] == [False] * MOST_OF_ONE + [True] * 2
    stage.close()


@pytest.mark.parametrize("text", ["", "{}", "nonsense", '{"since": "x"}'])
def test_a_damaged_notice_hides_no_other(store: TaskStore, text: str) -> None:
    reopened(store).add(BELL, "kim")
    store.save_notices([text, *store.kept_notices()])
    assert reopened(store).due("bell pressed", "doorbell") == ("The bell is ringing.",)
