"""The simulated drone in its room: states, watchdogs, contact, and nothing that blows up."""

from __future__ import annotations

from collections.abc import Callable
from math import isfinite

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.geometry import distance, quaternion_from_euler
from housefly.messages import Pose
from housefly.messages.stick import Stick
from housefly.room.model import Room, Shape, Solid
from housefly.twin.contracts import FlightState, TwinWorld
from housefly.twin.world import SimulatedWorld

MakeWorld = Callable[..., SimulatedWorld]


def test_the_world_offers_what_the_wire_servers_ask(make_world: MakeWorld) -> None:
    world: TwinWorld = make_world()
    world.advance(0.0173)
    assert world.now == pytest.approx(0.0173)
    assert world.truth().at == pytest.approx(0.015)


def test_take_off_reaches_a_metre_in_four_to_five_seconds(
    make_world: MakeWorld, hand: type
) -> None:
    world = make_world()
    world.request_take_off()
    reached: list[float] = []
    hand(world).wait(
        9.0,
        lambda: (
            reached.append(world.now) if world.onboard().flight is FlightState.HOVERING else None
        ),
    )
    assert 3.5 < reached[0] < 5.0
    assert world.truth().pose.position[2] == pytest.approx(1.05, abs=0.1)
    assert distance(world.truth().pose.position[:2], (2.0, 2.5)) < 0.15


