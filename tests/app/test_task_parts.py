"""Which processes a site with and without tasks has, and what is wrong with what its tasks read."""

from __future__ import annotations

from pathlib import Path

import pytest
from task_stage import TaskStage

from housefly.app.launcher import processes_of
from housefly.app.loaded_site import read_site
from housefly.app.runtime import new_runtime
from housefly.errors import TaskError


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


def test_a_wrong_document_is_refused_with_its_line_and_a_wrong_rule_is_told(
    tmp_path: Path,
) -> None:
    mine = tmp_path / "mine"
    mine.mkdir()
    (mine / "round.yaml").write_text("name: round\ntitle: x\nsteps:\n  - fly_about\n")
    with pytest.raises(TaskError, match=r"round\.yaml, line 4"):
        TaskStage(tmp_path, tasks__documents=str(mine))
    rules = tmp_path / "rules.yaml"
    rules.write_text("rules:\n  - {name: x, when: {webhook: x}, then: {service: dance}}\n")
    stage = TaskStage(tmp_path, tasks__rules=str(rules))
    assert any("dance" in problem for problem in stage.problems)
    stage.close()
