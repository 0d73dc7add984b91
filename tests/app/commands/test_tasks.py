"""Asking for something from the command line: what is printed, and which exit code it has."""

from __future__ import annotations

import os
import tempfile
import threading
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from task_stage import TaskStage

from housefly.app.task_progress import TaskProgress
from housefly.app.task_words import shows_the_same
from housefly.cli import main
from housefly.hub.client.discovery import RoomAddress, announced
from housefly.hub.query_server import QueryServer
from housefly.messages import OrderKind
from housefly.tasks.api.values import ReasonCode, RehearsalReport
from housefly.tasks.client.tasks_client import TASKS_SOCKET
from housefly.tasks.engine.drone_state import TakeOffReadiness


@pytest.fixture(autouse=True)
def _own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))


@pytest.fixture
def stage(tmp_path: Path) -> Iterator[TaskStage]:
    """Yield tasks that answer on a socket, beside a pilot that only stands."""
    stage, ended = TaskStage(tmp_path), threading.Event()

    def live() -> None:
        while not ended.wait(0.02):
            with stage.service.desk.lock:
                stage.stand(0.1)

    with tempfile.TemporaryDirectory() as folder:
        server = QueryServer(stage.service.answer, "key", Path(folder) / TASKS_SOCKET)
        living = threading.Thread(target=live)
        living.start()
        place = RoomAddress(
            "test", "http://127.0.0.1:9", "key", os.getpid(), bus=f"unixsock-stream/{folder}/bus"
        )
        with announced(place):
            yield stage
        ended.set()
        living.join()
        server.close()
    stage.close()


@pytest.mark.parametrize("command", [["tasks"], ["watch"], ["cancel"]])
def test_without_a_running_room_it_is_said_what_to_do(
    command: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(command) == 2
    assert "start one with `housefly demo`" in capsys.readouterr().err


def test_a_question_is_answered(stage: TaskStage, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["ask", "where", "is", "the", "sofa"]) == 0
    assert "sofa" in capsys.readouterr().out
    assert stage.orders == []


def test_what_is_not_understood_has_its_exit_code(
    stage: TaskStage, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["ask", "colourless green ideas sleep furiously"]) == 1
    assert "understand" in capsys.readouterr().out


def test_a_wish_that_cannot_be_flown_is_followed_to_its_end(
    stage: TaskStage, capsys: pytest.CaptureFixture[str]
) -> None:
    stage.rehearsals.report = RehearsalReport(False, ReasonCode.NO_WAY, "there is no way there")
    assert main(["ask", "look at the refrigerator"]) == 1
    out = capsys.readouterr().out
    assert "rehearsed: there is no way there (no_way)" in out
    assert "refused: there is no way there" in out
    assert stage.orders == []


def test_a_wish_is_queued_and_left_shown_and_cancelled(
    stage: TaskStage, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["ask", "--no-wait", "look at the refrigerator"]) == 0
    assert "task 1" in capsys.readouterr().out
    deadline = time.monotonic() + 20.0
    while not stage.orders and time.monotonic() < deadline:
        time.sleep(0.02)
    assert [order.kind for order in stage.orders] == [OrderKind.GO]
    assert main(["tasks"]) == 0
    assert "Look at a place or a thing" in capsys.readouterr().out
    assert main(["cancel", "1"]) == 0
    assert main(["cancel", "9"]) == 2
    assert "9" in capsys.readouterr().err


def test_a_reason_whose_number_grows_is_printed_once(
    stage: TaskStage, capsys: pytest.CaptureFixture[str]
) -> None:
    stage.parts.drones.first.readiness = TakeOffReadiness(False, "the battery is too low: 10%")
    main(["ask", "--no-wait", "look at the sofa"])
    (task,), progress = stage.service.board().tasks, TaskProgress()
    for seconds in range(5):
        why = f"people without markers are unseen: nothing usable for {seconds} s"
        progress.show(replace(task, words=why))
    assert capsys.readouterr().out.count("people without markers") == 1
    progress.show(replace(task, words="the battery is too low: 15%"))
    assert "battery" in capsys.readouterr().out
    boards = [replace(stage.service.board(), at=n, drone=f"silent for {n} s") for n in (0.0, 1.0)]
    assert shows_the_same(*boards)
    assert not shows_the_same(boards[0], replace(boards[1], drone="in the air"))


def test_the_services_and_the_history_are_listed(
    stage: TaskStage, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["tasks", "--services"]) == 0
    assert "visitor" in capsys.readouterr().out
    main(["ask", "--no-wait", "look at the sofa"])
    assert main(["tasks", "--history"]) == 0
    assert "Look at a place" in capsys.readouterr().out


def test_a_reply_to_nothing_is_refused_in_words(
    stage: TaskStage, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["tasks", "--reply", "1", "yes"]) == 2
    assert "no task 1" in capsys.readouterr().err
    assert main(["tasks", "--reply", "one", "yes"]) == 2
    assert "--reply" in capsys.readouterr().err


GOOD = """name: round
title: A round
about: Flies to two places.
steps:
  - go_to: sofa
  - return_home
"""


def test_a_document_is_checked_with_the_line_of_its_fault(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "round.yaml"
    file.write_text(GOOD)
    assert main(["task", "check", str(file)]) == 0
    assert "round: A round; flies" in capsys.readouterr().out
    file.write_text(GOOD.replace("go_to", "go_too"))
    assert main(["task", "check", str(file)]) == 2
    assert "line 5" in capsys.readouterr().err
    file.write_text(GOOD.replace("name: round", "name: look"))
    assert main(["task", "check", str(file)]) == 2
    assert "ships with Housefly" in capsys.readouterr().err
    assert main(["task", "check", str(tmp_path / "none.yaml")]) == 2


def test_a_task_string_of_ros_tms_becomes_a_document_that_passes_the_check(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "seen.yaml"
    words = ["task", "import-rpn", "9001$pid 9007$pid +", "--name", "seen", "--out", str(file)]
    assert main(words) == 0
    assert main(["task", "check", str(file)]) == 0
    assert main(["task", "import-rpn", "9002$oid", "--name", "grasp"]) == 2
    assert "no hand" in capsys.readouterr().err


def test_a_rehearsal_is_asked_of_the_running_room(
    stage: TaskStage, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["task", "rehearse", "look", "subject=sofa", "time=3"]) == 0
    assert "rehearsed in 0.1 s: 40 s" in capsys.readouterr().out
    assert stage.rehearsals.asked[0].parameters == {"subject": "sofa", "time": 3.0}
    assert main(["task", "rehearse", "look", "subject"]) == 2
    assert "NAME=VALUE" in capsys.readouterr().err
