"""A cut of the flight-quality gate, flown: green as the tree is, red with a wrong gain."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from housefly.errors import ConfigError
from quality_gate.flown_row import RowMeasures
from quality_gate.gate import GateResult, GateRun, offered, run_gate
from quality_gate.page import write_quality_page
from quality_gate.scenario import WAY_CHANGES, Way
from quality_gate.tables import finding_words

SPACE = (Way.SPACE,)


def cut(*rows: str, ways: tuple[Way, ...] = (), **changes: object) -> GateResult:
    """Fly one errand of some rows."""
    run = GateRun(None, rows, ways, changes, quick=True, errands_max=1, ablated=False)
    return run_gate(run, lambda words: None)


def kept(folder: Path, tell: Callable[[str], None]) -> GateResult:
    """Fly what is held to the limits here, and keep it."""
    rows = ("errands-1.0", "eight-100")
    return run_gate(GateRun(folder, rows, quick=True, errands_max=1, ablated=False), tell)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("flown")


@pytest.fixture(scope="module")
def flown(folder: Path) -> GateResult:
    return kept(folder, lambda words: None)


def measures(result: GateResult, row: str, way: Way) -> RowMeasures:
    return next(one.measures for one in result.flown if (one.row, one.way) == (row, way.value))


@pytest.mark.interop
def test_the_gate_is_green(flown: GateResult) -> None:
    assert [finding_words(finding) for finding in flown.red] == []
    assert {row.way for row in flown.flown} >= {Way.GRID.value, Way.PAPER.value}


@pytest.mark.interop
def test_the_eight_of_mode_paper_is_far_from_its_line(flown: GateResult) -> None:
    grid, paper = (measures(flown, "eight-100", way) for way in (Way.GRID, Way.PAPER))
    assert paper.path_rms > 2.0 * grid.path_rms


def test_a_wrong_gain_turns_it_red() -> None:
    weak = cut("errands-1.0", ways=(Way.GRID,), control__alpha=0.8, control__beta=2.0)
    assert {finding.limit.measure for finding in weak.red} >= {"reference_rms"}


@pytest.mark.interop
@pytest.mark.skipif(not offered(WAY_CHANGES[Way.SPACE]), reason="no trajectories in space yet")
def test_corners_instead_of_curves_turn_it_red() -> None:
    corners = cut("errands-1.0", ways=SPACE, map__planner="grid")
    assert {finding.limit.measure for finding in corners.red} >= {"overshoot"}


@pytest.mark.interop
def test_the_same_command_flies_nothing_again_and_the_page_shows_it(
    flown: GateResult, folder: Path
) -> None:
    told: list[str] = []
    assert repr(kept(folder, told.append).flown) == repr(flown.flown)
    assert len(told) == 1
    page = write_quality_page(folder, flown, "make test").read_text()
    assert "0 of " in page and page.count("<svg") == 2


def test_a_row_and_a_key_that_are_none_are_named() -> None:
    with pytest.raises(ConfigError, match="no-row"):
        cut("no-row")
    with pytest.raises(ConfigError, match="tea"):
        cut("errands-1.0", control__tea=1.0)
