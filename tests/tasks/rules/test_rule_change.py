"""What the page changes of a rule stands beside its file, is checked, and can be taken back."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rule_bench import NOON, KnownRoom, bell, make_rule

from housefly.config.house_mode import HouseMode
from housefly.errors import StoreError, TaskError
from housefly.tasks.api.values import Confirm
from housefly.tasks.rules.change_store import CHANGES_FILE, ChangeStore
from housefly.tasks.rules.rule_change import RuleChange, changed, with_changes
from housefly.tasks.rules.rule_engine import RuleEngine
from housefly.tasks.rules.rule_service import RuleService
from housefly.tasks.rules.rule_store import RuleStore

CHANGES = st.builds(
    RuleChange,
    enabled=st.none() | st.booleans(),
    confirm=st.none() | st.sampled_from(["auto", "ask", "never"]),
    mode=st.none() | st.lists(st.sampled_from(["home", "night"]), unique=True).map(tuple),
    parameters=st.dictionaries(st.sampled_from(["subject", "dwell"]), st.text(max_size=5)),
).filter(lambda one: not any(str(v).startswith("$") for v in one.parameters.values()))


def service(folder: Path, *, confirm: str = "auto") -> RuleService:
    rule = make_rule(confirm=confirm, then="{service: look, parameters: {subject: sofa}}")
    store = RuleStore(folder, HouseMode.HOME)
    return RuleService(RuleEngine([rule]), store, KnownRoom(), changes=ChangeStore(folder))


def test_a_switch_is_kept_over_a_restart_and_taken_back(tmp_path: Path) -> None:
    rules = service(tmp_path)
    rules.change("bell", RuleChange(enabled=False, by="kim"))
    for found in (rules, service(tmp_path)):
        (told,) = found.rules_answer().rules
        assert (told.enabled, told.changed_by) == (False, "kim")
        assert found.heard(bell(NOON), NOON) == ()
    again = service(tmp_path)
    again.change("bell", None)
    (told,) = service(tmp_path).rules_answer().rules
    assert (told.enabled, told.changed_by) == (True, "")
    assert again.heard(bell(NOON), NOON)[0].request is not None


def test_what_a_rule_asks_for_is_as_it_was_changed(tmp_path: Path) -> None:
    rules = service(tmp_path)
    rules.change("bell", RuleChange(confirm="ask", parameters={"subject": "window"}))
    rules.change("bell", RuleChange(mode=("away", "home")))
    (decision,) = service(tmp_path).heard(bell(NOON), NOON)
    assert decision.request is not None and decision.request.confirm is Confirm.ASK
    assert decision.request.parameters == {"subject": "window"}
    (told,) = rules.rules_answer().rules
    assert told.modes == (HouseMode.AWAY, HouseMode.HOME)


def test_what_a_trigger_says_is_not_changed_nor_asked_for() -> None:
    rule = make_rule(then="{service: all_right, parameters: {person: $event.thing}}")
    for wrong in ({"person": "kim"}, {"other": "$event.thing"}):
        with pytest.raises(TaskError, match="change its file"):
            changed(rule, RuleChange(parameters=wrong))
    kept, problems = with_changes([rule], {"bell": RuleChange(parameters={"person": "kim"})})
    assert kept == (rule,) and "left aside" in problems[0]


@pytest.mark.parametrize("content", [b"", b"{", b'{"bell": {"confirm": "perhaps"}}', b"\xff"])
def test_when_changes_cannot_be_read_every_rule_asks_and_nothing_is_overwritten(
    tmp_path: Path, content: bytes
) -> None:
    (tmp_path / CHANGES_FILE).write_bytes(content)
    rules = service(tmp_path)
    (decision,) = rules.heard(bell(NOON), NOON)
    assert decision.request is not None and decision.request.confirm is Confirm.ASK
    assert "every rule asks first" in rules.problems[0]
    with pytest.raises(StoreError, match="mend or delete it first"):
        rules.change("bell", RuleChange(enabled=False))
    assert (tmp_path / CHANGES_FILE).read_bytes() == content


def test_a_change_that_cannot_be_kept_is_not_made(tmp_path: Path) -> None:
    rules = service(tmp_path / "file" / "tasks")
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(StoreError):
        rules.change("bell", RuleChange(enabled=False))
    assert rules.rules_answer().rules[0].enabled


@given(st.lists(CHANGES, max_size=4))
def test_changes_one_after_another_are_one_change(changes: list[RuleChange]) -> None:
    rule, together = make_rule(then="{service: look, parameters: {subject: sofa}}"), RuleChange()
    kept = rule
    for change in changes:
        kept, together = changed(kept, change), together.and_then(change)
    at_once = changed(rule, together)
    assert at_once == kept
