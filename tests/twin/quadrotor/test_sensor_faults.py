"""Faults of the drone's own sensors: what the firmware then reads."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from housefly.twin.disturbance import (
    Disturbances,
    Motor,
    PropellerDamage,
    SensorCondition,
    SensorFaults,
)
from housefly.twin.quadrotor.sensor_faults import FaultySensors
from housefly.twin.simulated_body import SensorReading

FIRST = SensorReading(0.1, 0.2, 0.3, (0.0, 0.0, 0.0), 1.0, 0.0, 0.5, -0.5, (0.0, 0.0, 9.8))
LATER = SensorReading(0.4, 0.5, 0.6, (1.0, 1.0, 1.0), 2.0, 0.1, 0.7, -0.7, (0.0, 0.0, 9.9))


@pytest.fixture
def sensors() -> FaultySensors:
    return FaultySensors(seed=1)


def both(sensors: FaultySensors, faults: SensorFaults) -> tuple[SensorReading, SensorReading]:
    disturbances = Disturbances(sensors=faults)
    return sensors.read(FIRST, disturbances, True), sensors.read(LATER, disturbances, True)


def test_what_is_stuck_stays_and_everything_else_goes_on(sensors: FaultySensors) -> None:
    first, later = both(
        sensors,
        SensorFaults(
            attitude=SensorCondition.STUCK,
            flow=SensorCondition.STUCK,
            sonar=SensorCondition.STUCK,
        ),
    )
    assert first == FIRST
    assert later == FIRST._replace(
        rate=LATER.rate, climb=LATER.climb, acceleration=LATER.acceleration
    )


def test_a_sensor_that_works_again_is_not_stuck_at_the_old_value_the_next_time(
    sensors: FaultySensors,
) -> None:
    stuck = Disturbances(sensors=SensorFaults(sonar=SensorCondition.STUCK))
    healthy = replace(stuck, sensors=SensorFaults(flow_gain=0.5))
    assert sensors.read(FIRST, stuck, True).height == 1.0
    assert sensors.read(LATER, stuck, True).height == 1.0
    assert sensors.read(LATER, healthy, True).height == 2.0
    assert sensors.read(LATER, stuck, True).height == 2.0


def test_flow_can_be_off_scaled_and_biased(sensors: FaultySensors) -> None:
    off, _ = both(sensors, SensorFaults(flow=SensorCondition.OFF))
    assert (off.forward, off.left) == (0.0, 0.0)
    scaled, _ = both(sensors, SensorFaults(flow_gain=0.5, flow_bias=(0.1, -0.2)))
    assert (scaled.forward, scaled.left) == pytest.approx((0.35, -0.45))
    assert scaled._replace(forward=0.0, left=0.0) == off


def test_a_damaged_propeller_shakes_only_while_the_motors_turn(sensors: FaultySensors) -> None:
    damaged = Disturbances(propeller_damage=PropellerDamage(Motor.REAR_LEFT, vibration=4.0))
    assert sensors.read(FIRST, damaged, False) == FIRST
    shaken = [sensors.read(FIRST, damaged, True) for _ in range(500)]
    assert np.std([reading.acceleration for reading in shaken], axis=0) == pytest.approx(
        [4.0] * 3, rel=0.15
    )
    assert np.std([reading.rate for reading in shaken], axis=0) == pytest.approx(
        [0.2] * 3, rel=0.15
    )
