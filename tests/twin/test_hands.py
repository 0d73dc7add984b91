"""The simulated drone carried by hand."""

from __future__ import annotations

import asyncio
from math import pi
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import LinkError, WireError
from housefly.sites.loaded_site import load_site
from housefly.twin.hands import CarryOrder, decode_carry, encode_carry
from housefly.twin.hands_link import HandsLink, send_carry
from housefly.twin.world import SimulatedWorld


@pytest.fixture(scope="module")
def world() -> SimulatedWorld:
    loaded = load_site("bsen")
    return SimulatedWorld(loaded.site, loaded.room)


def test_it_is_carried_held_and_laid_down_and_feels_it(world: SimulatedWorld) -> None:
    start, psi = world.truth().pose, world.onboard().psi
    x, y, z = start.position
    world.carry_drone(CarryOrder((x - 1.0, y, z + 0.5), start.yaw + 1.0, 1.0))
    assert world.is_carried
    world.advance(0.5)
    assert world.truth().velocity[0] < -1.0
    world.advance(2.0)
    assert not world.is_carried
    assert world.truth().pose.position == pytest.approx((x - 1.0, y, z + 0.5), abs=0.01)
    assert world.onboard().psi - psi == pytest.approx(1.0, abs=0.02)
    assert world.onboard().height == pytest.approx(0.5, abs=0.05)
    world.carry_drone(CarryOrder((x, y, z), start.yaw, 1.0))
    world.advance(2.5)
    assert world.truth().pose.position == pytest.approx(start.position, abs=0.01)
    assert not world.contact_log


def test_nobody_takes_hold_of_turning_propellers() -> None:
    loaded = load_site("bsen")
    world = SimulatedWorld(loaded.site, loaded.room)
    world.keep_alive()
    world.request_take_off()
    world.advance(1.0)
    with pytest.raises(WireError, match="propellers turn"):
        world.carry_drone(CarryOrder((1.0, 1.0, 0.5), 0.0))


NUMBERS = st.floats(-1000.0, 1000.0)


@given(st.tuples(NUMBERS, NUMBERS, NUMBERS), st.floats(-2 * pi, 2 * pi), st.floats(0.1, 60.0))
def test_an_order_survives_the_wire(position, yaw, duration):
    order = CarryOrder(position, yaw, duration)
    assert decode_carry(encode_carry(order)) == order


@given(st.binary(max_size=200))
def test_other_datagrams_are_refused_in_words(datagram):
    with pytest.raises(WireError):
        decode_carry(datagram)


@pytest.mark.parametrize(
    "text",
    [
        '{"position": [1, 2, NaN], "yaw": 0, "duration": 1}',
        '{"position": [1, 2, 1e9], "yaw": 0, "duration": 1}',
        '{"position": [1, 2, 3], "yaw": 9, "duration": 1}',
        '{"position": [1, 2, 3], "yaw": 0, "duration": 0}',
        '{"position": [1, 2], "yaw": 0, "duration": 1}',
        "[" * 3000,
    ],
)
def test_values_out_of_their_range_are_refused(text: str) -> None:
    with pytest.raises(WireError):
        decode_carry(text.encode())


async def test_orders_arrive_over_the_socket_and_noise_does_no_harm(
    world: SimulatedWorld, tmp_path: Path
) -> None:
    path = tmp_path / "hands"
    with pytest.raises(LinkError, match="does not answer"):
        send_carry(path, CarryOrder((1.0, 1.0, 0.05), 0.0))
    link = HandsLink(world, path)
    link.start()
    try:
        pose = world.truth().pose
        send_carry(path, CarryOrder(pose.position, pose.yaw, 0.5))
        await asyncio.sleep(0.05)
        assert world.is_carried
    finally:
        link.stop()
    assert not path.exists()
