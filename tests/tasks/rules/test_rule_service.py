from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from rule_bench import NOON, KnownRoom, bell, make_rule

from housefly.config.house_mode import HouseMode
from housefly.errors import StoreError
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.rules.mode_event import mode_after, mode_before
from housefly.tasks.rules.rule_engine import RuleEngine
from housefly.tasks.rules.rule_service import RuleService
from housefly.tasks.rules.rule_store import KeptRules, RuleStore


def service(folder: Path, **rule: str) -> RuleService:
    return RuleService(
        RuleEngine([make_rule(**rule)]), RuleStore(folder, HouseMode.HOME), KnownRoom()
    )


def codes(found: tuple) -> list[ReasonCode]:  # type: ignore[type-arg]
    return [decision.firing.code for decision in found]


def test_mode_and_cooldown_are_kept_over_a_restart(tmp_path: Path) -> None:
    first = service(tmp_path, cooldown="5 min")
    assert codes(first.heard(bell(NOON), NOON)) == [ReasonCode.OK]
    first.set_mode(HouseMode.AWAY, "alice", NOON + 1)
    again = service(tmp_path, cooldown="5 min")
    assert again.mode is HouseMode.AWAY
    assert codes(again.heard(bell(NOON + 60), NOON + 60)) == [ReasonCode.COOLDOWN]
    assert again.rules_answer().rules[0].last_at == NOON + 60


def test_a_change_of_the_mode_tells_what_it_allows_and_from_where_it_came(tmp_path: Path) -> None:
    rules = service(tmp_path)
    change = rules.set_mode(HouseMode.PRIVACY, "alice", NOON)
    assert change.answer.mode is HouseMode.PRIVACY and "nothing records" in change.answer.words
    assert change.event is not None
    assert (mode_before(change.event), mode_after(change.event)) == (
        HouseMode.HOME,
        HouseMode.PRIVACY,
    )
    assert rules.set_mode(HouseMode.PRIVACY, "alice", NOON).event is None


@pytest.mark.parametrize("content", [b"", b"{", b'{"mode": "party"}', b"\xff\xfe"])
def test_when_what_was_kept_cannot_be_read_the_house_is_private(
    tmp_path: Path, content: bytes
) -> None:
    (tmp_path / "rules.json").write_bytes(content)
    store = RuleStore(tmp_path, HouseMode.HOME)
    assert store.load().mode is HouseMode.PRIVACY
    assert "mode privacy" in store.problem
    store.keep(KeptRules(HouseMode.HOME))
    assert RuleStore(tmp_path, HouseMode.AWAY).load().mode is HouseMode.HOME


def test_what_is_kept_only_its_user_reads(tmp_path: Path) -> None:
    RuleStore(tmp_path / "tasks", HouseMode.HOME).keep(KeptRules(HouseMode.HOME))
    assert (tmp_path / "tasks" / "rules.json").stat().st_mode & 0o077 == 0


def test_a_mode_that_cannot_be_kept_is_not_set(tmp_path: Path) -> None:
    rules = service(tmp_path / "file" / "tasks")
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(StoreError):
        rules.set_mode(HouseMode.AWAY, "alice", NOON)
    assert rules.mode is HouseMode.HOME


def test_a_storm_of_events_writes_once(tmp_path: Path) -> None:
    rules = service(tmp_path, cooldown="1 h")
    rules.heard(bell(NOON), NOON)
    written = (tmp_path / "rules.json").stat().st_mtime_ns
    for second in range(1, 500):
        rules.heard(bell(NOON + second), NOON + second)
    assert (tmp_path / "rules.json").stat().st_mtime_ns == written


def test_many_threads_ring_once(tmp_path: Path) -> None:
    rules = service(tmp_path, cooldown="1 h")
    with ThreadPoolExecutor(8) as pool:
        found = pool.map(lambda n: rules.heard(bell(NOON + n * 1e-3), NOON + 1.0), range(200))
    made = [decision for each in found for decision in each if decision.request is not None]
    assert len(made) == 1
