"""``housefly safety``: which rows can be asked for."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.app.safety_case.page import PAGE_FILE
from housefly.cli import main


@pytest.mark.parametrize("row", ["F13", "F19", "F30"])
def test_a_row_of_lock_step_or_of_real_processes_only_can_be_asked_for(
    row: str, tmp_path: Path
) -> None:
    assert main(["safety", "--rows", row, "--seeds", "0", "--out", str(tmp_path)]) == 0
    assert (tmp_path / PAGE_FILE).exists()


def test_a_row_that_is_not_flown_is_refused_with_those_that_are(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["safety", "--rows", "F99"]) == 2
    assert "F99" in (told := capsys.readouterr().err) and "F30" in told
