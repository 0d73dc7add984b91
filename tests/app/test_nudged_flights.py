"""A drone that is moved by hand in the simulated B-sen: whatever is held, it touches nothing.

Scored on the truth of the simulation: contacts, and the distance from hull to what is nearest.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from math import hypot

import pytest
from quick_flights import QUICK

from housefly.config.site import Site, changed
from housefly.geometry import Vec2, Vec3
from housefly.lab.lockstep.simulation import SETTLING_TIME, Simulation
from housefly.messages import Event, Order, OrderKind, Phase, PilotStep
from housefly.pilot.navigator import RoomNavigator
from housefly.sites.loaded_site import open_site, read_site
from housefly.twin.people.script import PersonScript

LASERS = (
    {"name": "laser-1", "x": 5.5, "y": 0.85, "z": 1.1, "yaw": 1.2},
    {"name": "laser-2", "address": "127.0.0.2", "x": 13.9, "y": 3.3, "z": 1.1, "yaw": -2.6},
)
ZONE = {"kind": "keep_out", "polygon": [[6.0, -3.0], [7.5, -3.0], [7.5, 8.0], [6.0, 8.0]]}
HALF_VOXEL = 0.05
WEST, EAST = (-0.5, 0.0, 0.0), (0.5, 0.0, 0.0)


@dataclass
class ByHand:
    """A drone in the air, and what became of it; keys are held ten times a second."""

    loop: Simulation
    events: list[Event] = field(default_factory=list)
    places: list[Vec3] = field(default_factory=list)
    nearest_solid: float = 9.0
    nearest_person: float = 9.0
    step: PilotStep | None = None

    def run(self, seconds: float, velocity: Vec3 | None = None) -> None:
        for n in range(round(seconds / self.loop.period)):
            every = round(0.1 / self.loop.period)
            nudge = velocity is not None and n % every == 0
            orders = (self.order(OrderKind.NUDGE, velocity),) if nudge else ()
            self.tick(orders)

    def order(self, kind: OrderKind, velocity: Vec3 | None = None) -> Order:
        return Order(kind, issued_at=self.loop.now, sender="Ann", velocity=velocity)

    def tick(self, orders: tuple[Order, ...] = ()) -> None:
        self.loop.advance()
        # The order is stamped before: it is one control period old when it is read.
        self.step = self.loop.step(self.loop.inputs(*orders))
        self.events.extend(self.step.outputs.events)
        if self.step.outputs.phase is not Phase.HOLDING:
            return
        clear = self.loop.world.clearance()
        self.nearest_solid = min(self.nearest_solid, clear.solid)
        self.nearest_person = min(self.nearest_person, clear.person)
        self.places.append(self.loop.world.truth().pose.position)

    def told(self, code: str) -> list[str]:
        return [event.text for event in self.events if event.code == code]

    @property
    def speed(self) -> float:
        return hypot(*self.loop.world.truth().velocity)


def in_the_air(people: tuple[PersonScript, ...] = (), **keys: object) -> ByHand:
    site: Site = changed(
        read_site("bsen", **QUICK), twin__visitor_present=False, limits__nudge_speed=0.5, **keys
    )
    flight = ByHand(Simulation(open_site(site), people=people))
    flight.run(SETTLING_TIME)
    flight.tick((flight.order(OrderKind.TAKE_OFF),))
    for _ in range(1500):
        flight.tick()
        if flight.step is not None and flight.step.outputs.phase is Phase.HOLDING:
            flight.run(1.0)
            return flight
    raise AssertionError(f"it did not take off: {flight.events}")


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.safety)])
def test_whatever_is_held_in_bsen_it_touches_nothing(seed: int) -> None:
    flight, chance = in_the_air(), random.Random(seed)
    for _ in range(12):
        velocity = tuple(chance.choice((-0.5, -0.5, 0.0, 0.5, 0.5)) for _ in range(3))
        flight.run(chance.choice((0.3, 1.0, 2.5, 4.0)), velocity)  # type: ignore[arg-type]
    flight.run(2.5)
    assert flight.loop.contacts() == ()
    assert flight.nearest_solid > 0.05
    assert flight.step is not None and flight.step.outputs.phase is Phase.HOLDING
    assert flight.speed < 0.05
    travelled = [max(axis) - min(axis) for axis in zip(*flight.places, strict=True)]
    assert max(travelled[:2]) > 1.0 and travelled[2] > 0.3


@pytest.mark.slow
def test_without_the_look_at_its_stop_the_same_key_flies_it_into_the_wall(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    nearest: dict[bool, float] = {}
    for looks in (True, False):
        if not looks:
            monkeypatch.setattr(RoomNavigator, "closed", lambda *_: "")
        flight = in_the_air()
        flight.run(6.0, (0.0, -0.5, 0.0))
        touched = [one.kind for one in flight.loop.contacts()]
        nearest[looks] = flight.nearest_solid
        assert bool(touched) is not looks
    assert nearest[True] > 0.1 and nearest[False] == 0.0


@pytest.mark.slow
def test_a_key_held_towards_somebody_whom_scanners_see_keeps_their_distance() -> None:
    flight = in_the_air(people=(PersonScript(name="eve", steps=()),), lasers=list(LASERS))
    x, y, _ = flight.places[-1]
    flight.loop.world.put_person("eve", (x - 2.6, y))
    flight.run(2.0)
    flight.run(8.0, WEST)
    assert flight.loop.contacts() == ()
    assert flight.nearest_person > 0.4
    assert any("near" in text for text in flight.told("nudge_limited"))


@pytest.mark.slow
def test_a_key_held_towards_a_no_fly_zone_stops_at_its_edge() -> None:
    flight = in_the_air(volumes=[ZONE])
    flight.run(12.0, WEST)
    assert min(x for x, _, _ in flight.places) > 7.5 - HALF_VOXEL - 0.02
    assert flight.told("nudge_limited") == ["moved by hand: the end of where it may fly is ahead"]
    assert flight.loop.contacts() == ()


def test_places_of_the_story_are_in_the_room() -> None:
    """The zone lies between the drone's pad and the far end of the room, or it proves nothing."""
    loaded = open_site(read_site("bsen", **QUICK))
    home: Vec2 = loaded.room.home
    assert home[0] > 8.0 and loaded.room.bounds[0] < 6.0
