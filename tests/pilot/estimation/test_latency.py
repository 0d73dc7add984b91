from __future__ import annotations

from collections.abc import Callable
from math import cos, isfinite, isnan, nan, sin

import numpy as np
import pytest
from ardrone_flow import FLOW

from housefly.pilot.estimation.latency import (
    LAG_STEP,
    NO_LATENCY,
    lag_bank,
    latency_advanced,
)
from housefly.pilot.estimation.onboard_odometry import (
    MOTION_RING_SIZE,
    ONBOARD_MOTION,
    OnboardReport,
    odometry_advanced,
    odometry_begun,
    odometry_headed,
)

Place = Callable[[float], tuple[float, float, float]]
"""x [m], its velocity [m/s], and height [m] at a time [s]."""


def swaying(at: float) -> tuple[float, float, float]:
    return 0.3 * sin(at), 0.3 * cos(at), 1.0


def climbing(at: float) -> tuple[float, float, float]:
    return 0.0, 1e-6, min(0.3 * at, 1.0)


def swaying_over_furniture(at: float) -> tuple[float, float, float]:
    return 0.3 * sin(at), 0.3 * cos(at), nan


def hovering(at: float) -> tuple[float, float, float]:
    return 0.0, 1e-6, 1.0


def found(place: Place, late: float, seconds: float) -> float:
    """Return the latency found when poses come late, stamped as if they did not [s]."""
    motion, bank, random = (
        np.zeros(MOTION_RING_SIZE, ONBOARD_MOTION),
        lag_bank(),
        np.random.default_rng(1),
    )
    odometry, state = odometry_begun(FLOW), NO_LATENCY
    for tick in range(1, round(seconds / 0.01)):
        at = 0.01 * tick
        _, v, z = place(at - FLOW.delay)
        noise = random.normal(0.0, 1.0, 5).tolist()
        told = z + 0.01 * noise[2] if isfinite(z) else 0.8 * (at % 2.0 > 1.0)
        report = OnboardReport(
            at, 0.0, 0.0, 0.0, v + 0.02 * noise[0], 0.02 * noise[1], told, 0.0, True, nan
        )
        odometry = odometry_advanced(odometry, motion, report)
        x, _, z = place(at - late)
        odometry = odometry_headed(odometry, motion, at, 0.0)
        x, z = x + 0.001 * noise[3], z + 0.001 * noise[4]
        if tick > 2:
            state = latency_advanced(state, bank, odometry, motion, at, x, 0.0, z, 0.0)
    return state.error


@pytest.mark.parametrize("place", [swaying, climbing, swaying_over_furniture])
@pytest.mark.parametrize("late", [0.3, 0.5])
def test_poses_that_are_older_than_they_say_are_found_within_five_seconds(
    place: Place, late: float
) -> None:
    assert found(place, late, 5.0) == pytest.approx(late, abs=LAG_STEP)


@pytest.mark.parametrize("place", [swaying, climbing, swaying_over_furniture])
def test_poses_as_old_as_they_say_show_no_latency(place: Place) -> None:
    assert found(place, 0.0, 5.0) == 0.0


def test_a_hovering_drone_shows_no_latency_at_all() -> None:
    assert isnan(found(hovering, 0.3, 5.0))
