"""Rules are told with what may be set in them; what is set is checked."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from task_stage import TaskStage

from housefly.config.house_mode import HouseMode
from housefly.errors import TaskError
from housefly.tasks.api.questions import ChangeRule, RulesQuestion
from housefly.tasks.api.values import Confirm
from housefly.tasks.rules.change_store import CHANGES_FILE

RULES = """# Kept as it is.
rules:
  - name: evening
    when: {at: "21:00"}
    then: {service: look, parameters: {subject: sofa}}
    confirm: auto
"""


@pytest.fixture
def stage(tmp_path: Path) -> Iterator[TaskStage]:
    (tmp_path / "rules.yaml").write_text(RULES)
    made = TaskStage(tmp_path, tasks__rules=str(tmp_path / "rules.yaml"))
    yield made
    made.close()


def test_a_rule_is_a_sentence_whose_values_a_person_sets_beside_its_file(
    stage: TaskStage, tmp_path: Path
) -> None:
    told = {one.name: one for one in stage.ask(RulesQuestion()).rules}
    assert told["bell"].when == "When the bell rings" and told["bell"].confirm is Confirm.ASK
    assert told["bell"].title == "Look who is at the door"
    assert told["bell"].modes == (HouseMode.HOME, HouseMode.AWAY, HouseMode.NIGHT)
    assert told["person-fallen"].when == "When somebody may have fallen, if 50 % sure"
    assert "person" not in [one.name for one in told["person-fallen"].parameters]
    assert told["bell"].is_remembered and not told["bell-webhook"].is_remembered
    evening = told["evening"]
    assert evening.when == "Every day at 21:00"
    assert {one.name: one.default for one in evening.parameters}["subject"] == "sofa"
    change = ChangeRule("evening", False, Confirm.ASK, (HouseMode.HOME,), {"subject": "window"})
    answer = stage.ask(change)
    (evening,) = (one for one in answer.rules if one.name == "evening")
    assert (evening.enabled, evening.confirm) == (False, Confirm.ASK)
    assert {one.name: one.default for one in evening.parameters}["subject"] == "window"
    assert (tmp_path / "rules.yaml").read_text() == RULES
    answer = stage.ask(ChangeRule("evening", as_written=True))
    (evening,) = (one for one in answer.rules if one.name == "evening")
    assert evening.enabled and evening.confirm is Confirm.AUTO and not evening.changed_by


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (ChangeRule("evning", False), "there is no rule 'evning'; there is: bell"),
        (ChangeRule("evening", parameters={"colour": "red"}), "no parameter 'colour'"),
        (ChangeRule("evening", parameters={"subject": "the moon"}), "subject: "),
        (ChangeRule("evening", parameters={"subject": ""}), "subject is missing"),
        (ChangeRule("evening", parameters={"subject": "$event.thing"}), "change its file"),
        (ChangeRule("person-fallen", parameters={"person": "kim"}), "change its file"),
    ],
)
def test_what_a_rule_cannot_be_is_refused_and_nothing_is_kept(
    stage: TaskStage, change: ChangeRule, words: str
) -> None:
    before = stage.ask(RulesQuestion())
    with pytest.raises(TaskError, match=words):
        stage.ask(change)
    assert stage.ask(RulesQuestion()) == before
    assert not list(Path(stage.loaded.site.hub.store).parent.rglob(CHANGES_FILE))
