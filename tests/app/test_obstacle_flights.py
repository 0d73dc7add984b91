"""Whole flights in the simulated B-sen around a chair that two scanners see."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from math import dist, hypot

import pytest
from quick_flights import QUICK

from housefly.config.airframe import airframe_named
from housefly.config.site import changed
from housefly.geometry import Vec2, stopping_distance
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Event, Order, OrderKind, PilotStep
from housefly.room.distance import half_diagonal
from housefly.sites.loaded_site import open_site, read_site
from housefly.twin.movable import Movable
from housefly.twin.world import SimulatedWorld

LASERS = (
    {"name": "laser-1", "x": 5.5, "y": 0.85, "z": 1.1, "yaw": 1.2},
    {"name": "laser-2", "address": "127.0.0.2", "x": 13.9, "y": 3.3, "z": 1.1, "yaw": -2.6},
)
DEPTH_CAMERA = {"name": "depth-1", "x": 10.5, "y": 1.25, "z": 1.6, "yaw": 2.75}
"""Looks along the way to the entrance, from above the pad."""
HULL = half_diagonal(0.517, 0.451)
ROOM = open_site(read_site("bsen")).room
SERVICE = Order(OrderKind.SERVICE, "entrance", look_s=1.0)


class Arrived(Exception):
    """What comes after the arrival judges nothing."""


@dataclass
class Story:
    """A chair put in the way when the drone is near enough, and taken away after a while."""

    ahead: float
    radius: float = 0.25
    away_after: float = 1e9
    ends_at: str = ""
    put_at: float = 0.0
    place: Vec2 | None = None
    closest: float = 9.0
    contacts: int = 0
    events: list[Event] = field(default_factory=list)
    steps: list[tuple[float, Vec2, float]] = field(default_factory=list)
    outcome: str = ""

    def world(self, world: SimulatedWorld) -> None:
        truth = world.truth()
        (x, y, z), (vx, vy, _) = truth.pose.position, truth.velocity
        speed = hypot(vx, vy)
        self.steps.append((world.now, (x, y), speed))
        self.contacts = max(self.contacts, truth.contacts)
        if self.place is None and x < 8.0 and speed > 0.45:
            self.place, self.put_at = (
                (x + vx / speed * self.ahead, y + vy / speed * self.ahead),
                world.now,
            )
            world.put("chair", self.place)
        if self.place is not None and z > 0.5:
            if world.now - self.put_at < self.away_after:
                self.closest = min(
                    self.closest, hypot(x - self.place[0], y - self.place[1]) - self.radius
                )
            else:
                world.put("chair", None)
        if self.ends_at and self.is_at(self.ends_at, (x, y)):
            raise Arrived

    def is_at(self, place: str, here: Vec2) -> bool:
        return dist(here, ROOM.place(place).viewpoint) < 0.3

    def came_to(self, place: str) -> bool:
        return any(self.is_at(place, here) for _, here, _ in self.steps)

    def told(self, code: str) -> float:
        return next((event.at for event in self.events if event.code == code), float("nan"))


Fly = Callable[..., Story]


@pytest.fixture
def fly() -> Fly:
    def make(
        story: Story, seeing: bool = True, give_up_after: float = 120.0, **sensors: object
    ) -> Story:
        sensors = sensors or {"lasers": list(LASERS) if seeing else []}
        site = changed(read_site("bsen", **QUICK), **sensors, twin__visitor_present=False)
        chair = Movable("chair", story.radius)

        def on_step(step: PilotStep) -> None:
            story.events.extend(step.outputs.events)

        loaded = open_site(site)
        with suppress(Arrived):
            story.outcome = fly_lockstep(
                loaded, SERVICE, on_step, give_up_after, (chair,), story.world
            )
        return story

    return make


@pytest.mark.slow
@pytest.mark.parametrize("ahead", [1.1, pytest.param(2.0, marks=pytest.mark.safety)])
def test_a_chair_put_before_the_drone_is_seen_avoided_and_the_service_completed(
    fly: Fly, ahead: float
) -> None:
    story = fly(Story(ahead))
    assert story.outcome == "completed"
    assert story.closest > HULL and story.contacts == 0
    seen = (
        min(story.told("way_blocked"), story.told("detour"))
        if ahead < 1.5
        else story.told("detour")
    )
    assert seen - story.put_at < 0.2


@pytest.mark.interop
@pytest.mark.slow
def test_a_chair_that_only_a_depth_camera_sees_is_avoided_too(fly: Fly) -> None:
    story = fly(Story(2.0, ends_at="entrance"), give_up_after=60.0, depth_cameras=[DEPTH_CAMERA])
    assert story.came_to("entrance")
    assert story.closest > HULL and story.contacts == 0
    assert story.told("detour") - story.put_at < 0.6


@pytest.mark.slow
def test_it_stops_within_one_stopping_distance_and_three_tenths_of_being_seen(fly: Fly) -> None:
    story = fly(Story(1.1), give_up_after=16.0)
    at = story.told("way_blocked")
    start, speed = next((place, speed) for now, place, speed in story.steps if now >= at - 1e-6)
    stop = next(place for now, place, s in story.steps if now > at and s < 0.1)
    braking = airframe_named("ardrone").braking
    assert (
        hypot(stop[0] - start[0], stop[1] - start[1])
        < stopping_distance(speed, braking.deceleration, 0.1) + 0.3 * speed
    )
    # What is as large as a person is kept a person's distance from: back off first, then around.
    assert story.told("making_way") - at < 0.3
    assert story.told("detour") - at < 5.0
    assert story.closest > HULL and story.contacts == 0


@pytest.mark.interop
@pytest.mark.slow
def test_what_fills_the_corridor_is_waited_for_and_flown_past_when_taken_away(fly: Fly) -> None:
    story = fly(Story(2.2, radius=1.4, away_after=9.0, ends_at="entrance"), give_up_after=45.0)
    assert story.came_to("entrance")
    assert story.closest > HULL and story.contacts == 0
    assert any("waiting here" in event.text for event in story.events if event.code == "no_way")
    assert story.told("detour") - story.put_at > 9.0


@pytest.mark.slow
def test_without_scanners_the_drone_flies_into_the_chair(fly: Fly) -> None:
    story = fly(Story(1.1), seeing=False, give_up_after=25.0)
    assert story.closest < HULL and story.contacts > 0


@pytest.mark.slow
def test_scanners_that_see_nothing_new_change_nothing(fly: Fly) -> None:
    looking, blind = (
        fly(Story(1.0, away_after=-1.0), seeing=seeing, give_up_after=12.0)
        for seeing in (True, False)
    )
    assert looking.steps == blind.steps and not looking.told("detour") > 0
