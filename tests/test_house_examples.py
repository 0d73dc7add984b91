"""The examples of a house of one's own: a rule, a webhook, an assistant."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from housefly.cli import build_parser
from housefly.hub.api.endpoints import API_PREFIX
from housefly.tasks.document.library import load_library
from housefly.tasks.rules.rule import WebhookPattern
from housefly.tasks.rules.rule_file import read_rules, rule_problems, shipped_rules

FOLDER = Path(__file__).resolve().parents[1] / "examples" / "house"


def test_the_rules_ask_for_what_there_is() -> None:
    services = {name: document.info() for name, document in load_library().items()}
    assert rule_problems(read_rules(FOLDER / "rules.yaml"), services) == ()
    assert rule_problems(shipped_rules(), services) == ()


def test_the_webhook_is_the_one_that_the_rule_waits_for() -> None:
    (rule,) = read_rules(FOLDER / "rules.yaml")
    assert isinstance(rule.when, WebhookPattern)
    script = (FOLDER / "webhook.sh").read_text()
    assert f"{API_PREFIX}/webhook/{rule.when.webhook}" in script
    assert subprocess.run(["sh", "-n", str(FOLDER / "webhook.sh")], check=False).returncode == 0


def test_the_entry_for_assistants_starts_our_command() -> None:
    entry = json.loads((FOLDER / "mcp.json").read_text())["mcpServers"]["housefly"]
    assert entry["command"] == "housefly"
    assert build_parser().parse_args(entry["args"]).command == "mcp"


@pytest.mark.wire
def test_the_assistant_asks_and_is_told_that_no_room_runs(tmp_path: Path) -> None:
    folders = {"XDG_STATE_HOME": str(tmp_path), "XDG_RUNTIME_DIR": str(tmp_path / "run")}
    done = subprocess.run(
        [sys.executable, str(FOLDER / "assistant.py")],
        capture_output=True,
        text=True,
        timeout=60.0,
        check=False,
        env={**os.environ, **folders},
    )
    assert done.returncode == 0, done.stderr
    assert [line.split()[0] for line in done.stdout.splitlines()] == [
        "where_is",
        "rehearse",
        "request_flight",
    ]
    assert done.stdout.count("no room is running here") == 3
