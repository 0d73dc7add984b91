from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from housefly.geometry import GRAVITY, Vec3
from housefly.messages import DroneStatus, Telemetry
from housefly.pilot.estimation.consistency import MEMORY, SETTLING_TIME, CarryDetector

RESTING = Telemetry(0.0, DroneStatus.LANDED, 0.9, 0.003, -0.002, 1.2)


def rested(seconds: float, noisy: bool = True) -> CarryDetector:
    """Return the detector after a drone lay still for this long [s]."""
    random, detector = np.random.default_rng(3), CarryDetector()
    for tick in range(round(seconds / 0.01)):
        x, y, z = random.normal(0.0, 0.1 * noisy, 3).tolist()
        phi, theta = random.normal(0.0, 0.0005 * noisy, 2).tolist()
        told = replace(
            RESTING,
            received_at=0.01 * tick,
            phi=RESTING.phi + phi,
            theta=RESTING.theta + theta,
            acceleration=(x, y, GRAVITY + z),
        )
        detector = detector.updated(told, airborne=False)
    return detector


def test_an_hour_of_noise_is_no_motion() -> None:
    assert not rested(600.0).stirred_since(0.0)


@pytest.mark.parametrize(
    ("turned", "pushed"),
    [((0.05, 0.0, 0.0), 0.0), ((0.0, 0.0, 0.1), 0.0), ((0.0, 0.0, 0.0), 2.0)],
)
def test_a_drone_that_is_lifted_tilted_or_turned_is_carried(turned: Vec3, pushed: float) -> None:
    detector = rested(5.0)
    phi, theta, psi = turned
    moved = replace(
        RESTING,
        received_at=5.0,
        phi=RESTING.phi + phi,
        theta=RESTING.theta + theta,
        psi=RESTING.psi + psi,
        acceleration=(0.0, 0.0, GRAVITY + pushed),
    )
    detector = detector.updated(moved, airborne=False)
    assert detector.stirred_since(4.0)
    assert detector.stirred_since(5.0 + MEMORY - 0.01)
    assert not detector.stirred_since(5.0 + MEMORY + 0.01)


def test_the_bump_of_a_touchdown_is_no_carrying() -> None:
    detector = rested(5.0)
    bump = replace(RESTING, acceleration=(0.0, 0.0, 30.0))
    detector = detector.updated(replace(bump, received_at=5.0), airborne=True)
    detector = detector.updated(
        replace(bump, received_at=5.0 + 0.5 * SETTLING_TIME), airborne=False
    )
    assert not detector.stirred_since(4.0)


def test_a_drone_that_tells_nothing_may_have_been_carried() -> None:
    silent = Telemetry(1.0, DroneStatus.LANDED, 0.9)
    assert CarryDetector().updated(silent, airborne=False).stirred_since(0.0)
