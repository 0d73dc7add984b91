from __future__ import annotations

import os
import shutil
import subprocess
import sys
from math import pi
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import housefly
from housefly.numeric import clipped, wrapped

CALLER = """
from housefly.numeric import compiled
from housefly.pilot.control.laws import demand

@compiled
def doubled(error):
    return 2.0 * demand(error, 0.0, 0.0, 1.0, 2.0)
"""


@given(st.floats(-50.0, 50.0))
def test_a_wrapped_angle_is_the_same_direction_in_one_turn(angle: float) -> None:
    assert -pi < wrapped(angle) <= pi
    assert np.exp(1j * wrapped(angle)) == pytest.approx(np.exp(1j * angle), abs=1e-9)
    assert wrapped(wrapped(angle)) == wrapped(angle)


@given(st.floats(-5.0, 5.0), st.floats(0.0, 3.0))
def test_a_clipped_value_is_the_nearest_within_the_bound(value: float, bound: float) -> None:
    assert clipped(value, bound) == float(np.clip(value, -bound, bound))


@pytest.mark.parametrize("own_cache", [False, True])
def test_a_caller_follows_when_what_it_calls_is_changed(tmp_path: Path, own_cache: bool) -> None:
    """The compiled code on disk of one file must not outlive a change in another."""
    copy = tmp_path / "housefly"
    shutil.copytree(
        Path(housefly.__file__).parent, copy, ignore=shutil.ignore_patterns("__pycache__")
    )
    (copy / "lab" / "experiments" / "caller.py").write_text(CALLER)
    assert doubled(tmp_path, own_cache) == 4.0
    laws = copy / "pilot" / "control" / "laws.py"
    laws.write_text(
        laws.read_text().replace("return beta * error +", "return 3.0 * beta * error +")
    )
    assert doubled(tmp_path, own_cache) == 12.0


def doubled(path: Path, own_cache: bool) -> float:
    code = "from housefly.lab.experiments.caller import doubled; print(doubled(1.0))"
    environment = {key: value for key, value in os.environ.items() if key != "NUMBA_CACHE_DIR"} | {
        "PYTHONPATH": str(path)
    }
    if own_cache:
        environment["NUMBA_CACHE_DIR"] = str(path / "cache")
    answer = subprocess.run(
        [sys.executable, "-c", code], env=environment, check=True, capture_output=True, text=True
    )
    return float(answer.stdout)
