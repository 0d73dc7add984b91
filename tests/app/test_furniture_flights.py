"""Whole flights in the simulated B-sen around furniture that only tracking sees."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import hypot

import pytest
from quick_flights import QUICK

from housefly.config.site import changed
from housefly.geometry import Vec2
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Event, Order, OrderKind, PilotStep
from housefly.pilot.assembly import make_pilot
from housefly.room.distance import half_diagonal
from housefly.sites.loaded_site import LoadedSite, open_site, read_site
from housefly.twin.movable import Movable
from housefly.twin.world import SimulatedWorld

SHELF = {
    "name": "shelf",
    "body": "shelf",
    "model": "smart shelf",
    "length": 0.5,
    "width": 0.35,
    "top": 1.8,
}
"""Too tall to be flown over."""
SHELF_PLACE = (11.5, 4.2)
CHAIR = {"name": "chair", "body": "chair", "length": 0.5, "width": 0.5, "top": 1.5}
HULL = half_diagonal(0.517, 0.451)
GO = Order(OrderKind.GO, "entrance")
RADIUS = 0.25
ASIDE = (13.5, 4.2)
LEFT, ARRIVED = 9.0, 26.0
"""The drone is on its way by then, and has been at its goal for a while [s]."""


def loaded(tracked: bool = True) -> LoadedSite:
    site = read_site("bsen", furniture=[CHAIR] if tracked else [], **QUICK)
    return open_site(changed(site, twin__visitor_present=False))


@dataclass
class Story:
    """A chair that stands somewhere from the start and may be carried elsewhere at a time [s]."""

    place: Vec2 | None
    moved_at: float = 1e9
    moved_to: Vec2 | None = None
    closest: float = 9.0
    contacts: int = 0
    way: list[Vec2] = field(default_factory=list)
    events: list[Event] = field(default_factory=list)
    steps: list[PilotStep] = field(default_factory=list)

    def world(self, world: SimulatedWorld) -> None:
        place = self.place if world.now < self.moved_at else self.moved_to
        world.put("chair", place)
        truth = world.truth()
        x, y, z = truth.pose.position
        self.contacts = max(self.contacts, truth.contacts)
        if z > 0.5:
            self.way.append((x, y))
            if place is not None:
                self.closest = min(self.closest, hypot(x - place[0], y - place[1]) - RADIUS)

    def step(self, step: PilotStep) -> None:
        self.events.extend(step.outputs.events)
        self.steps.append(step)

    def paths(self) -> set[tuple[Vec2, ...]]:
        return {step.outputs.path.waypoints for step in self.steps if step.outputs.path is not None}


def fly(story: Story, tracked: bool = True, until: float = ARRIVED) -> Story:
    fly_lockstep(loaded(tracked), GO, story.step, until, (Movable("chair", RADIUS),), story.world)
    return story


@pytest.fixture(scope="module")
def on_the_way() -> Vec2:
    """A place on the way that the drone takes when nothing stands there."""
    way = fly(Story(None)).way
    return min(way, key=lambda p: abs(p[0] - 7.0))


@pytest.fixture(scope="module")
def around(on_the_way: Vec2) -> Story:
    """Return the flight with the tracked chair on the way from the start."""
    return fly(Story(on_the_way))


@pytest.mark.slow
def test_a_tracked_chair_on_the_way_is_gone_around(around: Story) -> None:
    entrance = loaded().room.place("entrance").viewpoint
    assert around.closest > HULL and around.contacts == 0
    assert hypot(around.way[-1][0] - entrance[0], around.way[-1][1] - entrance[1]) < 0.3


@pytest.mark.slow
def test_without_markers_the_drone_flies_into_the_chair(on_the_way: Vec2) -> None:
    story = fly(Story(on_the_way), tracked=False)
    assert story.closest < HULL and story.contacts > 0


@pytest.mark.slow
def test_a_chair_that_was_carried_away_before_the_order_leaves_its_place_free(
    on_the_way: Vec2, around: Story
) -> None:
    free = fly(Story(ASIDE), until=LEFT).paths()
    assert fly(Story(on_the_way, moved_at=0.3, moved_to=ASIDE), until=LEFT).paths() == free
    assert around.paths() != free


@pytest.mark.slow
def test_a_chair_that_is_put_in_the_way_in_flight_is_told_by_its_name_and_not_touched(
    on_the_way: Vec2,
) -> None:
    story = fly(Story(ASIDE, moved_at=9.0, moved_to=on_the_way))
    told = [event.text for event in story.events if event.code in ("detour", "way_blocked")]
    assert told and all("chair" in text for text in told)
    assert story.contacts == 0


@pytest.mark.slow
def test_another_pilot_with_the_same_inputs_decides_the_same(around: Story) -> None:
    here = loaded()
    pilot = make_pilot(here.site, here.room, here.grid)
    for step in around.steps[:750]:
        assert pilot.step(step.now, step.inputs) == step.outputs


def fly_with_shelf(story: Story, order: Order) -> None:
    site = read_site("bsen", furniture=[SHELF], **QUICK)
    here = open_site(changed(site, twin__visitor_present=False))

    def carry(world: SimulatedWorld) -> None:
        if story.moved_to is not None:
            world.put("shelf", story.moved_to)
        x, y, z = world.truth().pose.position
        story.contacts = max(story.contacts, world.truth().contacts)
        if z > 0.5:
            story.way.append((x, y))

    fly_lockstep(here, order, story.step, ARRIVED, on_world=carry)


def refusals(story: Story) -> list[str]:
    return [event.text for event in story.events if event.code == "order_refused"]


@pytest.mark.interop
@pytest.mark.slow
def test_the_rooms_own_shelf_that_was_carried_away_leaves_its_place_free() -> None:
    story = Story(None, moved_to=(9.5, 5.0))
    fly_with_shelf(story, Order(OrderKind.GO, goal=SHELF_PLACE))
    assert hypot(story.way[-1][0] - SHELF_PLACE[0], story.way[-1][1] - SHELF_PLACE[1]) < 0.3
    assert story.contacts == 0


@pytest.mark.slow
def test_the_rooms_own_shelf_that_stands_where_the_model_has_it_is_not_flown_into() -> None:
    story = Story(None)
    fly_with_shelf(story, Order(OrderKind.GO, goal=SHELF_PLACE))
    assert not story.way and len(refusals(story)) == 1


@pytest.mark.slow
def test_the_rooms_own_shelf_put_on_the_way_is_gone_around(on_the_way: Vec2) -> None:
    story = Story(None, moved_to=on_the_way)
    fly_with_shelf(story, GO)
    entrance = loaded().room.place("entrance").viewpoint
    assert hypot(story.way[-1][0] - entrance[0], story.way[-1][1] - entrance[1]) < 0.3
    assert (
        story.contacts == 0
        and min(hypot(x - on_the_way[0], y - on_the_way[1]) for x, y in story.way) > HULL
    )
