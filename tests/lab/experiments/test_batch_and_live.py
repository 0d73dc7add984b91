from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

Fly = Callable[..., Any]

SAME = 1e-11
"""The live pilot takes the heading out of a quaternion, so the last bits differ; beyond that both
call the same functions.
"""
SIGNALS = ("cmd_theta", "cmd_phi", "cmd_vz", "cmd_yaw_rate")
ESTIMATES = ("est_x", "est_y", "est_z", "est_vx", "est_vy", "est_vz", "est_psi", "pose_age")
REFERENCES = ("ref_x", "ref_y", "ref_z", "ref_vx", "ref_vy", "ref_vz", "ref_psi")
STREAMS = {
    "100 Hz": {"mocap_rate_hz": 100.0},
    "10 Hz, late and lossy": {
        "mocap_rate_hz": 10.0,
        "mocap_latency": 0.1,
        "mocap_jitter": 0.01,
        "mocap_dropout": 0.3,
    },
    "30 Hz, noisy, in wind": {
        "mocap_rate_hz": 30.0,
        "mocap_noise": 0.004,
        "wind_x": 0.05,
        "gust": 0.05,
    },
}


@pytest.mark.parametrize(
    ("way", "stream"),
    [
        ("space", "100 Hz"),
        ("space", "30 Hz, noisy, in wind"),
        ("grid", "10 Hz, late and lossy"),
        ("paper", "10 Hz, late and lossy"),
        *(
            pytest.param(*rest, marks=pytest.mark.interop)
            for rest in (
                ("space", "10 Hz, late and lossy"),
                ("grid", "100 Hz"),
                ("grid", "30 Hz, noisy, in wind"),
                ("paper", "100 Hz"),
                ("paper", "30 Hz, noisy, in wind"),
            )
        ),
    ],
)
def test_every_step_of_the_batch_is_the_live_pilots(fly_twice: Fly, way: str, stream: str) -> None:
    # The whole way and the arrival once; how the others are tracked shows on half of the way.
    is_whole = stream == "100 Hz" or way == "paper"
    twins = fly_twice(way, seconds=40.0 if is_whole else 18.0, **STREAMS[stream])
    for column in ("flying", "behavior", "safety"):
        assert np.array_equal(twins.batch[column], twins.live[column]), column
    assert twins.apart(SIGNALS) < SAME
    assert twins.apart(ESTIMATES) < SAME
    assert twins.apart(REFERENCES) < SAME
    assert np.ptp(twins.batch["x"]) > 3.0


@pytest.mark.parametrize("way", ["by velocity", "to places"])
def test_a_drone_of_another_form_is_flown_in_the_batch_as_by_the_live_pilot(
    fly_twice: Fly, way: str
) -> None:
    twins = fly_twice(way, seconds=18.0)
    assert twins.apart((*ESTIMATES, *REFERENCES)) < SAME
    assert np.array_equal(twins.batch["flying"], twins.live["flying"])
    off = np.hypot(*(twins.batch[axis] - twins.batch[f"ref_{axis}"] for axis in "xy"))
    assert np.ptp(twins.batch["x"]) > 3.0 and np.sqrt(np.mean(off**2)) < 0.05


def test_a_way_over_a_screen_is_climbed_in_the_batch_as_in_the_live_pilot(fly_twice: Fly) -> None:
    twins = fly_twice("over a screen", **STREAMS["10 Hz, late and lossy"])
    assert twins.apart((*SIGNALS, *ESTIMATES, *REFERENCES)) < SAME
    assert np.ptp(twins.batch["ref_z"]) > 0.4 and np.ptp(twins.batch["z"]) > 0.4


@pytest.mark.parametrize(
    ("way", "column", "value"),
    [
        ("space", "feed_forward", 0.99),
        ("space", "model_climb_lag", 1.41),
        ("space", "yaw_gain", 1.51),
        ("grid", "alpha", 3.61),
        ("grid", "model_lag", 7.01),
        ("grid", "model_delay", 0.061),
        ("grid", "model_drag", 0.581),
        ("grid", "position_noise", 0.0031),
        ("grid", "height_gain", 1.21),
        ("grid", "speed", 0.501),
        ("grid", "epsilon_yaw", 0.34),
        ("grid", "pose_age_level", 0.05),
        ("paper", "beta", 3.25),
        ("paper", "yaw_gain", 1.51),
        ("paper", "acceleration_noise", 0.41),
        ("paper", "epsilon_position", 0.39),
    ],
)
def test_the_comparison_notices_any_constant_that_differs(
    fly_twice: Fly, way: str, column: str, value: float
) -> None:
    stream = {"mocap_rate_hz": 10.0, "mocap_latency": 0.05}

    def is_noticed(seconds: float) -> bool:
        twins = fly_twice(way, seconds=seconds, **stream, **{column: value})
        states = any(
            not np.array_equal(twins.batch[name], twins.live[name])
            for name in ("flying", "behavior", "safety")
        )
        return states or twins.apart(SIGNALS) > 1e6 * SAME

    # Most constants differ at once, some only after a turn.
    assert is_noticed(3.0) or is_noticed(14.0)
