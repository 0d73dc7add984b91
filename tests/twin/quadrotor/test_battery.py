from hypothesis import given
from hypothesis import strategies as st

from housefly.twin.quadrotor.battery import CUT_OFF_VOLTAGE, Battery


def test_a_full_battery_hovers_for_about_twelve_minutes() -> None:
    battery, seconds = Battery(1.0), 0
    while battery.voltage > CUT_OFF_VOLTAGE:
        battery.drain(1.0, 1.0)
        seconds += 1
    assert 11.5 * 60 < seconds < 12.5 * 60


def test_half_a_charge_shows_the_voltage_of_the_recorded_packet() -> None:
    assert abs(Battery(0.5).voltage - 11.686) < 0.05


@given(st.floats(0, 1), st.floats(0, 1))
def test_more_charge_never_shows_less_voltage(a: float, b: float) -> None:
    low, high = sorted((a, b))
    assert Battery(low).voltage <= Battery(high).voltage


@given(st.floats(0, 1), st.floats(0, 100), st.floats(0, 2))
def test_charge_only_falls_and_stays_between_nothing_and_all(
    charge: float, seconds: float, load: float
) -> None:
    battery = Battery(charge)
    battery.drain(seconds, load)
    assert 0.0 <= battery.charge <= charge
