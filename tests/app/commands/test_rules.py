"""The rules from the command line, while nothing runs."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from housefly.app.commands import rules
from housefly.cli import main
from housefly.config.state import tasks_folder
from housefly.hub.memory import RoomMemory
from housefly.hub.store.open import open_site_store
from housefly.messages import RoomEvent
from housefly.sites.loaded_site import read_site
from housefly.tasks.api.answers import RuleStatus
from housefly.tasks.rules.change_store import ChangeStore
from housefly.tasks.rules.rule_change import RuleChange

Capture = pytest.CaptureFixture[str]


@pytest.fixture(autouse=True)
def _own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))


def test_the_rules_are_listed_in_words(capsys: Capture) -> None:
    assert main(["rules", "list"]) == 0
    out = capsys.readouterr().out
    assert "bell: when bell pressed" in out and "night-round (off): every day at 23:30" in out


def test_a_file_is_checked_against_the_services_there_are(tmp_path: Path, capsys: Capture) -> None:
    file = tmp_path / "rules.yaml"
    file.write_text("rules:\n  - {name: a, when: {webhook: parcel}, then: {service: tidy_up}}\n")
    assert main(["rules", "check", str(file)]) == 1
    assert "rule a: there is no service 'tidy_up'" in capsys.readouterr().out
    file.write_text(
        "rules:\n  - {name: a, when: {webhook: parcel}, then: {service: look}, speed: 3}"
    )
    assert main(["rules", "check", str(file)]) == 2
    assert "speed" in capsys.readouterr().err


def test_what_the_page_changed_is_listed_and_named_by_the_check(
    tmp_path: Path, capsys: Capture
) -> None:
    store = ChangeStore(tasks_folder(read_site("bsen")))
    store.keep({"bell": RuleChange(enabled=False, mode=("home",), by="kim")})
    assert main(["rules", "list"]) == 0
    out = capsys.readouterr().out
    assert "bell (off): when bell pressed, if the house is in mode home" in out
    assert "changed on the page by kim: off, mode home" in out
    file = tmp_path / "rules.yaml"
    file.write_text("rules:\n  - {name: a, when: {webhook: parcel}, then: {service: visitor}}\n")
    assert main(["rules", "check", str(file)]) == 0
    assert "bell: changed on the page by kim: off, mode home" in capsys.readouterr().out


def test_a_dry_run_tells_what_would_have_flown(tmp_path: Path, capsys: Capture) -> None:
    memory = RoomMemory((), lambda: open_site_store(read_site("bsen")))
    for ago in (3600.0, 3599.0, 60.0):
        memory.add(RoomEvent("bell pressed", "doorbell", time.time() - ago, "doorbell"))
    memory.close()
    assert main(["rules", "dry-run", "--since", "1d"]) == 0
    out = capsys.readouterr().out
    assert out.count("bell: visitor: somebody is asked first") == 2
    assert "3 events; the rules would have asked for 2 flights; nothing flew" in out
    assert main(["rules", "dry-run", "--since", "1d", "--all"]) == 0
    assert "rests for" in capsys.readouterr().out


def test_while_it_runs_the_list_says_what_each_rule_did_last(
    capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    last = RuleStatus("bell", "", True, last_at=time.time(), last_words="visitor asked for")
    monkeypatch.setattr(rules, "_running_rules", lambda options: (last,))
    assert main(["rules", "list"]) == 0
    out = capsys.readouterr().out
    assert "after a yes\n    " in out and ": visitor asked for\n" in out
