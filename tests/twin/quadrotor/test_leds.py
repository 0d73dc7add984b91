"""The simulated drone's lights."""

from __future__ import annotations

import math

import pytest
from kinematic_world import KinematicWorld

from housefly.twin.ardrone.command_server import CommandServer
from housefly.twin.ardrone.config_store import ConfigStore
from housefly.twin.ardrone.link import Link
from housefly.twin.ardrone.server import ArDroneServer
from housefly.twin.quadrotor.leds import STANDARD_ANIMATION, Leds
from housefly.wires.ardrone import at


def test_an_animation_plays_for_its_time_and_zero_seconds_for_ever() -> None:
    leds = Leds()
    assert leds.animation(0.0) == STANDARD_ANIMATION
    assert leds.play(2, 2.0, 2.0, 10.0)
    assert [leds.animation(now) for now in (10.0, 11.9, 12.0)] == [2, 2, STANDARD_ANIMATION]
    assert leds.play(8, 1.0, 0.0, 13.0)
    assert leds.animation(1e6) == 8


@pytest.mark.parametrize(
    "asked", [(21, 2.0, 2.0), (-1, 2.0, 2.0), (2, 0.0, 2.0), (2, math.inf, 2.0), (2, 2.0, -1.0)]
)
def test_what_there_is_not_is_not_played(asked: tuple[int, float, float]) -> None:
    leds = Leds()
    assert not leds.play(*asked, 0.0)
    assert leds.animation(0.0) == STANDARD_ANIMATION


def test_at_led_is_played_and_an_old_number_is_not() -> None:
    world = KinematicWorld()
    server = CommandServer(world, Link(), ConfigStore(), lambda customs: None)
    server.receive(at.encode_datagram(7, (at.Led(2, 2.0, 1),)))
    assert world.truth().leds == 2
    world.advance(1.1)
    assert world.truth().leds == STANDARD_ANIMATION
    server.receive(b"AT*LED=7,5,1073741824,0\r")
    assert world.truth().leds == STANDARD_ANIMATION


def test_the_newer_form_by_configuration_key_is_played_too() -> None:
    world = KinematicWorld()
    server = ArDroneServer(world)
    assert server.settings.write("leds:leds_anim", "3,1073741824,5", None)
    assert world.truth().leds == 3
    assert server.settings.write("leds:leds_anim", "no lights", None)
    assert world.truth().leds == 3
