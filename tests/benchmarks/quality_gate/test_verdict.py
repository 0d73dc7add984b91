"""What turns a row red."""

from __future__ import annotations

from dataclasses import fields, replace
from math import inf, nan
from pathlib import Path

import pytest

from housefly.errors import RecordingError
from quality_gate.flown_row import FlownRow, RowMeasures
from quality_gate.kept_rows import KEPT_FILE, keep_row, kept_rows
from quality_gate.rows import GATE_ROWS
from quality_gate.scenario import FlightKind, Limit, Way
from quality_gate.verdict import limit_findings

ROW = FlownRow("eight-100", Way.SPACE.value, "", RowMeasures(path_rms=0.006), (), "", 1.0)


@pytest.mark.parametrize("value", [0.021, inf, nan])
def test_too_much_and_what_is_not_known_is_red(value: float) -> None:
    assert not Limit("overshoot", most=0.02).holds(value)
    assert Limit("overshoot", most=0.02).holds(0.02)


@pytest.mark.parametrize("row", GATE_ROWS, ids=lambda row: row.name)
def test_every_limit_names_a_measure_and_every_way_has_one(row) -> None:  # type: ignore[no-untyped-def]
    known = {field.name for field in fields(RowMeasures)}
    assert {limit.measure for limit in row.limits} <= known
    for way in set(row.ways) - {Way.PAPER}:
        assert any(way in limit.ways for limit in row.limits)


def test_trajectories_must_keep_to_the_eight_ten_times_better_than_mode_paper() -> None:
    eight = next(row for row in GATE_ROWS if row.kind is FlightKind.EIGHT)
    beside = replace(ROW, way=Way.PAPER.value, measures=RowMeasures(path_rms=0.059))
    found = limit_findings(eight, (ROW, beside))[-1]
    assert found.limit.measure == "path_rms" and not found.holds
    better = replace(beside, measures=RowMeasures(path_rms=0.061))
    assert limit_findings(eight, (ROW, better))[-1].holds


def test_a_row_in_which_nothing_flew_is_red_even_when_it_is_cut_short() -> None:
    for row in GATE_ROWS:
        nothing = replace(ROW, row=row.name, measures=RowMeasures())
        found = limit_findings(row, (nothing,), whole=False)
        assert [one.holds for one in found if one.limit.measure == "arrived"] == [False]


def test_what_was_flown_is_kept_and_a_line_that_was_cut_short_is_flown_again(
    tmp_path: Path,
) -> None:
    keep_row(tmp_path, ROW)
    with (tmp_path / KEPT_FILE).open("a") as file:
        file.write('{"row": "half')
    assert list(kept_rows(tmp_path)) == [("eight-100", "space", "")]
    keep_row(tmp_path, replace(ROW, row="door"))
    assert [key[0] for key in kept_rows(tmp_path)] == ["eight-100", "door"]


def test_a_line_in_the_middle_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    (tmp_path / KEPT_FILE).write_text("nonsense\n")
    keep_row(tmp_path, ROW)
    with pytest.raises(RecordingError, match="line 1"):
        kept_rows(tmp_path)
