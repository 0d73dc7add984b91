from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.drone import DroneConfig
from housefly.messages.stick import Stick
from housefly.twin.contracts import FlightState, OnboardLimits
from housefly.twin.quadrotor.firmware import TILT_CUTOFF, Firmware
from housefly.twin.simulated_body import CONTROL_PERIOD, SensorReading

SILENCE_MAX = OnboardLimits().silence

LEVEL = SensorReading(0.0, 0.0, 0.0, (0.0, 0.0, 0.0), 1.0, 0.0, 0.0, 0.0, (0.0, 0.0, 9.8))
ON_GROUND = LEVEL._replace(height=0.02)
TILTED = LEVEL._replace(phi=TILT_CUTOFF + 0.1)
UPSIDE_DOWN = LEVEL._replace(phi=3.1)
FULL, EMPTY = 12.0, 8.9


def run(
    firmware: Firmware,
    seconds: float,
    measured: SensorReading = LEVEL,
    voltage: float = FULL,
    silence: float = 0.0,
) -> FlightState:
    for _ in range(round(seconds / CONTROL_PERIOD)):
        firmware.step(measured, voltage, silence)
    return firmware.flight


@pytest.fixture
def grounded() -> Firmware:
    return Firmware(DroneConfig())


@pytest.fixture
def airborne(grounded: Firmware) -> Firmware:
    grounded.request_take_off()
    assert run(grounded, 5.0) is FlightState.HOVERING
    return grounded


def test_motors_rest_until_take_off_and_after_landing(grounded: Firmware) -> None:
    assert grounded.step(LEVEL, FULL, 0.0).thrust == 0.0
    grounded.request_take_off()
    run(grounded, 5.0)
    assert grounded.step(LEVEL, FULL, 0.0).thrust > 0.0
    grounded.request_land()
    assert run(grounded, 3.0, ON_GROUND) is FlightState.LANDED
    assert grounded.step(LEVEL, FULL, 0.0).thrust == 0.0


def test_hover_bit_tells_flying_from_hovering(airborne: Firmware) -> None:
    airborne.set_stick(Stick(forward=0.5, hover=False))
    assert run(airborne, 0.1) is FlightState.FLYING
    airborne.set_stick(Stick(hover=True))
    assert run(airborne, 0.1) is FlightState.HOVERING


def test_the_emergency_command_is_a_toggle(airborne: Firmware) -> None:
    airborne.toggle_emergency()
    assert run(airborne, 0.1) is FlightState.EMERGENCY
    assert airborne.step(LEVEL, FULL, 0.0).thrust == 0.0
    airborne.toggle_emergency()
    assert run(airborne, 0.1) is FlightState.LANDED


def test_the_emergency_command_also_counts_on_the_ground(grounded: Firmware) -> None:
    grounded.toggle_emergency()
    assert grounded.flight is FlightState.EMERGENCY
    grounded.request_take_off()
    assert grounded.flight is FlightState.EMERGENCY


@pytest.mark.parametrize("attitude", [TILTED, UPSIDE_DOWN])
def test_leaning_too_far_in_the_air_cuts_the_motors(
    airborne: Firmware, attitude: SensorReading
) -> None:
    assert run(airborne, 0.1, attitude) is FlightState.EMERGENCY
    assert airborne.tilted


def test_a_drone_on_its_back_neither_leaves_the_emergency_nor_takes_off(grounded: Firmware) -> None:
    run(grounded, 0.1, UPSIDE_DOWN)
    grounded.request_take_off()
    assert grounded.flight is FlightState.LANDED
    grounded.toggle_emergency()
    grounded.toggle_emergency()
    assert grounded.flight is FlightState.EMERGENCY


def test_two_seconds_without_a_client_land_the_drone(airborne: Firmware) -> None:
    assert run(airborne, 1.0, silence=SILENCE_MAX - 0.1) is FlightState.HOVERING
    assert run(airborne, 0.1, silence=SILENCE_MAX + 0.1) is FlightState.LANDING
    assert airborne.com_lost


def test_a_shorter_silence_lands_it_where_that_is_set(airborne: Firmware) -> None:
    airborne.limits = OnboardLimits(silence=1.0)
    assert run(airborne, 0.5, silence=0.9) is FlightState.HOVERING
    assert run(airborne, 0.1, silence=1.1) is FlightState.LANDING


def test_after_a_landing_nobody_asked_for_a_repeated_take_off_bit_does_not_count(
    airborne: Firmware,
) -> None:
    assert run(airborne, 3.0, ON_GROUND, silence=SILENCE_MAX + 0.1) is FlightState.LANDED
    airborne.request_take_off()
    assert airborne.flight is FlightState.LANDED
    airborne.request_land()
    airborne.request_take_off()
    assert airborne.flight is FlightState.TAKING_OFF


def test_a_nearly_empty_battery_lands_and_an_empty_one_cuts(airborne: Firmware) -> None:
    assert run(airborne, 0.1, voltage=9.2) is FlightState.LANDING
    assert run(airborne, 0.1, voltage=EMPTY) is FlightState.EMERGENCY
    airborne.toggle_emergency()
    assert airborne.flight is FlightState.EMERGENCY


def test_a_low_battery_refuses_to_take_off(grounded: Firmware) -> None:
    run(grounded, 0.1, voltage=9.5)
    grounded.request_take_off()
    assert grounded.flight is FlightState.LANDED


CALLS: tuple[Callable[[Firmware], object], ...] = (
    Firmware.request_take_off,
    Firmware.request_land,
    Firmware.toggle_emergency,
    lambda firmware: firmware.set_stick(Stick(1.0, -1.0, 1.0, -1.0, hover=False)),
    lambda firmware: run(firmware, 0.5),
    lambda firmware: run(firmware, 5.0),
    lambda firmware: run(firmware, 0.1, TILTED),
    lambda firmware: run(firmware, 0.1, silence=3.0),
    lambda firmware: run(firmware, 0.1, voltage=9.2),
)


@given(st.lists(st.sampled_from(CALLS), max_size=12))
def test_no_thrust_ever_in_landed_or_emergency(calls: list[Callable[[Firmware], object]]) -> None:
    firmware = Firmware(DroneConfig())
    for call in calls:
        call(firmware)
        before = firmware.flight
        wrench = firmware.step(LEVEL, FULL, 0.0)
        assert wrench.thrust == 0.0 or before not in {FlightState.LANDED, FlightState.EMERGENCY}


@given(st.lists(st.sampled_from(CALLS), max_size=12))
def test_only_a_take_off_request_leaves_the_ground(
    calls: list[Callable[[Firmware], object]],
) -> None:
    firmware = Firmware(DroneConfig())
    for call in calls:
        before = firmware.flight
        call(firmware)
        if before is FlightState.LANDED and firmware.flight not in {
            FlightState.LANDED,
            FlightState.EMERGENCY,
        }:
            assert call is Firmware.request_take_off
