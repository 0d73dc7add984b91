"""What is printed is read when there is room, and no exception when there is none."""

from __future__ import annotations

import io
import sys
import time
from contextlib import redirect_stderr, redirect_stdout

import pytest
from full_disk import full_output

from housefly.config.process_log import REPEAT_PERIOD, log_line, log_traceback

pytestmark = pytest.mark.usefixtures("fresh_log")


def printed_of_a_failure() -> None:
    try:
        raise ZeroDivisionError("float division by zero")
    except ZeroDivisionError:
        log_traceback()


def test_lines_and_tracebacks_are_printed(capsys: pytest.CaptureFixture[str]) -> None:
    log_line("pilot ready")
    log_line("no broker", sys.stderr)
    printed_of_a_failure()
    out, err = capsys.readouterr()
    assert out == "pilot ready\n"
    first, *_, last = err.splitlines()
    assert (first, last) == ("no broker", "ZeroDivisionError: float division by zero")
    assert "Traceback (most recent call last):" in err and not err.endswith("\n\n")


def test_what_fails_again_and_again_is_printed_once_in_ten_seconds_and_counted(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(number: int) -> None:
        try:
            raise ValueError(f"tick {number}")
        except ValueError:
            log_traceback()

    now = time.monotonic()
    for number in range(100):
        monkeypatch.setattr(time, "monotonic", lambda n=number: now + 0.03 * n)
        fail(number)
    printed_of_a_failure()
    monkeypatch.setattr(time, "monotonic", lambda: now + REPEAT_PERIOD)
    fail(100)

    err = capsys.readouterr().err
    assert [line for line in err.splitlines() if line.startswith(("ValueError", "Zero", "("))] == [
        "ValueError: tick 0",
        "ZeroDivisionError: float division by zero",
        "ValueError: tick 100",
        "(and 99 times more since the last time)",
    ]


def test_a_full_disk_raises_nothing() -> None:
    with full_output():
        with pytest.raises(OSError, match="No space left"):
            print("pilot ready")
        log_line("pilot ready")
        log_line("no broker", sys.stderr)
        printed_of_a_failure()


def test_a_stream_that_is_closed_or_lacks_a_letter_raises_nothing() -> None:
    closed = io.StringIO()
    closed.close()
    narrow = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    for stream in (closed, narrow):
        with redirect_stdout(stream), redirect_stderr(stream):
            log_line("das Büro")
            printed_of_a_failure()
