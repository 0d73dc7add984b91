"""What is shown while an identification flight is under way."""

from __future__ import annotations

import pytest

from housefly.app.identification_progress import IdentificationProgress


def test_an_output_without_a_terminal_gets_a_line_a_quarter(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with IdentificationProgress(24) as progress:
        for done in range(25):
            progress.show(done, "holding")
            progress.show(done, "holding")
    lines = [line for line in capsys.readouterr().out.splitlines() if "blocks flown" in line]
    assert lines == [f"{done} of 24 blocks flown" for done in (6, 12, 18, 24)]
