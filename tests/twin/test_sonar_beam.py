"""The sonar sees what is really below the drone, and the bare floor as ever."""

from __future__ import annotations

from collections.abc import Callable
from statistics import fmean

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.room.files import load_room
from housefly.room.model import Room, Shape, Solid
from housefly.twin.contracts import FlightState
from housefly.twin.movable import Movable
from housefly.twin.people.script import PersonScript
from housefly.twin.people.state import Posture
from housefly.twin.quadrotor.body import STANDING_HEIGHT
from housefly.twin.sonar_beam import SonarBeam
from housefly.twin.world import SimulatedWorld

MakeRoom = Callable[..., Room]
CHILD = PersonScript(name="child", height=0.9, steps=())
STOOL = Movable("stool", 0.18, 0.45)


@pytest.fixture(scope="module")
def furnished() -> SimulatedWorld:
    return SimulatedWorld(Site(), load_room("bsen"), movables=(STOOL,), people=(CHILD,))


@pytest.fixture(scope="module")
def beam(furnished: SimulatedWorld) -> SonarBeam:
    return SonarBeam(furnished._physics.drones[0])


@settings(max_examples=300, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.floats(-1.0, 16.0), st.floats(-1.0, 8.0), st.floats(0.05, 2.6))
def test_where_no_ray_is_cast_none_would_meet_anything(
    beam: SonarBeam, x: float, y: float, z: float
) -> None:
    assert beam.height((x, y, z)) == beam.cast((x, y, z))


def test_bare_floor_carpets_and_the_pad_are_floor(
    furnished: SimulatedWorld, beam: SonarBeam
) -> None:
    assert beam.cast((10.55, 1.25, 1.0)) == 0.0
    assert beam.cast((12.25, 1.6, 0.5)) == 0.0
    assert beam.cast((10.55, 1.25, STANDING_HEIGHT)) == 0.0


@pytest.mark.parametrize(
    ("posture", "support", "top"),
    [
        (Posture.STANDING, 0.0, 0.9),
        (Posture.SITTING, 0.44, 0.9 - 0.52 * 0.9 + 0.17 + 0.44),
        (Posture.LYING, 0.0, 0.34),
    ],
)
def test_a_child_is_seen_in_every_posture_and_no_longer_when_it_went(
    furnished: SimulatedWorld, beam: SonarBeam, posture: Posture, support: float, top: float
) -> None:
    furnished.put_person("child", (9.0, 2.0), posture=posture, support=support)
    assert beam.height((9.0, 2.0, 1.5)) == pytest.approx(top, abs=0.02)
    furnished.put_person("child", None)
    assert beam.height((9.0, 2.0, 1.5)) == 0.0


def test_a_table_overhead_is_not_below(make_room: MakeRoom) -> None:
    table = Solid("table top", "table", Shape.BOX, (2.0, 2.5, 0.72), (1.2, 1.2, 0.04))
    beam = SonarBeam(SimulatedWorld(Site(), make_room((table,)))._physics.drones[0])
    assert beam.height((2.0, 2.5, 0.3)) == 0.0
    assert beam.height((2.0, 2.5, 1.3)) == pytest.approx(0.74)


def test_a_wall_beside_the_drone_is_not_below(make_room: MakeRoom, wall: Solid) -> None:
    beam = SonarBeam(SimulatedWorld(Site(), make_room((wall,)))._physics.drones[0])
    assert beam.height((3.75, 2.5, 2.0)) == 0.0


def test_the_drone_stands_on_a_stool_and_reads_no_height() -> None:
    world = SimulatedWorld(Site(), load_room("bsen"), movables=(STOOL,))
    world.put("stool", (9.0, 2.0))
    world.put_drone((9.0, 2.0, 0.45 + STANDING_HEIGHT))
    world.advance(1.0)
    assert world.onboard().height == pytest.approx(0.0, abs=0.05)


def test_a_hovering_drone_climbs_when_a_stool_is_put_below_it(
    make_room: MakeRoom, hand: type
) -> None:
    """As the real one does: its height hold is above whatever the sonar meets."""
    world = SimulatedWorld(Site(), make_room(), movables=(STOOL,))
    pilot = hand(world)
    pilot.hover(1.0)
    before = world.truth().pose.position
    world.put("stool", before[:2])
    pilot.wait(0.3)
    readings: list[float] = []
    pilot.wait(0.2, lambda: readings.append(world.onboard().height))
    assert fmean(readings) < before[2] - STANDING_HEIGHT - 0.3
    pilot.wait(8.0)
    assert world.truth().pose.position[2] == pytest.approx(before[2] + 0.45, abs=0.15)
    world.request_land()
    pilot.wait(7.0)
    assert world.onboard().flight is FlightState.LANDED
