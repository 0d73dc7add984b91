"""The rehearsal worker: warm, asked over its pipe, and never a yes when it fails."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator
from typing import Any

import pytest
from task_flights import premises, shipped

from housefly.errors import LinkError, ThingError
from housefly.hub.api.questions import Question
from housefly.lab.rehearsal.rehearsal_link import memory_refusal
from housefly.lab.rehearsal.rehearser import Rehearser
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.tasks.api.values import ReasonCode

PATIENT = 60.0
"""On a machine that does much else [s]."""


class Asked:
    """A memory that knows nothing and remembers what it was asked."""

    def __init__(self) -> None:
        self.questions: list[Question] = []

    def __call__(self, question: Question) -> Any:
        self.questions.append(question)
        raise ThingError("nothing is called that")


@pytest.fixture(scope="module")
def asked() -> Asked:
    return Asked()


@pytest.fixture(scope="module")
def rehearser(asked: Asked) -> Iterator[Rehearser]:
    """Return one worker, as the tasks process has it."""
    one = Rehearser(premises(), RoomNow, asked, PATIENT)
    yield one
    one.close()


def test_a_task_is_rehearsed_elsewhere(rehearser: Rehearser) -> None:
    report = rehearser.rehearse(shipped("look", subject="tv", time=1.0)).result()
    assert report.may_fly, report.words
    assert report.duration is not None and report.took > 0.0


def test_the_worker_asks_the_rooms_memory(rehearser: Rehearser, asked: Asked) -> None:
    report = rehearser.rehearse(shipped("look", subject="grandma's cup")).result()
    assert (report.may_fly, report.code) == (False, ReasonCode.UNKNOWN_THING)
    assert report.words == "nothing is called that"
    assert any(getattr(one, "thing", "") == "grandma's cup" for one in asked.questions)


@pytest.mark.interop
def test_a_worker_that_hangs_or_dies_is_a_refusal_and_is_started_again(
    rehearser: Rehearser,
) -> None:
    task = shipped("look", subject="tv", time=1.0)
    assert rehearser.rehearse(task).result().may_fly and rehearser.process_id is not None
    os.kill(rehearser.process_id, signal.SIGSTOP)
    rehearser.limit = 0.5
    hung = rehearser.rehearse(task).result()
    assert (hung.may_fly, hung.code) == (False, ReasonCode.NOT_READY)
    assert "no answer" in hung.words
    rehearser.limit = PATIENT
    assert rehearser.rehearse(task).result().may_fly
    os.kill(rehearser.process_id, signal.SIGSTOP)
    running = rehearser.rehearse(task)
    while not running.running():
        time.sleep(0.01)
    time.sleep(0.2)  # ordered, and the stopped worker has not begun
    os.kill(rehearser.process_id, signal.SIGKILL)
    died = running.result()
    assert (died.may_fly, died.code) == (False, ReasonCode.NOT_READY)


def test_getting_ready_counts_for_no_rehearsal_and_an_end_meanwhile_is_a_refusal() -> None:
    hurried = Rehearser(premises(), RoomNow, Asked(), 0.1)
    running = hurried.rehearse(shipped("look", subject="tv"))
    while not running.running():
        time.sleep(0.01)
    time.sleep(0.5)
    assert not running.done(), "five times its limit, and it is only getting ready"
    hurried.close()
    report = running.result(30.0)
    assert (report.may_fly, report.code) == (False, ReasonCode.NOT_READY)


def test_refusals_of_the_memory_cross_the_pipe_with_their_kind() -> None:
    with pytest.raises(ThingError, match="no such thing"):
        memory_refusal(ThingError("no such thing")).unpacked()
    with pytest.raises(LinkError, match="silent"):
        memory_refusal(LinkError("silent")).unpacked()
