from __future__ import annotations

import numpy as np
import pytest

from housefly.config.site import Site
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_recorded
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.pilot.control.model import DroneState, between

HOLD = FlightPlan(Task.HOLD, ((1.0, 2.0),), 30.0)


def sightings(**columns: float) -> np.ndarray:
    plain = {
        "mocap_noise": 0.0,
        "mocap_jitter": 0.0,
        "mocap_latency": 0.03,
        "mocap_rate_hz": 40.0,
        "pose_age_land": 99.0,
    }
    return fly_recorded(cases(Site(), 1, seed=3, **{**plain, **columns}), HOLD)[1]


def test_frames_come_at_their_rate_and_arrive_one_latency_later_at_the_next_tick() -> None:
    seen = sightings()
    assert np.diff(seen["captured_at"]) == pytest.approx(np.full(len(seen) - 1, 0.025), abs=1e-9)
    assert seen["received_at"] - seen["captured_at"] == pytest.approx(
        np.full(len(seen), 0.03), abs=1e-9
    )
    waited = 0.01 * seen["tick"] - seen["received_at"]
    assert (waited >= -1e-9).all() and (waited < 0.01 + 1e-9).all()


def test_noise_has_the_size_asked_and_none_repeats() -> None:
    seen = sightings(mocap_noise=0.01, gain=0.2, alpha=0.1, beta=0.05, mocap_rate_hz=100.0)
    assert np.std(seen["z"]) == pytest.approx(0.01, rel=0.15)
    assert len(np.unique(seen["x"])) == len(seen)


def test_the_share_of_lost_frames_is_as_asked() -> None:
    assert len(sightings(mocap_dropout=0.3)) == pytest.approx(0.7 * 1200, rel=0.06)
    assert len(sightings(mocap_dropout=1.0)) == 0


def test_jitter_is_exponential_and_a_late_frame_holds_up_those_behind_it() -> None:
    seen = sightings(mocap_jitter=0.05)
    late = seen["received_at"] - seen["captured_at"] - 0.03
    assert (np.diff(seen["received_at"]) >= 0.0).all() and (
        np.diff(seen["captured_at"]) > 0.0
    ).all()
    assert 0.05 < late.mean() < 0.12


def test_a_frame_between_two_steps_sees_the_drone_where_it_is() -> None:
    before = DroneState(1.0, 2.0, 1.1, 3.1, 0.5, -0.2, 0.1, 0.4)
    dt = 0.01
    after = DroneState(1.00501, 1.998, 1.101, -3.1792, 0.502, -0.2, 0.1, 0.4)
    for part in (0.0, 0.004, dt):
        x, y, _, psi = between(before, after, dt, part)
        slope = (after.vx - before.vx) / dt
        assert x == pytest.approx(1.0 + 0.5 * part + 0.5 * slope * part**2, abs=1e-12)
        assert y == pytest.approx(2.0 - 0.2 * part, abs=1e-12)
        assert -np.pi < psi <= np.pi
    assert between(before, after, dt, dt)[0] == pytest.approx(after.x, abs=1e-9)
