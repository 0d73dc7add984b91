"""Every claim of docs/security.md names a test that exists, and every attack here is claimed."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parents[1]
PAGE = (TESTS.parent / "docs" / "security.md").read_text(encoding="utf-8")
NAMED = re.findall(r"`([\w/]+\.py)::(test_\w+)`", PAGE)
CONTROLS = {
    "test_a_broker_of_our_own_on_loopback_is_allowed",
    "test_who_may_fly_by_itself_is_believed_of_a_broker_with_users",
    "test_an_entry_of_the_list_of_allowed_devices_is_checked",
    "test_things_of_long_ago_make_room_for_new_ones",
    "test_no_device_is_listened_to_unless_the_site_says_so",
    "test_there_are_locks_for_flying_testing_building_auditing_fuzzing_and_strangers",
    "test_every_line_of_a_lock_is_a_version_with_hashes",
    "test_the_locks_hold_what_the_project_needs_at_the_versions_of_the_constraints",
    "test_a_stranger_is_asked_who_he_is_and_a_user_gets_in_under_his_own_name",
    "test_a_form_that_is_none_is_refused_in_words",
    "test_the_printed_link_works_beside_the_users",
    "test_without_users_nobody_logs_in_and_the_page_is_the_old_one",
    "test_the_attack_itself_works_where_the_folder_is_open",
    "test_a_port_that_nobody_holds_can_be_taken_by_another_user",
    "test_what_a_killed_run_left_behind_is_removed_by_the_next",
    "test_a_person_logs_in_sees_the_drone_and_logs_out_in_a_browser",
}
"""No attacks: what is let in, what is kept in order, and that an attack works where it may."""
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
CLAIM = re.compile(r"^\| [\d., ]+ .*\|$", re.MULTILINE)


@pytest.mark.parametrize(("file", "name"), NAMED)
def test_the_test_that_a_claim_names_exists(file: str, name: str) -> None:
    tree = ast.parse((TESTS / file).read_text(encoding="utf-8"))
    assert name in {node.name for node in ast.walk(tree) if isinstance(node, FUNCTIONS)}


def test_every_attack_is_claimed() -> None:
    files = [file for file in Path(__file__).parent.glob("test_*.py") if file != Path(__file__)]
    there = {
        (f"security/{file.name}", node.name)
        for file in files
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, FUNCTIONS) and node.name.startswith("test_")
    }
    assert {name for _, name in there - set(NAMED)} == CONTROLS


def test_every_row_of_the_claims_names_a_test() -> None:
    rows = CLAIM.findall(PAGE)
    assert len(rows) >= 15
    assert [row for row in rows if "::test_" not in row] == []
