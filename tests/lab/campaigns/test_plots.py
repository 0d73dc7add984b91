"""Pictures of any grid: every axis and unit is on them."""

from __future__ import annotations

from itertools import product
from math import nan
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from housefly.errors import RecordingError
from housefly.lab.campaigns.plots import draw_campaign
from housefly.lab.campaigns.spec import CampaignSpec, spec_from_tree
from housefly.lab.campaigns.summary import GridPoint
from housefly.lab.experiments.intervals import NOTHING, IntervalEstimate

RATES = [10, 20, 30, 50, 100]


def spec_of(grid: dict[str, Any]) -> CampaignSpec:
    return spec_from_tree(
        {"name": "grid", "mission": {"waypoints": [[0, 0], [1, 0]]}, "grid": grid}
    )


def cells_of(spec: CampaignSpec, empty: int = 0) -> tuple[GridPoint, ...]:
    points = list(product(*spec.grid.values()))
    cells = []
    for number, point in enumerate(points):
        value = 0.5 + 0.4 * np.sin(number)
        found = (
            NOTHING
            if number >= len(points) - empty
            else IntervalEstimate(value, value - 0.05, value + 0.05)
        )
        cells.append(
            GridPoint(
                tuple(float(x) for x in point),
                10,
                {"stable": IntervalEstimate(1.0, 0.9, 1.0), "rms_error": found},
            )
        )
    return tuple(cells)


def drawn(grid: dict[str, Any], folder: Path, measure: str = "rms_error", empty: int = 0) -> str:
    spec = spec_of(grid)
    png, svg = draw_campaign(spec, cells_of(spec, empty), measure, folder / measure)
    with Image.open(png) as picture:
        assert picture.width >= 900 and picture.height >= 500
        assert len(picture.convert("RGB").getcolors(1 << 20) or ()) > 20
    return svg.read_text()


@pytest.mark.parametrize(
    ("grid", "words"),
    [
        ({"mocap_rate_hz": RATES}, ("mocap_rate_hz [Hz]",)),
        ({"mode": ["default", "paper"]}, ("default", "paper")),
        (
            {"mode": ["default", "paper"], "mocap_rate_hz": RATES},
            ("mocap_rate_hz [Hz]", "default", "paper"),
        ),
        ({"alpha": [*range(1, 9)], "beta": [*range(1, 10)]}, ("alpha [1/s]", "beta [1/s^2]")),
        (
            {"mode": ["default", "paper"], "mocap_rate_hz": RATES, "mocap_latency": [0.0, 0.1]},
            ("mocap_rate_hz [Hz]", "mocap_latency 0.1 s", "paper"),
        ),
        (
            {
                "alpha": [*range(1, 9)],
                "beta": [*range(1, 10)],
                "drag": [0.1, 0.2, 0.3],
                "mode": ["default", "paper"],
            },
            ("alpha [1/s]", "beta [1/s^2]", "drag 0.3 1/s", "mode paper"),
        ),
    ],
)
def test_every_axis_of_the_grid_is_on_the_picture_with_its_unit(
    grid: dict[str, Any], words: tuple[str, ...], tmp_path: Path
) -> None:
    svg = drawn(grid, tmp_path)
    for word in (*words, "rms_error [m]"):
        assert word in svg, word
    assert "no stable flight" not in svg


@pytest.mark.parametrize(
    "grid",
    [
        {"mocap_rate_hz": RATES},
        {"alpha": [*range(1, 9)], "beta": [*range(1, 10)]},
        {"mode": ["default", "paper"]},
    ],
)
def test_a_point_without_stable_flights_is_shown_as_such(
    grid: dict[str, Any], tmp_path: Path
) -> None:
    assert "no stable flight" in drawn(grid, tmp_path, empty=1)
    assert "no stable flight" in drawn(grid, tmp_path, empty=1000)


def test_panels_that_are_left_out_are_counted(tmp_path: Path) -> None:
    grid = {
        "lag": [*range(1, 8)],
        "alpha": [*range(1, 8)],
        "beta": [1, 2, 3, 4, 5, 6],
        "drag": [1, 2, 3, 4, 5],
    }
    assert "the first 12 of 30 panels" in drawn(grid, tmp_path)


def test_a_single_point_has_no_picture(tmp_path: Path) -> None:
    spec = spec_of({"lag": [7.0]})
    assert draw_campaign(spec, cells_of(spec), "stable", tmp_path / "stable") == ()
    assert not list(tmp_path.iterdir())


def test_the_same_numbers_give_the_same_bytes(tmp_path: Path) -> None:
    assert drawn({"mocap_rate_hz": RATES}, tmp_path) == drawn({"mocap_rate_hz": RATES}, tmp_path)


def test_a_picture_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    spec = spec_of({"mocap_rate_hz": RATES})
    with pytest.raises(RecordingError, match="cannot be written"):
        draw_campaign(spec, cells_of(spec), "stable", tmp_path / "none" / "stable")


def test_words_along_an_axis_are_points_and_no_line(tmp_path: Path) -> None:
    spec = spec_of(
        {
            "mode": ["default", "paper"],
            "estimator": ["on_arrival", "held_sample", "finite_difference"],
        }
    )
    svg = draw_campaign(spec, cells_of(spec), "rms_error", tmp_path / "a")[1].read_text()
    assert all(
        word in svg
        for word in ("default", "paper", "on_arrival", "held_sample", "finite_difference")
    )


def test_nan_bounds_do_not_break_a_line(tmp_path: Path) -> None:
    spec = spec_of({"mocap_rate_hz": [10, 20]})
    cells = tuple(
        GridPoint(cell.values, 1, {"rms_error": IntervalEstimate(0.1, nan, nan)})
        for cell in cells_of(spec)
    )
    assert draw_campaign(spec, cells, "rms_error", tmp_path / "rms_error")
