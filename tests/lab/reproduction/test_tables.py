"""The tables that the paper lacks: complete, with intervals, from the flights that they name."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from matplotlib.text import Text

from housefly.lab.experiments.intervals import mean, share
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.streams import LATENCIES, LOOP_FREQUENCIES, LOSSES, RATES
from housefly.lab.reproduction.table_plots import draw_stability, draw_table_plots
from housefly.lab.reproduction.tables import tables


def test_every_rate_latency_loss_and_gain_has_its_cell(evidence: Evidence) -> None:
    found = tables(evidence)
    assert all(len(row) == len(table.headings) for table in found for row in table.rows)
    streams = [table for table in found if len(table.headings) == 2 + len(LATENCIES) * len(LOSSES)]
    assert len(streams) == 7
    assert all(len(table.rows) == 2 * len(RATES) for table in streams)
    gains = next(table for table in found if "cautious" in table.title)
    assert [row[1] for row in gains.rows] == 2 * [
        f"{frequency:.1f}" for frequency in LOOP_FREQUENCIES
    ]


def test_a_cell_is_the_mean_of_its_flights_with_its_interval(evidence: Evidence) -> None:
    table = next(table for table in tables(evidence) if "Root mean square" in table.title)
    row = next(row for row in table.rows if row[:2] == ("default", "30"))
    flown = evidence.streams.where(
        mode="default", mocap_rate_hz=30.0, mocap_latency=0.05, mocap_dropout=0.0
    )
    expected = mean(flown["rms_error"][flown["stable"] == 1.0])
    value, half = map(float, row[3].split(" ± "))
    assert abs(value - 100 * expected.value) < 0.051
    assert abs(half - 100 * expected.half) < 0.051


def test_intervals_are_those_of_the_textbooks() -> None:
    assert np.allclose(mean([1.0, 2.0, 3.0, 4.0]), (2.5, 0.4457, 4.5543), atol=1e-4)
    assert np.allclose(share([True] * 9 + [False]), (0.9, 0.5958, 0.9821), atol=1e-4)
    assert np.isnan(mean([]).value) and np.isnan(mean([1.0]).low)


def test_default_keeps_the_path_better_than_paper_on_every_stream(evidence: Evidence) -> None:
    for rate in RATES:
        ours, theirs = (
            evidence.streams.where(
                mode=mode, mocap_rate_hz=rate, mocap_latency=0.05, mocap_dropout=0.0
            )["rms_error"]
            for mode in ("default", "paper")
        )
        assert np.median(ours) < np.median(theirs)


def test_both_pictures_are_written(evidence: Evidence, tmp_path: Path) -> None:
    for exhibit in draw_table_plots(evidence, tmp_path):
        assert (tmp_path / f"{exhibit.stem}.png").stat().st_size > 20_000
        assert re.search(r"<svg", (tmp_path / f"{exhibit.stem}.svg").read_text())


def test_a_drone_that_always_rings_is_counted_in_its_cell_and_lowers_the_mean(
    evidence: Evidence,
) -> None:
    values = evidence.edges.values.copy()
    values[0, 0, 0, 0] = np.nan
    ringing = replace(evidence, edges=replace(evidence.edges, values=values))
    before, after = (tables(seen)[-1].rows[0][2] for seen in (evidence, ringing))
    assert after.endswith("\u21931") and "\u2193" not in before
    assert float(after.split()[0]) < float(before.split()[0])
    figure = Figure()
    draw_stability(figure, ringing)
    written = [text.get_text() for text in figure.findobj(Text)]
    assert "\u21931" in written
    assert any(" 1 lie below" in text for text in written)


def test_flights_that_never_arrived_are_counted_beside_the_mean_time(evidence: Evidence) -> None:
    outcomes = evidence.streams.outcomes.copy()
    first = np.flatnonzero((evidence.streams.cases["mode"] == 0) & (outcomes["stable"] == 1.0))
    outcomes["arrival_time"][first] = np.where(np.arange(first.size) % 6 == 0, np.nan, 17.0)
    some = replace(evidence, streams=replace(evidence.streams, outcomes=outcomes))
    table = next(table for table in tables(some) if "for good" in table.title)
    assert any(re.search(r"\[[0-5]/6\]$", cell) for row in table.rows for cell in row)
