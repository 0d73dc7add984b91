"""``housefly safety``: which rows can be asked for."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from housefly.cli import main
from housefly.errors import ConfigError
from housefly.lab.safety_case import campaign, flown_by
from housefly.lab.safety_case.campaign import RESULTS_FILE, WIRED_RESULTS_FILE
from housefly.lab.safety_case.fault_phase import FaultPhase
from housefly.lab.safety_case.faulty_flight import variant_of
from housefly.lab.safety_case.flown_by import FLOWN_BY_FILE
from housefly.lab.safety_case.page import PAGE_FILE
from housefly.lab.safety_case.trial import TrialKey, TrialResult
from housefly.lab.safety_case.wired_flight import WiredKey, WiredResult


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
        ("F13/nan", "F13/2cm, F13/5cm, F13/steps, F13/jumps_5cm, F13/up_5cm"),
        ("F13/[/x]", "F13/2cm, F13/5cm, F13/steps, F13/jumps_5cm, F13/up_5cm"),
        ("F13/", "F13/2cm, F13/5cm, F13/steps, F13/jumps_5cm, F13/up_5cm"),
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


OLD, NEW = "0123456789ab", "fedcba987654"
AGAIN = ("safety", "--rows", "F13", "--seeds", "2", "--workers", "1")


@pytest.fixture
def fly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., int]:
    """Run the command as some source: every flight lands at once, and is written to flown.txt."""
    flown = tmp_path / "flown.txt"

    def landed(key: TrialKey) -> TrialResult:
        flown.write_text(f"{key}\n")
        return TrialResult(key, FaultPhase.CRUISE, (), "stands", 0.2, 6.0, 0.1, 0.4, None, 0.5)

    def landed_wired(key: WiredKey, folder: Path, seat: int) -> WiredResult:
        flown.write_text(f"{key}\n")
        return WiredResult(key, 3.0, (), "landed")

    def run(source: str, *words: str) -> int:
        monkeypatch.setattr(flown_by, "source_digest", lambda: source)
        flown.write_text("")
        return main([*(words or AGAIN), "--out", str(tmp_path / "case")])

    monkeypatch.setattr(campaign, "fly_trial", landed)
    monkeypatch.setattr(campaign, "fly_wired", landed_wired)
    monkeypatch.setattr("housefly.app.compiling.compile_once", lambda *_: None)
    return run


@pytest.mark.parametrize(
    "again",
    [
        AGAIN,
        ("safety", "--rows", "F13", "--seeds", "3", "--workers", "1"),
        ("safety", "--rows", "F13", "--seeds", "0", "--wires", "1"),
    ],
)
def test_what_another_source_flew_is_refused_before_anything_is_flown_or_written(
    again: tuple[str, ...],
    fly: Callable[..., int],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    fly(OLD)
    before = {path: path.read_bytes() for path in (tmp_path / "case").iterdir()}
    capsys.readouterr()
    assert fly(NEW, *again) == 2
    told = capsys.readouterr().err
    assert OLD in told and NEW in told and "--seeds 0" in told
    assert not (tmp_path / "flown.txt").read_text()
    assert {path: path.read_bytes() for path in (tmp_path / "case").iterdir()} == before


def test_what_the_same_source_flew_is_gone_on_with(fly: Callable[..., int], tmp_path: Path) -> None:
    fly(OLD)
    began = (tmp_path / "case" / FLOWN_BY_FILE).read_bytes()
    assert fly(OLD) in (0, 1) and not (tmp_path / "flown.txt").read_text()
    assert fly(OLD, *AGAIN, "--wires", "1") in (0, 1) and (tmp_path / "flown.txt").read_text()
    assert (tmp_path / "case" / FLOWN_BY_FILE).read_bytes() == began


@pytest.mark.parametrize("file", [RESULTS_FILE, WIRED_RESULTS_FILE])
def test_results_of_nobody_knows_which_source_are_refused(
    file: str, fly: Callable[..., int], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    fly(OLD, *AGAIN, "--wires", "1")
    for other in {FLOWN_BY_FILE, RESULTS_FILE, WIRED_RESULTS_FILE} - {file}:
        (tmp_path / "case" / other).unlink()
    assert fly(OLD) == 2
    assert "not known" in capsys.readouterr().err
    assert not (tmp_path / "flown.txt").read_text()


def test_the_page_alone_is_made_of_what_is_there_and_says_which_source_flew_it_and_since_when(
    fly: Callable[..., int], tmp_path: Path
) -> None:
    fly(OLD, *AGAIN, "--wires", "1")
    fly(NEW, "safety", "--seeds", "0")
    page = (tmp_path / "case" / PAGE_FILE).read_text()
    since = flown_by.read_flown_by(tmp_path / "case")
    assert since is not None
    assert f"<dt>flown by</dt><dd>source {OLD} since {since.since}; now it is {NEW}</dd>" in page
    assert "<dt>made by</dt><dd>housefly safety --seeds 2 --wires 1</dd>" in page
    assert not (tmp_path / "flown.txt").read_text()


def test_a_page_of_no_flights_names_no_source(fly: Callable[..., int], tmp_path: Path) -> None:
    assert fly(NEW, "safety", "--seeds", "0") == 0
    assert "<dt>flown by</dt>" not in (tmp_path / "case" / PAGE_FILE).read_text()
    assert not (tmp_path / "case" / FLOWN_BY_FILE).exists()
