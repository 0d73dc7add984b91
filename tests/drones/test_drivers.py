"""Every model has a driver and an airframe, and a driver is found by its model's name alone."""

from __future__ import annotations

import pytest

from housefly.clock import RealClock
from housefly.config.airframe import airframe_named, airframe_names
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones import DRIVERS, driver_of


def test_every_driver_has_an_airframe_and_every_airframe_a_driver() -> None:
    assert set(DRIVERS) == set(airframe_names())


@pytest.mark.parametrize("kind", DRIVERS)
def test_a_driver_is_found_by_the_name_of_its_model(kind: str) -> None:
    driver = driver_of(DroneConfig(kind=kind), LimitsConfig(), RealClock())
    assert driver.capabilities == airframe_named(kind).capabilities
    assert driver.telemetry is None and not driver.connected
