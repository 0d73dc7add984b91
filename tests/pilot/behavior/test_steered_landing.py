"""A landing of the gate moves to clear floor slowly, and sinks there."""

from __future__ import annotations

from math import inf

from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import distance
from housefly.pilot.behavior.braking import BESIDE_MAX, BESIDE_SPEED
from housefly.pilot.behavior.steered_landing import SETTLING_TIME, SteeredLanding

COORDINATES = st.floats(-BESIDE_MAX / 2, BESIDE_MAX / 2)
PLACES = st.tuples(COORDINATES, COORDINATES)
TIMES = st.floats(0.0, 10.0)


@given(PLACES, PLACES, TIMES, st.floats(0.0, 1.0))
def test_the_setpoint_never_jumps_and_ends_on_the_spot(
    begun: tuple[float, float], spot: tuple[float, float], after: float, dt: float
) -> None:
    landing = SteeredLanding(begun, 1.2, 5.0, spot)
    before, later = landing.setpoint(5.0 + after), landing.setpoint(5.0 + after + dt)
    assert distance(before, later) <= BESIDE_SPEED * dt + 1e-9
    assert distance(landing.setpoint(5.0 + 10.0), spot) < 1e-9


@given(PLACES, TIMES)
def test_over_clear_floor_it_sinks_at_once(place: tuple[float, float], after: float) -> None:
    landing = SteeredLanding(place, 1.2, 5.0, place)
    assert landing.height_setpoint(5.0 + after, place, 1.2, 0.2) < 1.2


def test_it_keeps_its_height_until_it_is_beside_but_not_for_ever() -> None:
    landing = SteeredLanding((0.0, 0.0), 1.2, 5.0, (0.8, 0.0))
    arrival = 5.0 + 0.8 / BESIDE_SPEED
    assert landing.height_setpoint(arrival - 0.1, (0.7, 0.0), 1.1, 0.2) == 1.2
    assert landing.height_setpoint(arrival + 0.1, (0.5, 0.0), 1.1, 0.2) == 1.2
    assert landing.height_setpoint(arrival + 0.1, (0.75, 0.0), 1.1, 0.2) < 1.1
    assert landing.height_setpoint(arrival + SETTLING_TIME, (0.0, 0.0), 1.1, 0.2) < 1.1
    assert landing.height_setpoint(inf, (0.0, 0.0), 0.3, 0.2) == 0.2


def test_moved_aside_it_keeps_the_height_at_which_it_began_until_it_is_there() -> None:
    low = SteeredLanding((0.0, 0.0), 1.2, 5.0, (0.0, 0.0))
    moved = low.moved((0.1, 0.0), 7.0, (1.1, 0.0))
    assert low.sinks(7.0, (0.1, 0.0)) and not moved.sinks(7.0, (0.1, 0.0))
    assert moved.height_setpoint(7.5, (0.2, 0.0), 0.8, 0.2) == 1.2
    assert moved.setpoint(7.0) == (0.1, 0.0) and moved.moves == 1
    assert moved.sinks(7.0 + 1.0 / BESIDE_SPEED, (1.1, 0.0))
