"""Constants from blocks: intervals that hold the truth, and refusals in words."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from housefly.lab.identification.pattern import Axis
from housefly.lab.identification.result import Identified, Limits, fit_constants
from housefly.lab.identification.samples import Samples
from housefly.pilot.control.model import Constants

LIMITS = Limits(0.21, 0.7, 1.75)
RUNS = 3
Fly = Callable[..., tuple[Samples, ...]]


def hidden(seed: int) -> tuple[Constants, float]:
    """Draw a drone that nobody told us about."""
    random = np.random.default_rng(1000 + seed)
    constants = Constants(
        lag=float(random.uniform(4.0, 11.0)),
        gain=float(random.uniform(0.8, 1.15)),
        drag=float(random.uniform(0.2, 0.9)),
        climb_lag=float(random.uniform(1.0, 4.0)),
        yaw_lag=float(random.uniform(4.0, 20.0)),
    )
    return constants, float(random.uniform(0.03, 0.14))


@pytest.mark.interop
@pytest.mark.slow
def test_each_interval_holds_the_truth_in_most_runs(fly_pattern: Fly) -> None:
    """``benchmarks/identification.py`` counts a hundred, in MuJoCo: 91 to 98 of them."""
    held = dict.fromkeys(
        ("attitude_gain", "attitude_lag", "command_delay", "drag", "climb_lag", "yaw_lag"), 0
    )
    for seed in range(RUNS):
        constants, delay = hidden(seed)
        found = fit_constants(fly_pattern(constants, delay, seed, late=0.0087), LIMITS, seed)
        assert not found.problems, found.problems
        truth = {
            "attitude_gain": constants.gain, "attitude_lag": constants.lag,
            "command_delay": delay, "drag": constants.drag,
            "climb_lag": constants.climb_lag, "yaw_lag": constants.yaw_lag,
        }  # fmt: skip
        for key, value in truth.items():
            held[key] += found.constants[key].low <= value <= found.constants[key].high
    assert min(held.values()) >= 0.6 * RUNS, held


def test_intervals_are_narrow_enough_to_be_useful(fly_pattern: Fly) -> None:
    found = fit_constants(fly_pattern(Constants(7.0, 1.0, 0.58, 1.4, 15.0), 0.07, 5), LIMITS)
    widths = {key: 0.5 * (value.high - value.low) for key, value in found.constants.items()}
    assert widths["attitude_gain"] < 0.05
    assert widths["attitude_lag"] < 0.8
    assert widths["command_delay"] < 0.01
    assert widths["drag"] < 0.1


def test_what_is_left_is_the_noise_of_tracking(fly_pattern: Fly) -> None:
    found = fit_constants(fly_pattern(Constants(7.0, 1.0, 0.58, 1.4, 15.0), 0.07, 6), LIMITS)
    assert found.tilt is not None
    assert found.tilt.place_noise == pytest.approx(0.001, rel=0.15)
    assert found.tilt.angle_noise == pytest.approx(0.001 / 0.15, rel=0.15)


def test_a_model_without_the_delay_would_be_noticed(fly_pattern: Fly) -> None:
    blocks = fly_pattern(Constants(7.0, 1.0, 0.58, 1.4, 15.0), 0.1, 7)
    early = tuple(replace(block, sent_at=block.sent_at + 0.1) for block in blocks)
    right, wrong = (
        fit_constants(flown, LIMITS).constants["command_delay"] for flown in (blocks, early)
    )
    assert right.low <= 0.1 <= right.high
    assert not wrong.low <= 0.1 <= wrong.high


def only(found: Identified) -> str:
    return " / ".join(found.problems)


@pytest.fixture(scope="module")
def flown(fly_pattern: Fly) -> tuple[Samples, ...]:
    return fly_pattern(Constants(7.0, 1.0, 0.58, 1.4, 15.0), 0.07, 3, repeats=5)


def test_too_few_blocks_are_refused(flown: tuple[Samples, ...]) -> None:
    found = fit_constants(flown[:8], LIMITS)
    assert "2 climb steps were flown, 4 are needed: fly with more --repeats" in only(found)
    assert not found.constants


def test_a_gap_of_tracking_is_refused(flown: tuple[Samples, ...]) -> None:
    def holed(block: Samples) -> Samples:
        kept = (block.at < 0.8) | (block.at > 1.3)
        angle = block.angle[kept] if block.angle.size else block.angle
        return replace(block, at=block.at[kept], place=block.place[kept], angle=angle)

    found = fit_constants(tuple(holed(block) for block in flown), LIMITS)
    assert "were not seen well enough (longest gap of tracking 0.5" in only(found)


def test_no_excitation_is_refused(flown: tuple[Samples, ...]) -> None:
    still = tuple(
        replace(block, sent=0.0 * block.sent) if block.block.axis is Axis.ROLL else block
        for block in flown
    )
    assert "roll: nothing was commanded in a step (no excitation)" in only(
        fit_constants(still, LIMITS)
    )


def test_a_saturated_command_is_refused(flown: tuple[Samples, ...]) -> None:
    assert "pitch: the command reached its limit (0.08)" in only(
        fit_constants(flown, replace(LIMITS, tilt=0.08))
    )


def test_a_drone_that_answers_like_no_model_is_refused(flown: tuple[Samples, ...]) -> None:
    stiff = tuple(
        replace(block, place=2.0 * block.place, angle=2.0 * block.angle) for block in flown
    )
    assert "attitude_gain: the fit ends on its bound" in only(fit_constants(stiff, LIMITS))


def test_blurred_tracking_is_refused_with_the_constant_named(fly_pattern: Fly) -> None:
    found = fit_constants(
        fly_pattern(Constants(7.0, 1.0, 0.58, 1.4, 15.0), 0.07, 3, repeats=5, noise=0.03), LIMITS
    )
    assert "is known only to ±" in only(found)
    assert "fly more --repeats" in only(found)
