"""The table of who may change a mission: whole, obeyed, and the one in the documents."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from housefly.pilot.behavior import priorities
from housefly.pilot.behavior.priorities import PRIORITIES, Priority, Situation, Watch
from housefly.pilot.behavior.proposal import MissionChange

FOLDER = Path(priorities.__file__).parent
MODULES = {
    Watch.LANDING: "landing_monitor",
    Watch.BLIND_LANDING: "blind_landing",
    Watch.COLLISION: "collision_monitor",
    Watch.OFF_COURSE: "off_course",
    Watch.PASSING: "passing_monitor",
    Watch.FASTER_WAY: "faster_way",
    Watch.SEPARATION: "separation_monitor",
    Watch.NUDGE: "nudging",
}


def test_each_monitor_has_one_row_and_each_situation_and_maneuver_its_use() -> None:
    assert sorted(row.watch.name for row in PRIORITIES) == sorted(watch.name for watch in Watch)
    assert {one for row in PRIORITIES for one in row.silenced_by} == set(Situation)
    assert {one for row in PRIORITIES for one in row.may} == set(MissionChange)


def test_who_makes_way_for_people_has_the_last_word_but_for_a_hand_on_the_keys() -> None:
    order = [row.watch for row in PRIORITIES]
    assert order[-2:] == [Watch.SEPARATION, Watch.NUDGE]
    assert not PRIORITIES[-2].silenced_by


@pytest.mark.parametrize("row", PRIORITIES, ids=lambda row: row.watch.name)
def test_a_monitor_proposes_what_its_row_says_and_changes_no_mission_itself(row: Priority) -> None:
    tree = ast.parse((FOLDER / f"{MODULES[row.watch]}.py").read_text(encoding="utf-8"))
    proposed = {
        MissionChange[node.attr]
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute)
        and isinstance(node.value, ast.Name)
        and node.value.id == "MissionChange"
    }
    called = {node.func for node in ast.walk(tree) if isinstance(node, ast.Call)}
    lands = any(isinstance(func, ast.Name) and func.id == "landing_here" for func in called)
    proposed |= {MissionChange.LAND} if lands else set()
    assert proposed == set(row.may)
    imported = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    assert "housefly.pilot.behavior.commander" not in imported


def priorities_table() -> str:
    """Return the table in Markdown."""
    rows = ["| watches | may propose | not while |", "|---|---|---|"]
    for row in PRIORITIES:
        may = "; ".join(change.value for change in row.may) or "nothing: the gate asks it"
        silenced = " or ".join(situation.value for situation in row.silenced_by)
        rows.append(f"| {row.watch.value} | {may} | {silenced} |")
    return "\n".join(rows)


def test_the_page_shows_the_table_of_the_code() -> None:
    page = Path(__file__).parents[3] / "docs" / "safety.md"
    assert priorities_table() in page.read_text(encoding="utf-8")
