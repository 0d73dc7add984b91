"""Campaigns fly what is estimated in flight: loads, wrong delays and bad tracking."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from housefly.config.estimation import ONLY_LEVEL_PUSHES
from housefly.config.site import Site, changed
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many, fly_traced
from housefly.lab.experiments.flight_plan import FlightPlan, Task

HOLD = FlightPlan(Task.HOLD, ((0.0, 0.0),), 9.0)
PATH = FlightPlan(Task.PATH, ((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)), 30.0)
PLAIN = changed(Site(), estimation=ONLY_LEVEL_PUSHES.model_dump())
"""A site whose pilot works out nothing but a push in the plane."""
LOAD = -0.98
"""A tenth of the weight, upwards [m/s^2]."""


def drone(site: Site | None = None, **columns: Any) -> np.ndarray:
    return cases(site or Site(), 1, **columns)


@pytest.mark.parametrize("lift", [LOAD, -LOAD])
def test_a_tenth_of_the_weight_is_held_within_three_centimetres_after_five_seconds(
    lift: float,
) -> None:
    loaded: dict[str, Any] = {"lift": lift, "climb_command_max": 1.0}
    held, left = fly_traced(drone(**loaded), HOLD), fly_traced(drone(PLAIN, **loaded), HOLD)
    wanted = held["z"][0]
    assert np.abs(held["z"][held["t"] > 5.0] - wanted).max() < 0.03
    assert np.abs(left["z"][-1] - wanted) > 0.5


def test_nothing_estimated_changes_nothing() -> None:
    plain = fly_traced(drone(PLAIN), HOLD)
    told = fly_traced(drone(PLAIN, model_sink_gain=1.7, model_climb_lag=9.0, climb_noise=1.0), HOLD)
    assert plain.tobytes() == told.tobytes()


def test_gains_are_lowered_with_slow_tracking_and_left_alone_with_fast() -> None:
    fast: dict[str, Any] = {"mocap_rate_hz": 100.0}
    slow: dict[str, Any] = {"mocap_rate_hz": 10.0, "mocap_latency": 0.1}
    seen = []
    for tracking in (fast, slow):
        stiff = fly_many(drone(mistrust=0.0, **tracking), PATH)
        soft = fly_many(drone(mistrust=0.3, **tracking), PATH)
        seen.append(stiff.tobytes() == soft.tobytes())
    assert seen == [True, False]
