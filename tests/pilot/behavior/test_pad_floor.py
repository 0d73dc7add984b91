"""What lies on the pad: the sonar above it now, against that of the take-off."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from housefly.messages.sensing import DroneStatus, Estimate, Telemetry
from housefly.pilot.behavior.mission import VehicleStatus
from housefly.pilot.behavior.pad_floor import FLAT_HEIGHT_MIN, PadFloor

STOOD = 0.05
"""Tracked height of a drone that stands [m]."""
Fly = Callable[..., float]


@pytest.fixture
def fly() -> Fly:
    """Return what flies the drone for some time, and returns how high what lies below seems [m]."""
    floor, rng, clock = PadFloor(), np.random.default_rng(1), [0.0]

    def flown(
        seconds: float,
        status: DroneStatus = DroneStatus.FLYING,
        place: tuple[float, float] = (0.0, 0.0),
        climb: float = 0.0,
        z: float = 1.1,
        lies: float = 0.0,
        deaf: bool = False,
    ) -> float:
        for _ in range(round(seconds / 0.05)):
            clock[0] += 0.05
            z = z + 0.05 * climb
            told = max(0.0, z - 0.06 * climb - STOOD - lies + float(rng.normal(0.0, 0.01)))
            estimate = Estimate(clock[0], (*place, z), (0.0, 0.0, climb), 0.0, 0.0, 0.0)
            report = Telemetry(clock[0], status, 0.9, height=0.0 if deaf else told)
            vehicle = VehicleStatus(
                clock[0], status, 0.9, 0.0, estimate, False, telemetry=report,
                standing_height=STOOD,
            )  # fmt: skip
            floor.step(vehicle)
        return floor.height

    return flown


def take_off(fly: Fly, **options: bool) -> None:
    fly(0.2, DroneStatus.LANDED, z=STOOD)
    fly(2.4, DroneStatus.TAKING_OFF, z=STOOD, climb=0.4, **options)
    fly(2.0, place=(2.0, 0.0))


@pytest.mark.parametrize("lies", [0.08, 0.12, 0.2])
def test_what_was_put_on_the_pad_in_flight_is_found_as_high_as_it_is(fly: Fly, lies: float) -> None:
    take_off(fly)
    assert fly(1.5, lies=lies) == pytest.approx(lies, abs=0.02)
    assert fly(1.0, z=1.1, climb=-0.4, lies=lies) == pytest.approx(lies, abs=0.03)


def test_a_bare_pad_is_bare_at_rest_sinking_and_climbing(fly: Fly) -> None:
    take_off(fly)
    for climb in (0.0, -0.4, 0.4):
        assert fly(1.5, climb=climb, lies=0.25 * FLAT_HEIGHT_MIN) == 0.0


def test_it_is_found_nowhere_but_above_the_pad_and_gone_when_it_is_gone(fly: Fly) -> None:
    take_off(fly)
    assert fly(1.5, place=(1.0, 0.0), lies=0.12) == 0.0
    assert fly(1.5, lies=0.12) > 0.0
    assert fly(1.5) == 0.0


def test_a_sonar_that_told_nothing_of_the_floor_at_the_take_off_shows_nothing(fly: Fly) -> None:
    take_off(fly, deaf=True)
    assert fly(1.5, lies=0.12) == 0.0


def test_who_comes_below_a_take_off_is_no_part_of_the_pad(fly: Fly) -> None:
    fly(0.2, DroneStatus.LANDED, z=STOOD)
    fly(1.8, DroneStatus.TAKING_OFF, z=STOOD, climb=0.4)
    assert fly(1.0, DroneStatus.TAKING_OFF, z=0.77, climb=0.4, lies=0.34) > 0.2
    assert fly(1.0, lies=0.34) == pytest.approx(0.34, abs=0.03)
