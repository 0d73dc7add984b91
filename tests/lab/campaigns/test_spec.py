"""Campaign files: good ones are read, bad ones are named by key."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from housefly.errors import ConfigError
from housefly.lab.campaigns.spec import load_spec, spec_from_tree

ROOT = Path(__file__).resolve().parents[3]
GOOD: dict[str, Any] = {"name": "a", "mission": {"waypoints": [[0.0, 0.0], [1.0, 0.0]]}}


def test_words_become_the_numbers_of_their_columns() -> None:
    spec = spec_from_tree(
        GOOD | {"grid": {"mode": ["default", "paper"], "estimator": ["held_sample"]}, "seeds": 3}
    )
    assert spec.grid == {"mode": (0.0, 1.0), "estimator": (2.0,)}
    assert (spec.points, spec.drones) == (2, 6)


@pytest.mark.parametrize(
    ("change", "key", "words"),
    [
        ({"seeds": 0}, "seeds", "is 0; allowed: a number from 1 to 10000000"),
        ({"seedz": 3}, "seedz", "not a known key"),
        ({"name": "../x"}, "name", "pattern"),
        ({"fixed": {"alfa": 1.0}}, "fixed.alfa", "is no column; there are: mode, "),
        (
            {"fixed": {"mocap_rate_hz": 0.0}},
            "fixed.mocap_rate_hz",
            "allowed: a number from 1 to 400 Hz",
        ),
        ({"grid": {"lag": [7.0, "fast"]}}, "grid.lag", "'fast'; allowed: a number"),
        ({"grid": {"lag": [7.0, float("nan")]}}, "grid.lag", "0.5 to 50 1/s"),
        ({"grid": {"lag": []}}, "grid.lag", "is empty"),
        ({"grid": {"lag": [7.0, 7.0]}}, "grid.lag", "twice"),
        ({"grid": {"mode": ["fast"]}}, "grid.mode", "one of default, paper"),
        ({"grid": {"estimator": [0.5]}}, "grid.estimator", "delay_compensated (0)"),
        ({"grid": {"lag": [5.0]}, "fixed": {"lag": 7.0}}, "grid.lag", "given in [fixed] too"),
        ({"draw": {"mode": {"choice": [0.0, 1.0]}}}, "draw.mode", "[grid] or [fixed]"),
        ({"draw": {"lag": {"uniform": [9.0, 5.0]}}}, "draw.lag", "first must be below the second"),
        ({"draw": {"lag": {"uniform": [0.0, 5.0]}}}, "draw.lag", "0.5 to 50 1/s"),
        ({"draw": {"lag": {"normal": [7.0, -1.0]}}}, "draw.lag", "positive sigma"),
        ({"draw": {"lag": {"normal": [7.0, 1.0], "choice": [1.0]}}}, "draw.lag", "exactly one of"),
        ({"draw": {"lag": {"gauss": [7.0, 1.0]}}}, "draw.lag.gauss", "not a known key"),
        ({"draw": {"drag": {"loguniform": [0.0, 1.0]}}}, "draw.drag", "both must be positive"),
        ({"draw": {"estimator": {"uniform": [0.0, 3.0]}}}, "draw.estimator", "whole numbers"),
        (
            {"draw": {"estimator": {"choice": ["best"]}}},
            "draw.estimator.choice",
            "one of delay_compensated",
        ),
        (
            {"draw": {"lag": {"choice": [7.0, 100.0]}}},
            "draw.lag.choice",
            "is 100; allowed: a number from 0.5 to 50 1/s",
        ),
        ({"draw": {"lag": {"choice": []}}}, "draw.lag.choice", "at least 1"),
        (
            {"draw": {"pose_age_level": {"uniform": [0.1, float("inf")]}}},
            "draw.pose_age_level",
            "finite",
        ),
        ({"fixed": {"wrap_yaw": True}}, "fixed.wrap_yaw", "True"),
        (
            {"mission": {"waypoints": [[0.0, 0.0], [float("nan"), 1.0]]}},
            "mission.waypoints.1.0",
            "finite number",
        ),
        (
            {"mission": {"waypoints": [[0.0, 0.0], [5000.0, 1.0]]}},
            "mission.waypoints.1.0",
            "less than or equal to 1000",
        ),
        (
            {"grid": {name: [1 + n / 1000 for n in range(400)] for name in ("drag", "gain")}},
            "grid",
            "160000 points; allowed",
        ),
        ({"mission": {}}, "mission", "either goal"),
        (
            {"mission": {"goal": "a", "waypoints": [[0.0, 0.0], [1.0, 1.0]]}},
            "mission",
            "either goal",
        ),
        ({"mission": {"waypoints": [[0.0, 0.0]]}}, "mission.waypoints", "at least two"),
        (
            {"mission": {"goal": "sofa", "duration_s": 1.0}},
            "mission.duration_s",
            "is 1.0; allowed: a number from 3 to 3600 s",
        ),
        ({"plot": ["beauty"]}, "plot", "is no measure"),
        (
            {"seeds": 10_000_000, "grid": {"lag": [5.0, 6.0, 7.0, 8.0, 9.0, 10.0]}},
            "seeds",
            "60000000 drones; allowed: at most 50000000",
        ),
    ],
)
def test_a_bad_key_is_named_with_what_is_allowed(
    change: dict[str, Any], key: str, words: str
) -> None:
    with pytest.raises(ConfigError) as caught:
        spec_from_tree(GOOD | change)
    assert caught.value.key == key
    assert words in caught.value.problem


def test_a_file_that_is_none_is_named(tmp_path: Path) -> None:
    torn = tmp_path / "torn.toml"
    torn.write_text("name = ")
    for path, words in ((tmp_path / "absent.toml", "cannot be read"), (torn, "cannot be parsed")):
        with pytest.raises(ConfigError, match=words):
            load_spec(path)


def test_the_file_on_the_page_and_the_one_of_the_example_are_good() -> None:
    page = (ROOT / "docs" / "campaigns.md").read_text(encoding="utf-8")
    shown = page.split("```toml\n")[1].split("```")[0]
    assert spec_from_tree(tomllib.loads(shown)).points == 10
    assert load_spec(ROOT / "examples" / "08_tracking_rate.toml").drones == 1000
