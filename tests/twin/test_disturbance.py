"""Disturbances: refused out of range, nothing at all when neutral."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, nan

import pytest

from housefly.errors import ConfigError
from housefly.messages.stick import Stick
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
from housefly.twin.world import SimulatedWorld

MakeWorld = Callable[..., SimulatedWorld]


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Disturbances(wind=(0.0, nan, 0.0)), "disturbances.wind: must be -20 to 20 m/s"),
        (lambda: Disturbances(gust=-0.1), "gust: must be 0 to 10 m/s, not -0.1"),
        (lambda: Disturbances(gust_time=0.0), "gust_time: must be 0.05 to 60 s"),
        (lambda: Disturbances(motor_thrust=(1.0, 1.1, 1.0, 1.0)), "motor_thrust: must be 0 to 1"),
        (lambda: Disturbances(motor_thrust=(1.0,)), "four numbers"),  # type: ignore[arg-type]
        (lambda: Disturbances(voltage_sag=inf), "voltage_sag: must be 0 to 5 V"),
        (lambda: Disturbances(charge=1.5), "charge: must be 0 to 1 of a full battery"),
        (lambda: CeilingFan((0.0, 0.0), radius=0.0), "fan.radius: must be 0.05 to 10 m"),
        (lambda: CeilingFan((0.0, 0.0), downwash=-1.0), "fan.downwash: must be 0 to 10 m/s"),
        (lambda: Payload(-0.01), "payload.mass: must be 0 to 0.5 kg"),
        (lambda: Payload(0.1, (0.0, 0.0, 2.0)), "payload.offset: must be -0.5 to 0.5 m"),
        (lambda: Tether((0.0, 0.0, 0.0), -1.0), "tether.length: must be 0 to 100 m"),
        (lambda: Tether((0.0, 0.0, 0.0), 1.0, 1e6), "tether.stiffness: must be 0.1 to 1000 N/m"),
        (lambda: PropellerDamage(Motor.REAR_LEFT, 2.0), "propeller_damage.thrust: must be 0 to 1"),
        (lambda: SensorFaults(flow_gain=nan), "sensors.flow_gain: must be 0 to 10"),
        (lambda: SensorFaults(attitude=SensorCondition.OFF), "must be ok or stuck"),
    ],
)
def test_a_value_out_of_range_is_refused_with_its_range_and_unit(
    make: Callable[[], object], words: str
) -> None:
    with pytest.raises(ConfigError, match=words):
        make()


def test_damage_of_a_propeller_weakens_its_motor_further() -> None:
    both = Disturbances(
        motor_thrust=(1.0, 0.5, 1.0, 0.9),
        propeller_damage=PropellerDamage(Motor.FRONT_RIGHT, thrust=0.5),
    )
    assert both.motor_gains == (1.0, 0.25, 1.0, 0.9)


def course(world: SimulatedWorld, each: Callable[[int], None]) -> list[object]:
    """Return everything that a flight of nine seconds shows, with a turn and a climb in it."""
    seen: list[object] = []
    world.flat_trim()
    world.request_take_off()
    for step in range(900):
        world.keep_alive()
        each(step)
        if step == 600:
            world.set_stick(Stick(forward=0.4, turn=0.2, up=0.2, hover=False))
        world.advance(0.01)
        seen.extend((*world.mocap_frames(), world.truth(), world.onboard()))
    return seen


def test_neutral_disturbances_change_no_bit_of_a_flight(make_world: MakeWorld) -> None:
    untouched, neutral = make_world(twin__seed=4), make_world(twin__seed=4)
    assert course(untouched, lambda step: None) == course(
        neutral, lambda step: neutral.disturb(Disturbances(charge=None))
    )


def test_a_disturbed_flight_is_the_same_bit_for_bit_whoever_looks(make_world: MakeWorld) -> None:
    rough = Disturbances(
        wind=(0.5, 0.0, 0.0),
        gust=0.5,
        payload=Payload(0.01, (0.02, 0.0, 0.0)),
        propeller_damage=PropellerDamage(Motor.REAR_LEFT, 0.98, 1.0),
        sensors=SensorFaults(flow_gain=0.8, gyro_noise=0.01),
    )

    def fly(look: bool) -> list[object]:
        world = make_world(twin__seed=4)
        world.disturb(rough)

        def look_round(step: int) -> None:
            if look:
                world.clearance()

        return course(world, look_round)

    assert fly(look=False) == fly(look=True)


def test_a_disturbance_that_ends_leaves_the_drone_as_it_was_built(
    make_world: MakeWorld, hand: type
) -> None:
    world = make_world()
    model = world._physics.model
    built = model.body_mass.copy(), model.body_inertia.copy()
    world.disturb(Disturbances(payload=Payload(0.1, (0.1, 0.0, 0.0))))
    assert model.body_mass[world._physics.drones[0].number] == pytest.approx(0.536)
    world.disturb(Disturbances())
    assert (model.body_mass == built[0]).all()
    assert (model.body_inertia == built[1]).all()
    assert world.disturbances == Disturbances()
