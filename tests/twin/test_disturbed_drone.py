"""What disturbances do to a hovering drone; scored on the truth."""

from __future__ import annotations

from collections.abc import Callable
from statistics import fmean

import pytest

from housefly.geometry import Vec3, distance
from housefly.messages.stick import Stick
from housefly.twin.contracts import FlightState
from housefly.twin.disturbance import (
    CeilingFan,
    Disturbances,
    Motor,
    Payload,
    PropellerDamage,
    SensorCondition,
    SensorFaults,
    Tether,
)
from housefly.twin.quadrotor.battery import CUT_OFF_VOLTAGE
from housefly.twin.world import SimulatedWorld

MakeWorld = Callable[..., SimulatedWorld]


def mean_height(world: SimulatedWorld, pilot: object, seconds: float = 2.0) -> float:
    heights: list[float] = []
    pilot.wait(seconds, lambda: heights.append(world.truth().pose.position[2]))  # type: ignore[attr-defined]
    return fmean(heights)


def sag(make_world: MakeWorld, hand: type, disturbances: Disturbances) -> float:
    """Return how far a hover at 1.5 m ends lower under disturbances [m]."""
    world = make_world()
    pilot = hand(world)
    pilot.hover(1.5)
    before = mean_height(world, pilot)
    world.disturb(disturbances)
    pilot.wait(6.0)
    return before - mean_height(world, pilot)


def test_a_heavier_drone_hovers_lower_the_heavier_the_lower(
    make_world: MakeWorld, hand: type
) -> None:
    light, heavy = (
        sag(make_world, hand, Disturbances(payload=Payload(mass))) for mass in (0.02, 0.04)
    )
    assert 0.3 < light < 0.9
    assert heavy == pytest.approx(2.0 * light, rel=0.25)


@pytest.mark.parametrize(
    "weak",
    [
        Disturbances(motor_thrust=(0.8, 1.0, 1.0, 1.0)),
        Disturbances(motor_thrust=(0.95, 0.95, 0.95, 0.95)),
        Disturbances(propeller_damage=PropellerDamage(Motor.REAR_RIGHT, 0.8, 1.0)),
    ],
)
def test_less_thrust_sinks_the_drone(make_world: MakeWorld, hand: type, weak: Disturbances) -> None:
    assert sag(make_world, hand, weak) > 0.4


def test_a_low_voltage_sinks_the_drone_only_once_full_thrust_is_too_little(
    make_world: MakeWorld, hand: type
) -> None:
    assert abs(sag(make_world, hand, Disturbances(voltage_sag=0.5))) < 0.1
    assert sag(make_world, hand, Disturbances(voltage_sag=2.6)) > 1.0


def test_a_fan_pushes_down_below_it_and_nowhere_else(make_world: MakeWorld, hand: type) -> None:
    assert sag(make_world, hand, Disturbances(fan=CeilingFan((2.0, 2.5)))) > 0.5
    assert abs(sag(make_world, hand, Disturbances(fan=CeilingFan((6.0, 2.5))))) < 0.1


def fly_on(make_world: MakeWorld, hand: type, disturbances: Disturbances) -> Vec3:
    """Return where four seconds of level flight ahead from the pad at (2.0, 2.5) end [m]."""
    world = make_world()
    pilot = hand(world)
    pilot.hover(1.0)
    world.disturb(disturbances)
    pilot.fly(forward=0.3, seconds=4.0)
    return world.truth().pose.position


def test_a_tether_holds(make_world: MakeWorld, hand: type) -> None:
    anchor = (2.0, 2.5, 0.05)
    free = fly_on(make_world, hand, Disturbances())
    tied = fly_on(make_world, hand, Disturbances(tether=Tether(anchor, 1.5, 100.0)))
    assert distance(free, anchor) > 2.3
    assert distance(tied, anchor) < 1.7


def test_wind_carries_a_drone_that_is_told_to_be_level(make_world: MakeWorld, hand: type) -> None:
    calm = fly_on(make_world, hand, Disturbances())
    blown = fly_on(make_world, hand, Disturbances(wind=(0.0, 1.0, 0.0)))
    assert blown[1] > calm[1] + 1.0


def test_a_bottom_camera_that_sees_nothing_lets_the_hover_drift(
    make_world: MakeWorld, hand: type
) -> None:
    def drift(sensors: SensorFaults) -> float:
        world = make_world()
        pilot = hand(world)
        pilot.hover(1.0)
        world.disturb(Disturbances(wind=(0.3, 0.0, 0.0), sensors=sensors))
        start = world.truth().pose.position
        pilot.wait(5.0)
        return distance(start, world.truth().pose.position)

    assert drift(SensorFaults()) < 0.3
    assert drift(SensorFaults(flow=SensorCondition.OFF)) > 0.5


def test_a_deaf_sonar_says_so_and_a_stuck_one_does_not(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    pilot = hand(world)
    pilot.hover(1.0)
    for condition, says in ((SensorCondition.STUCK, False), (SensorCondition.OFF, True)):
        world.disturb(Disturbances(sensors=SensorFaults(sonar=condition)))
        pilot.wait(0.1)
        heights: set[float] = set()
        pilot.wait(0.5, lambda seen=heights: seen.add(world.onboard().height))
        assert len(heights) == 1
        assert world.onboard().ultrasound_deaf is says
    world.disturb(Disturbances())
    assert not world.onboard().ultrasound_deaf


def test_a_stuck_attitude_turns_the_drone_over(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    pilot = hand(world)
    pilot.hover(1.0)
    world.disturb(Disturbances(sensors=SensorFaults(attitude=SensorCondition.STUCK)))
    world.set_stick(Stick(forward=1.0, hover=False))
    pilot.wait(4.0)
    assert world.truth().pose.position[2] < 0.3


def test_a_battery_cliff_comes_once_and_lands_the_drone(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    pilot = hand(world)
    pilot.hover(1.0)
    world.disturb(Disturbances(charge=0.05))
    pilot.wait(0.02)
    assert world.onboard().battery == pytest.approx(0.05, abs=0.001)
    pilot.wait(2.0)
    used = world.onboard().battery
    world.disturb(Disturbances(charge=0.05, gust=0.1))
    pilot.wait(0.02)
    assert world.onboard().battery <= used < 0.05
    pilot.wait(30.0)
    assert world.onboard().battery < 0.03
    assert world.onboard().flight is FlightState.LANDED


def test_a_stuck_gauge_hides_an_empty_battery_until_the_motors_stop(
    make_world: MakeWorld, hand: type
) -> None:
    world = make_world(twin__battery=0.9)
    pilot = hand(world)
    pilot.hover(1.0)
    said = world.onboard().battery, world.onboard().battery_voltage
    world.disturb(Disturbances(battery_gauge_stuck=True, charge=0.004))
    pilot.wait(1.0)
    assert (world.onboard().battery, world.onboard().battery_voltage) == said
    assert world.truth().pose.position[2] > 0.8
    pilot.wait(6.0)
    assert world.first.battery.voltage <= CUT_OFF_VOLTAGE
    assert (world.onboard().battery, world.onboard().battery_voltage) == said
    assert world.truth().pose.position[2] < 0.1
