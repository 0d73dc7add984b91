"""What an identification is held against, and what it says when an interval misses it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.drone import DroneConfig
from housefly.config.profile import CONSTANTS, Interval
from housefly.config.site import Site, changed
from housefly.config.twin import RATE_POLE
from housefly.lab.identification.pattern import Axis
from housefly.lab.identification.rates import TIME_CONSTANT, fit_turn
from housefly.lab.identification.response import SWITCH_SPREAD
from housefly.lab.identification.result import Identified
from housefly.lab.identification.samples import Samples
from housefly.lab.identification.truth import missed_constants, simulated_truth
from housefly.pilot.control.model import Constants
from housefly.twin.quadrotor.body import INERTIA
from housefly.twin.quadrotor.inner_loops import InnerLoops, LoopReferences
from housefly.twin.simulated_body import SensorReading


def found(truth: dict[str, float], key: str = "", by: float = 0.0) -> Identified:
    """Return intervals of a tenth about the truth, one of them moved by a share of its value."""
    constants = {
        name: Interval(value, 0.95 * value, 1.05 * value)
        for name, value in ((n, v * (1.0 + by * (n == key))) for n, v in truth.items())
    }
    return Identified(constants, (), None, None, None, (), truth)


def test_the_truth_is_that_of_the_whole_way() -> None:
    truth, drone = simulated_truth(Site()), Site().drone
    assert truth["command_delay"] == pytest.approx(0.06 + 0.01 + 0.005)
    assert truth["yaw_lag"] == pytest.approx(30.0)
    same = set(CONSTANTS) - {"command_delay", "yaw_lag"}
    assert all(truth[key] == getattr(drone, key) for key in same)


@given(st.sampled_from(sorted(CONSTANTS)), st.sampled_from([-0.2, 0.2]))
def test_a_constant_outside_its_interval_is_named_with_what_to_do(key: str, by: float) -> None:
    truth = simulated_truth(Site())
    outside = found(truth, key, by)
    assert outside.missed == (key,)
    assert f"{key} ({truth[key]:.3g})" in outside.advice
    assert "fly again with another seed" in outside.advice
    assert "may be written" not in outside.advice


def test_only_what_is_known_counts_as_missed() -> None:
    assert "each interval holds" in found(simulated_truth(Site())).advice
    far = {"drag": Interval(9.0, 8.9, 9.1)}
    assert missed_constants(far, {}) == ()
    assert Identified(far, (), None, None, None, ()).advice == "the profile may be written"
    refused = Identified(far, ("too few",), None, None, None, (), {"drag": 0.5})
    assert refused.advice == "no profile: too few"


@pytest.mark.parametrize("pole", [5.0, 25.0, 45.0])
def test_the_yaw_pole_of_a_profile_is_found_again(pole: float) -> None:
    site = changed(Site(), drone__yaw_lag=pole)
    described = site.drone.model_copy(update={"profile": "drone.toml"})
    as_flown = site.model_copy(update={"drone": described})
    assert simulated_truth(as_flown)["yaw_lag"] == pytest.approx(pole)
    assert 1.0 / turning_pole(described) - 1.0 / RATE_POLE == pytest.approx(1.0 / pole)
    assert turning_pole(site.drone) == pytest.approx(pole)


def turning_pole(drone: DroneConfig) -> float:
    """Return the pole of the yaw rate from the torque on a level drone at a unit of error [1/s]."""
    nought = (0.0, 0.0, 0.0)
    level = SensorReading(0.0, 0.0, 0.0, nought, 1.0, 0.0, 0.0, 0.0, nought)
    return InnerLoops(drone).wrench(LoopReferences(0.0, 0.0, 0.0, 1.0), level).yaw / INERTIA[2]


def test_a_drone_that_turns_without_the_rate_loop_is_found_with_the_pole_of_the_truth(
    fly_pattern: Callable[..., tuple[Samples, ...]],
) -> None:
    truth, held, found = simulated_truth(Site()), 0, list[float]()
    delay, shipped = truth["command_delay"], Site().drone.yaw_lag
    for seed in range(8):
        flown = fly_pattern(
            Constants(yaw_lag=shipped), delay - 1.0 / RATE_POLE, seed, late=SWITCH_SPREAD
        )
        turns = tuple(block for block in flown if block.block.axis is Axis.TURN)
        turn = fit_turn(turns, delay, 0.004, seed)
        time = float(turn.fit.constants[TIME_CONSTANT])
        found.append(time)
        held += abs(time - 1.0 / truth["yaw_lag"]) <= turn.half_time
    assert held >= 6, found
    assert abs(np.mean(found) - 1.0 / truth["yaw_lag"]) < abs(np.mean(found) - 1.0 / shipped)
