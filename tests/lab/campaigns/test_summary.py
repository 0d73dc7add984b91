"""What is said of each point of the grid."""

from __future__ import annotations

import csv
from math import nan
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq
import pytest

from housefly.errors import RecordingError
from housefly.lab.campaigns.folder import CampaignFolder
from housefly.lab.campaigns.plan import Chunk, Plan
from housefly.lab.campaigns.runner import fly_chunks
from housefly.lab.campaigns.summary import (
    estimate_text,
    summarize_campaign,
    value_text,
    write_summary,
)
from housefly.lab.experiments.intervals import NOTHING, IntervalEstimate, mean, share
from housefly.lab.experiments.outcomes import OUTCOME


class KnownFleet:
    """Drones that do what their columns say, so that the summary is known beforehand."""

    def fly(self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Any) -> Any:
        for chunk in reversed(chunks):
            cases, _ = plan.cases_of(chunk)
            flown = np.zeros(len(cases), OUTCOME)
            flown["stable"] = cases["seed"] % 3 != 0
            flown["rms_error"] = np.where(
                flown["stable"] == 1.0, cases["mocap_rate_hz"] + cases["mode"] + cases["seed"], 1e9
            )
            flown["arrival_time"] = nan
            yield chunk, flown


@pytest.fixture
def flown(small: Any, tmp_path: Path) -> tuple[Plan, Path]:
    plan: Plan = small(7, grid={"mocap_rate_hz": [10, 100], "mode": ["paper", "default"]})
    with CampaignFolder(tmp_path, plan) as folder:
        fly_chunks(plan, folder.missing(), folder, KnownFleet())
        return plan, folder.finish()


def test_each_point_is_told_in_the_order_of_the_grid_whatever_order_flew(
    flown: tuple[Plan, Path],
) -> None:
    plan, results = flown
    cells = summarize_campaign(plan.spec, results)
    assert [cell.values for cell in cells] == [(10.0, 1.0), (10.0, 0.0), (100.0, 1.0), (100.0, 0.0)]
    stable = np.array([seed for seed in range(30) if seed % 3])
    for cell in cells:
        rate, mode = cell.values
        assert cell.drones == 30
        assert cell.estimates["stable"] == share(np.arange(30) % 3 != 0)
        assert cell.estimates["rms_error"] == pytest.approx(mean(rate + mode + stable))
        assert cell.estimates["arrival_time"] == pytest.approx(NOTHING, nan_ok=True)
        assert cell.estimates["arrived"] == share(np.zeros(30, dtype=bool))


def test_results_of_both_modes_stand_in_one_file_mode_by_mode(flown: tuple[Plan, Path]) -> None:
    _, results = flown
    table = pq.read_table(results)
    assert table["cell"].to_pylist() == [cell for cell in (1, 3, 0, 2) for _ in range(30)]
    assert table["seed"].to_pylist() == [*range(30)] * 4


def test_the_file_of_the_summary_has_words_and_bounds(
    flown: tuple[Plan, Path], tmp_path: Path
) -> None:
    plan, results = flown
    write_summary(tmp_path / "summary.csv", plan.spec, summarize_campaign(plan.spec, results))
    with (tmp_path / "summary.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["mode"] for row in rows] == ["paper", "default", "paper", "default"]
    assert float(rows[0]["stable_low"]) < float(rows[0]["stable"]) < float(rows[0]["stable_high"])
    assert (rows[0]["arrival_time"], rows[0]["arrived"]) == ("nan", "0")
    with pytest.raises(RecordingError, match="cannot be written"):
        write_summary(tmp_path / "none" / "summary.csv", plan.spec, ())


@pytest.mark.parametrize(
    ("measure", "estimate", "words"),
    [
        ("rms_error", IntervalEstimate(0.01484, 0.0137, 0.0158), "0.0148 ± 0.0011"),
        ("arrival_time", IntervalEstimate(17.26, 16.9, 17.6), "17.26 ± 0.35"),
        ("ended_at", IntervalEstimate(1234.5, 1100.0, 1369.0), "1234 ± 134"),
        ("rms_error", IntervalEstimate(0.5, 0.5, 0.5), "0.500 ± 0.000"),
        ("rms_error", IntervalEstimate(0.5, nan, nan), "0.5"),
        ("rms_error", NOTHING, "-"),
        ("stable", IntervalEstimate(0.961, 0.87, 0.989), "96 % (87 to 99)"),
    ],
)
def test_estimates_are_told_with_the_digits_that_mean_something(
    measure: str, estimate: IntervalEstimate, words: str
) -> None:
    assert estimate_text(measure, estimate) == words


def test_columns_with_words_are_told_in_words() -> None:
    assert value_text("mode", 1.0) == "paper"
    assert value_text("estimator", 2.0) == "held_sample"
    assert value_text("mocap_rate_hz", 10.0) == "10"
