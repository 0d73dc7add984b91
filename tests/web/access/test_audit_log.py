from __future__ import annotations

import json
import stat
import threading
import time
from pathlib import Path
from typing import Any

import pytest

from housefly.web.access import audit_log
from housefly.web.access.audit_log import AuditLog


def lines(file: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in file.read_text().splitlines()]


def test_who_what_and_when_are_on_disk_and_for_this_user_only(tmp_path: Path) -> None:
    file = tmp_path / "state" / "commands.jsonl"
    before = time.time()
    log = AuditLog(file)
    log.record("Anna\n{", "0123456789abcdef", "take off")
    log.record("Ben", "fedcba9876543210", "go refused: Anna has control")
    log.close()
    first, second = lines(file)
    assert (first["who"], first["session"], first["what"]) == ("Anna\n{", "01234567", "take off")
    assert before - 0.01 <= first["at"] <= second["at"] <= time.time() + 0.001  # rounded to 1 ms
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert stat.S_IMODE(file.parent.stat().st_mode) == 0o700


def test_a_file_that_others_could_read_is_closed_to_them(tmp_path: Path) -> None:
    file = tmp_path / "commands.jsonl"
    file.touch()
    file.chmod(0o644)
    log = AuditLog(file)
    log.record("Anna", "x", "land")
    log.close()
    assert stat.S_IMODE(file.stat().st_mode) == 0o600


def test_a_disk_that_does_not_answer_delays_nobody_and_the_loss_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(audit_log, "_WAITING", 10)
    log = AuditLog(tmp_path / "commands.jsonl")
    real, answers = log._append, threading.Event()
    monkeypatch.setattr(log, "_append", lambda waiting: (answers.wait(60.0), real(waiting)))
    for number in range(500):  # would not end before the disk answers, if it waited for it
        log.record("Anna", "x", str(number))
    assert not answers.is_set()
    answers.set()
    while not log._lines.empty():
        time.sleep(0.01)
    log.record("Anna", "x", "later")
    log.close()
    told = lines(tmp_path / "commands.jsonl")
    lost = sum(line.get("lost", 0) for line in told)
    assert told[-1]["what"] == "later" and told[-1]["lost"] > 0
    assert lost > 400 and len(told) - 1 + lost == 500


def test_the_file_does_not_grow_without_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(audit_log, "MAX_SIZE", 2000)
    monkeypatch.setattr(audit_log, "_TOGETHER", 5)
    log = AuditLog(tmp_path / "commands.jsonl")
    for _ in range(200):
        log.record("Anna", "x", "hover")
    log.close()
    files = sorted(path.name for path in tmp_path.iterdir())
    assert files == ["commands.jsonl", "commands.old.jsonl"]
    assert sum(path.stat().st_size for path in tmp_path.iterdir()) < 5000


def test_a_link_in_its_place_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "commands.jsonl").symlink_to(tmp_path / "elsewhere")
    log = AuditLog(tmp_path / "commands.jsonl")
    log.record("Anna", "x", "hover")
    log.close()
    assert not (tmp_path / "elsewhere").exists()
