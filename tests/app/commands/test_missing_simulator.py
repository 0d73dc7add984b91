"""Without MuJoCo a simulated room is refused at once, with the command that installs it."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from housefly.app import compiling, interactive
from housefly.cli import main

COMMANDS = (
    "demo --instance 1",
    "demo --memory --instance 1",
    "run --instance 1",
    "fly entrance --headless",
    "fly entrance --lockstep",
    "identify --lockstep",
)


@pytest.mark.parametrize("command", COMMANDS)
def test_nothing_is_compiled_or_started_without_mujoco(
    command: str,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, "mujoco", None)
    monkeypatch.setattr(compiling, "compile_once", lambda *_: pytest.fail("it compiles"))
    monkeypatch.setattr(interactive, "run_interactively", lambda *_: pytest.fail("it starts"))
    assert main(command.split()) == 2
    assert "pip install 'housefly[twin]'" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
