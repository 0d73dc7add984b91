"""Which processes a site with and without tasks has, and what is wrong with what its tasks read."""

from __future__ import annotations

from pathlib import Path

import pytest
from task_stage import TaskStage

from housefly.app.launcher import processes_of
from housefly.app.new_runtime import new_runtime
from housefly.errors import TaskError
from housefly.messages import OrderKind
from housefly.sites.loaded_site import read_site
from housefly.tasks.api.questions import RequestTask, RulesQuestion, Sentence, ServicesQuestion


@pytest.mark.parametrize("hub", [True, False])
@pytest.mark.parametrize("enabled", [True, False])
def test_tasks_run_where_a_site_wants_them_with_a_memory_or_without(
    tmp_path: Path, hub: bool, enabled: bool
) -> None:
    site = read_site("bsen", tasks__enabled=enabled, hub__enabled=hub, web__port=0)
    specs = {spec.name: spec for spec in processes_of(new_runtime(site, tmp_path))}
    assert ("tasks" in specs) is enabled
    if enabled:
        assert specs["tasks"].niceness == 3 and not specs["tasks"].lands


def test_documents_and_rules_are_found_beside_their_site(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "site.toml").write_text(
        '[tasks]\ndocuments = "mine"\nrules = "rules.yaml"\n', encoding="utf-8"
    )
    site = read_site(str(tmp_path / "site.toml"))
    assert site.tasks.documents == str(tmp_path / "mine")
    assert site.tasks.rules == str(tmp_path / "rules.yaml")


def test_a_pilot_that_brings_home_too_early_is_told(tmp_path: Path) -> None:
    stage = TaskStage(tmp_path, limits__hold_timeout=10.0)
    assert any("hold_timeout" in problem for problem in stage.problems)
    stage.close()
    stage = TaskStage(tmp_path)
    assert stage.problems == ()
    stage.close()


WRONG = "name: round\ntitle: x\nsteps:\n  - fly_about\n"


@pytest.fixture
def mine(tmp_path: Path) -> Path:
    folder = tmp_path / "mine"
    folder.mkdir()
    return folder


def test_a_wrong_document_or_rule_is_told_and_all_others_go_on(tmp_path: Path, mine: Path) -> None:
    (mine / "round.yaml").write_text(WRONG)
    rules = tmp_path / "rules.yaml"
    rules.write_text("rules:\n  - {name: x, when: {webhook: x}, then: {service: dance}}\n")
    stage = TaskStage(tmp_path, tasks__documents=str(mine), tasks__rules=str(rules))
    assert any("round.yaml, line 4" in problem for problem in stage.problems)
    assert any("dance" in problem for problem in stage.problems)
    services = {one.name: one for one in stage.ask(ServicesQuestion()).services}
    assert "round.yaml, line 4" in services["round"].problem
    assert services["round"].problem in services["round"].about, "pages show it, too"
    assert not services["look"].problem
    with pytest.raises(TaskError, match=r"round\.yaml, line 4") as caught:
        stage.ask(RequestTask("round"))
    assert caught.value.code == "unknown_service"
    assert stage.ask(RequestTask("look", {"subject": "sofa"})).tasks
    stage.close()


def test_a_document_that_was_mended_is_a_service_at_the_next_look(
    tmp_path: Path, mine: Path
) -> None:
    (mine / "round.yaml").write_text(WRONG)
    stage = TaskStage(tmp_path, tasks__documents=str(mine))
    (mine / "round.yaml").write_text("name: round\ntitle: My round\nsteps:\n  - land\n")
    assert stage.ask(RequestTask("round")).tasks[0].title == "My round"
    (mine / "round.yaml").unlink()
    assert "round" not in {one.name for one in stage.ask(ServicesQuestion()).services}
    stage.close()


@pytest.mark.parametrize("text", ["rules: [", "rules: 7", "rules:\n  - {name: x}\n", "\x00"])
def test_a_wrong_file_of_rules_leaves_the_shipped_ones(tmp_path: Path, text: str) -> None:
    rules = tmp_path / "rules.yaml"
    rules.write_text(text)
    stage = TaskStage(tmp_path, tasks__rules=str(rules))
    first, *others = stage.ask(RulesQuestion()).rules
    assert first.name == "own rules" and "rules.yaml" in first.words and not first.enabled
    assert {"bell", "person-fallen"} <= {one.name for one in others if one.enabled}
    assert any("rules.yaml" in problem for problem in stage.problems)
    stage.close()


@pytest.mark.parametrize("text", ["language: en\nintents: 7\n", "language: ["])
def test_wrong_sentences_of_ones_own_take_nobody_the_shipped_ones(
    tmp_path: Path, mine: Path, text: str
) -> None:
    (mine / "sentences").mkdir()
    (mine / "sentences" / "own.yaml").write_text(text)
    stage = TaskStage(tmp_path, tasks__documents=str(mine))
    stage.stand()
    stage.ask(Sentence("stop"))
    assert [order.kind for order in stage.orders] == [OrderKind.STOP]
    assert stage.ask(Sentence("where is the sofa")).understood
    stage.close()
