"""Contacts: what the drone touched, how fast, how high, whoever looks."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from housefly.config.site import Site, changed
from housefly.messages.stick import Stick
from housefly.room.model import Room, Shape, Solid
from housefly.twin.contact_log import Contact
from housefly.twin.movable import Movable
from housefly.twin.people.script import PersonScript
from housefly.twin.people.state import Posture
from housefly.twin.quadrotor.body import STANDING_HEIGHT
from housefly.twin.solids import SolidKind
from housefly.twin.world import SimulatedWorld

MakeRoom = Callable[..., Room]
MakeWorld = Callable[..., SimulatedWorld]
CHILD = PersonScript(name="child", height=0.9, steps=())
STOOL = Movable("stool", 0.18, 0.45)


def only(world: SimulatedWorld) -> Contact:
    assert len(world.contact_log) == 1
    return world.contact_log[0]


def test_a_landing_on_a_childs_head_names_the_child(make_room: MakeRoom, hand: type) -> None:
    """Nobody asks for the truth meanwhile."""
    world = SimulatedWorld(Site(), make_room(), people=(CHILD,))
    pilot = hand(world)
    pilot.hover(1.3)
    world.put_person("child", world.truth().pose.position[:2])
    world.request_land()
    pilot.wait(8.0)
    touched = only(world)
    assert (touched.kind, touched.name) == (SolidKind.PERSON, "child")
    assert touched.height == pytest.approx(0.9, abs=0.03)
    assert 0.1 < touched.closing_speed < 0.5
    assert touched.motors_turned
    assert touched.from_above


def test_standing_on_a_stool_is_a_contact_and_standing_on_the_floor_is_none(
    make_room: MakeRoom,
) -> None:
    world = SimulatedWorld(Site(), make_room(), movables=(STOOL,))
    world.advance(0.5)
    assert world.contact_log == ()
    world.put("stool", (5.0, 2.5))
    world.put_drone((5.0, 2.5, 0.45 + STANDING_HEIGHT))
    world.advance(1.0)
    touched = only(world)
    assert (touched.kind, touched.name) == (SolidKind.MOVABLE, "stool")
    assert touched.from_above
    assert not touched.motors_turned
    assert touched.ended_at == pytest.approx(world.now)


def test_a_wall_is_struck_with_the_speed_before_the_touch(
    make_world: MakeWorld, make_room: MakeRoom, hand: type, wall: Solid
) -> None:
    world = make_world(make_room((wall,)))
    pilot = hand(world)
    pilot.hover(1.0)
    speeds: list[float] = []
    world.set_stick(Stick(forward=0.5, hover=False))
    pilot.wait(4.0, lambda: None if world.contact_log else speeds.append(world.truth().velocity[0]))
    touched = world.contact_log[0]
    assert (touched.kind, touched.name) == (SolidKind.ROOM, "wall")
    assert touched.closing_speed == pytest.approx(speeds[-1], abs=0.05)
    assert touched.speed >= touched.closing_speed
    assert not touched.from_above


def test_a_drone_that_leans_against_a_wall_is_one_contact(
    make_world: MakeWorld, make_room: MakeRoom, hand: type, wall: Solid
) -> None:
    world = make_world(make_room((wall,)))
    pilot = hand(world)
    pilot.hover(1.0)
    world.set_stick(Stick(forward=0.2, hover=False))
    pilot.wait(10.0)
    touched = only(world)
    assert touched.ended_at - touched.began_at > 3.0


def test_the_ceiling_stops_the_drone_and_is_told(make_world: MakeWorld, hand: type) -> None:
    world = make_world()
    pilot = hand(world)
    pilot.hover(1.0)
    pilot.fly(up=1.0, seconds=5.0)
    assert world.truth().pose.position[2] < 2.6
    assert {contact.kind for contact in world.contact_log} == {SolidKind.CEILING}


def test_somebody_who_walks_into_a_hover_brings_the_speed(make_room: MakeRoom, hand: type) -> None:
    world = SimulatedWorld(Site(), make_room(), people=(CHILD,))
    pilot = hand(world)
    pilot.hover(0.8)
    x, y, _ = world.truth().pose.position
    began = world.now

    def walk() -> None:
        world.put_person("child", (x + 1.5 - 1.0 * (world.now - began), y))

    pilot.wait(1.3, walk)
    touched = world.contact_log[0]
    assert touched.name == "child"
    assert touched.speed == pytest.approx(1.0, abs=0.25)


def test_furniture_is_named_by_its_thing(make_room: MakeRoom) -> None:
    legs = Solid("sofa leg", "sofa", Shape.BOX, (5.0, 2.5, 0.2), (0.5, 0.5, 0.4))
    world = SimulatedWorld(Site(), make_room((legs,)))
    world.put_drone((5.0, 2.5, 0.4 + STANDING_HEIGHT))
    world.advance(0.2)
    assert (only(world).kind, only(world).name) == (SolidKind.FURNITURE, "sofa")


def test_the_rooms_visitor_is_a_person(make_room: MakeRoom) -> None:
    world = SimulatedWorld(
        changed(Site(), twin__visitor_present=True), make_room(visitor=(5.0, 2.5))
    )
    world.put_drone((5.0 - 0.3, 2.5, 1.0))
    world.advance(0.05)
    assert (only(world).kind, only(world).name) == (SolidKind.PERSON, "visitor")


def test_who_lies_on_the_floor_can_be_landed_on(make_room: MakeRoom, hand: type) -> None:
    world = SimulatedWorld(Site(), make_room(), people=(CHILD,))
    pilot = hand(world)
    pilot.hover(1.0)
    world.put_person("child", world.truth().pose.position[:2], posture=Posture.LYING)
    world.request_land()
    pilot.wait(6.0)
    assert world.contact_log[0].name == "child"
    assert world.contact_log[0].height < 0.4
