"""True distances from the hull to solids and to people."""

from __future__ import annotations

from collections.abc import Callable
from math import hypot, inf

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.errors import ConfigError
from housefly.room.model import Room, Solid
from housefly.twin.clearance import Clearance
from housefly.twin.movable import Movable
from housefly.twin.people.script import PersonScript
from housefly.twin.world import SimulatedWorld

MakeRoom = Callable[..., Room]
HULL = Site().drone
CHILD = PersonScript(name="child", height=0.9, steps=())


@pytest.fixture
def world(make_room: MakeRoom, wall: Solid) -> SimulatedWorld:
    return SimulatedWorld(
        Site(), make_room((wall,)), movables=(Movable("stool", 0.18, 0.45),), people=(CHILD,)
    )


def at(world: SimulatedWorld, x: float, y: float = 2.5, z: float = 1.0) -> SimulatedWorld:
    world.put_drone((x, y, z))
    world.advance(0.005)
    return world


def test_a_wall_ahead_is_as_far_as_the_hulls_nose(world: SimulatedWorld) -> None:
    clearance = at(world, 2.5).clearance()
    assert clearance.solid == pytest.approx(3.95 - 2.5 - HULL.hull_length / 2, abs=0.002)
    assert clearance.person == inf


def test_the_ceiling_counts_and_the_floor_does_not(world: SimulatedWorld) -> None:
    assert at(world, 1.0, z=2.3).clearance().solid == pytest.approx(0.3 - 0.05, abs=0.005)
    assert at(world, 1.0, z=0.3).clearance().solid > 1.5


def test_touching_is_no_clearance(world: SimulatedWorld) -> None:
    assert at(world, 3.8).clearance().solid == 0.0


def test_a_stool_below_is_nearer_than_the_wall(world: SimulatedWorld) -> None:
    world.put("stool", (1.0, 2.5))
    assert at(world, 1.0, z=0.8).clearance().solid == pytest.approx(0.8 - 0.05 - 0.45, abs=0.005)


@settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.floats(-1.5, 1.5), st.floats(-1.5, 1.5))
def test_the_next_person_is_never_nearer_than_the_hulls_corner_allows(
    world: SimulatedWorld, dx: float, dy: float
) -> None:
    """The child's trunk ends below the hull; what is near the hull is the head, 0.11 m."""
    world.put_person("child", (1.5 + dx, 2.5 + dy))
    at(world, 1.5, z=0.79)
    away = hypot(dx, dy) - 0.11
    corner = hypot(HULL.hull_length, HULL.hull_width) / 2
    assert max(0.0, away - corner) - 0.01 <= world.clearance().person <= max(0.0, away) + 0.01


def test_it_is_measured_once_per_control_period(world: SimulatedWorld) -> None:
    first = at(world, 2.5).clearance()
    assert world.clearance() is first
    world.advance(0.005)
    assert world.clearance() is not first


@settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.floats(0.5, 3.8), st.floats(0.3, 2.2), st.floats(0.0, 3.0), st.floats(0.0, 3.0))
def test_a_look_no_farther_than_asked_finds_the_same_or_that(
    world: SimulatedWorld, x: float, z: float, solid: float, person: float
) -> None:
    world.put_person("child", (1.5, 2.5))
    all_of_it = at(world, x, z=z).clearance()
    nearest = world.clearance(Clearance(solid, person))
    assert nearest.solid == min(solid, all_of_it.solid)
    assert nearest.person == min(person, all_of_it.person)
    assert world.clearance() == all_of_it


def test_who_is_not_there_cannot_be_put(world: SimulatedWorld) -> None:
    with pytest.raises(ConfigError, match="nobody is called 'ann'; there are: child"):
        world.put_person("ann", (1.0, 1.0))


def test_two_people_need_two_names(make_room: MakeRoom) -> None:
    with pytest.raises(ConfigError, match="two people have the same name"):
        SimulatedWorld(Site(), make_room(), people=(CHILD, CHILD))