def test_landing_touches_softly_and_stops_the_motors(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    hand(world).hover()
    world.request_land()
    sink: list[float] = []
    hand(world).wait(6.0, lambda: sink.append(world.truth().velocity[2]))
    assert world.onboard().flight is FlightState.LANDED
    assert world.onboard().motors == (0.0, 0.0, 0.0, 0.0)
    assert world.truth().pose.position[2] == pytest.approx(0.05, abs=0.005)
    assert min(sink) > -0.6


def test_an_emergency_in_the_air_falls_and_can_be_left_on_the_ground(
    make_world: MakeWorld, hand: type
) -> None:
    world = make_world()
    hand(world).hover()
    world.toggle_emergency()
    hand(world).wait(0.5)
    assert world.onboard().flight is FlightState.EMERGENCY
    assert world.truth().velocity[2] < -2.0
    hand(world).wait(2.0)
    assert world.truth().pose.position[2] < 0.2
    world.toggle_emergency()
    hand(world).wait(0.2)
    assert world.onboard().flight is FlightState.LANDED


def test_landing_above_a_table_ends_on_the_table(
    make_world: MakeWorld, make_room: Callable[..., Room], hand: type
) -> None:
    table = Solid("table", "table", Shape.BOX, (2.0, 2.5, 0.35), (1.5, 1.5, 0.7))
    world = make_world(make_room((table,)))
    world.put_drone((2.0, 2.5, 0.75))
    hand(world).hover(1.5)
    world.request_land()
    hand(world).wait(6.0)
    assert world.onboard().flight is FlightState.LANDED
    assert world.truth().pose.position[2] == pytest.approx(0.75, abs=0.01)


def test_a_silent_client_raises_the_flag_then_lands_the_drone(
    make_world: MakeWorld, hand: type
) -> None:
    world = make_world()
    hand(world).hover()
    world.keep_alive()
    world.advance(0.04)
    assert not world.onboard().com_watchdog
    world.advance(0.04)
    assert world.onboard().com_watchdog
    assert not world.onboard().com_lost
    world.advance(2.0)
    assert world.onboard().com_lost
    assert world.onboard().flight is FlightState.LANDING
    world.advance(8.0)
    assert world.onboard().flight is FlightState.LANDED


def test_a_nearly_empty_battery_lands_the_drone_by_itself(
    make_world: MakeWorld, hand: type
) -> None:
    world = make_world(twin__battery=0.09)
    hand(world).hover()
    hand(world).wait(60.0)
    assert world.onboard().low_battery
    assert world.onboard().flight is FlightState.LANDED


def test_flying_into_a_wall_stops_the_drone_and_blows_nothing_up(
    make_world: MakeWorld, make_room: Callable[..., Room], hand: type, wall: Solid
) -> None:
    world = make_world(make_room((wall,)))
    hand(world).hover()
    touched, places = [], []

    def watch() -> None:
        touched.append(world.truth().contacts)
        places.append(world.truth().pose.position)

    world.set_stick(Stick(forward=1.0, hover=False))
    hand(world).wait(6.0, watch)
    assert max(touched) > 0
    assert max(place[0] for place in places) < 3.95
    assert all(isfinite(value) and abs(value) < 20.0 for place in places for value in place)


def test_standing_on_the_floor_is_no_contact(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    hand(world).wait(0.5)
    assert world.truth().contacts == 0


def test_the_drone_can_be_carried_back_to_its_pad(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    hand(world).hover()
    hand(world).fly(forward=0.5, seconds=1.0)
    world.toggle_emergency()
    hand(world).wait(2.0)
    world.put_drone()
    hand(world).wait(0.5)
    assert world.truth().pose.position == pytest.approx((2.0, 2.5, 0.05), abs=0.003)


STICKS = st.builds(
    Stick,
    forward=st.floats(-1, 1),
    left=st.floats(-1, 1),
    up=st.floats(-1, 1),
    turn=st.floats(-1, 1),
    hover=st.booleans(),
)


@settings(
    max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(
    st.lists(
        st.tuples(STICKS, st.sampled_from(("fly", "fly", "fly", "land", "take off", "toggle"))),
        min_size=1,
        max_size=6,
    )
)
def test_no_stick_and_no_request_can_make_the_state_senseless(
    make_world: MakeWorld,
    make_room: Callable[..., Room],
    hand: type,
    wall: Solid,
    orders: list[tuple[Stick, str]],
) -> None:
    world = make_world(make_room((wall,)))
    hand(world).hover()
    for stick, request in orders:
        world.set_stick(stick)
        {
            "fly": lambda: None,
            "land": world.request_land,
            "take off": world.request_take_off,
            "toggle": world.toggle_emergency,
        }[request]()
        hand(world).wait(0.7)
    truth, onboard = world.truth(), world.onboard()
    assert all(
        map(
            isfinite,
            (*truth.pose.position, *truth.velocity, *onboard.velocity, onboard.phi, onboard.height),
        )
    )
    assert -0.1 < truth.pose.position[2] < 5.0
    assert max(map(abs, truth.velocity)) < 10.0
    assert all(0.0 <= motor <= 1.0 for motor in onboard.motors)


def test_a_room_without_a_visitor_takes_the_order_calmly(make_world: MakeWorld) -> None:
    world = make_world()
    world.set_visitor(True)
    world.advance(0.1)
    assert world.mocap_frames()[-1].bodies[1] == ("visitor", None)


def test_putting_down_turned_keeps_the_heading(make_world: MakeWorld) -> None:
    world = make_world()
    world.put_drone((3.0, 3.0, 0.05), yaw=1.0)
    assert world.truth().pose.orientation == pytest.approx(quaternion_from_euler(0.0, 0.0, 1.0))


def test_a_drone_put_into_the_air_hovers_there_and_lands(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    world.hover_drone((3.0, 3.0, 1.2), yaw=1.0)
    hand(world).wait(5.0)
    truth = world.truth()
    assert world.onboard().flight is FlightState.HOVERING
    assert distance(truth.pose.position, (3.0, 3.0, 1.2)) < 0.15
    assert truth.pose.orientation == pytest.approx(quaternion_from_euler(0.0, 0.0, 1.0), abs=0.05)
    world.request_land()
    hand(world).wait(8.0)
    assert world.onboard().flight is FlightState.LANDED
    assert distance(world.truth().pose.position[:2], (3.0, 3.0)) < 0.3


def test_a_drone_without_its_client_flies_on_for_two_seconds_then_brakes_and_lands(
    make_world: MakeWorld, hand: type
) -> None:
    world = make_world()
    hand(world).hover()
    for _ in range(60):
        world.keep_alive()
        world.set_stick(Stick(forward=0.15, hover=False))
        world.advance(0.03)
    world.advance(1.9)
    assert world.onboard().flight is FlightState.FLYING
    assert world.truth().velocity[0] ** 2 + world.truth().velocity[1] ** 2 > 0.2**2
    world.advance(0.2)
    assert world.onboard().flight is FlightState.LANDING
    world.advance(8.0)
    assert world.onboard().flight is FlightState.LANDED


def fly_and_turn(world: SimulatedWorld, look: bool) -> list[object]:
    seen: list[object] = []
    world.flat_trim()
    world.request_take_off()
    for step in range(900):
        world.keep_alive()
        if step == 600:
            world.set_stick(Stick(forward=0.4, turn=0.2, hover=False))
        world.advance(0.01)
        seen.extend(world.mocap_frames())
        if look:
            world.onboard()
            world.truth()
    return [*seen, world.truth(), world.onboard()]


def test_the_same_seed_is_the_same_flight_bit_for_bit_whoever_looks(make_world: MakeWorld) -> None:
    values = {"twin__mocap_dropout": 0.1, "twin__seed": 5}
    assert fly_and_turn(make_world(**values), look=False) == fly_and_turn(
        make_world(**values), look=True
    )


def test_another_seed_is_another_flight(make_world: MakeWorld) -> None:
    assert (
        fly_and_turn(make_world(twin__seed=1), look=False)[-2:]
        != fly_and_turn(make_world(twin__seed=2), look=False)[-2:]
    )


def test_time_in_many_small_steps_is_the_same_flight(make_world: MakeWorld) -> None:
    def fly(steps: int) -> Pose:
        world = make_world()
        world.request_take_off()
        for _ in range(steps):
            world.advance(1.5 / steps)
        return world.truth().pose

    assert fly(1) == fly(7) == fly(1000)
