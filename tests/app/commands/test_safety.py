"""``housefly safety``: which rows can be asked for."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.app.safety_case.faulty_flight import variant_of
from housefly.app.safety_case.page import PAGE_FILE
from housefly.cli import main
from housefly.errors import ConfigError


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


@pytest.mark.parametrize(
    ("asked", "named"),
    [
        ("F13/nan", "F13/2cm, F13/5cm, F13/steps"),
        ("F13/[/x]", "F13/2cm, F13/5cm, F13/steps"),
        ("F13/", "F13/2cm, F13/5cm, F13/steps"),
        ("F99", "calm, F01, F02"),
        ("F19", "calm, F01, F02"),
        ("F30", "calm, F01, F02"),
        ("F13+", "calm, F01, F02"),
        ("F13+F99", "calm, F01, F02"),
        ("", "--again: is empty"),
    ],
)
def test_one_flight_again_of_no_row_or_variant_is_refused_with_those_that_are(
    asked: str, named: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["safety", "--again", asked]) == 2
    assert named in capsys.readouterr().err


def test_a_row_means_its_first_variant_and_an_unknown_one_means_nothing() -> None:
    assert variant_of("F13").name == "2cm"
    assert variant_of("F13/5cm").name == "5cm"
    with pytest.raises(ConfigError, match="F13/2cm, F13/5cm"):
        variant_of("F13/unknown")
    with pytest.raises(ConfigError, match="no fault of the simulated room"):
        variant_of("F30")


@pytest.mark.parametrize("workers", ["-1", "257"])
def test_so_many_processes_are_refused(workers: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["safety", "--rows", "F13", "--workers", workers]) == 2
    assert "--workers" in capsys.readouterr().err


def test_a_folder_that_cannot_be_written_is_told_before_anything_is_flown(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    assert main(["safety", "--quick", "--out", str(tmp_path / "file" / "case")]) == 2
    assert "cannot be written to" in capsys.readouterr().err
