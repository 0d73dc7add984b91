"""Every claim of docs/security.md names a test that exists, and every attack is claimed."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parents[1]
PAGE = (TESTS.parent / "docs" / "security.md").read_text(encoding="utf-8")
NAMED = re.findall(r"`([\w/]+\.py)::(test_\w+)`", PAGE)
CLAIM = re.compile(r"^\| [\d., ]+ .*\|$", re.MULTILINE)


@pytest.mark.parametrize(("file", "name"), NAMED)
def test_the_test_that_a_claim_names_exists(file: str, name: str) -> None:
    tree = ast.parse((TESTS / file).read_text(encoding="utf-8"))
    functions = (ast.FunctionDef, ast.AsyncFunctionDef)
    assert name in {node.name for node in ast.walk(tree) if isinstance(node, functions)}


def test_every_row_of_the_claims_names_a_test() -> None:
    rows = CLAIM.findall(PAGE)
    assert len(rows) >= 15
    assert [row for row in rows if "::test_" not in row] == []
