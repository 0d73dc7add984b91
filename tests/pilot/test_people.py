"""People: paths keep away from them, a drone that stands makes way, and nobody is landed on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import cos, dist, hypot, pi, sin
from typing import Any

import pytest

from housefly.messages import (
    Action,
    DroneStatus,
    Obstacle,
    ObstacleKind,
    OrderKind,
    OrderOutcome,
    OrderSource,
    Phase,
    Pose,
    SafetyMode,
    Sighting,
)
from housefly.pilot.assembly import make_pilot
from housefly.pilot.behavior.braking import LAST_HEIGHT
from housefly.pilot.behavior.commander import Commander
from housefly.pilot.behavior.mission import LANDING_PLACE, Mission, Refused
from housefly.pilot.planning.people_map import SPOT_APART
from housefly.room.distance import half_diagonal
from housefly.room.grid import Cell
from housefly.room.model import Shape, Solid

Fly = Callable[..., Any]
HULL = half_diagonal(0.517, 0.451)
BODY = 0.2
"""Radius of a person's body [m]."""


class Person:
    """Somebody whom a sensor sees 25 times a second, walking straight on from a time on."""

    def __init__(
        self,
        place: tuple[float, float],
        velocity: tuple[float, float] = (0.0, 0.0),
        leaves_at: float = 0.0,
        kind: ObstacleKind = ObstacleKind.PERSON,
        name: str = "somebody",
    ) -> None:
        self.start, self.velocity, self.leaves_at, self.kind = place, velocity, leaves_at, kind
        self.name, self.closest, self.walks_for = name, float("inf"), 1e9

    def place(self, now: float) -> tuple[float, float]:
        since = min(max(0.0, now - self.leaves_at), self.walks_for)
        return self.start[0] + since * self.velocity[0], self.start[1] + since * self.velocity[1]

    def seen(self, flight: Any) -> tuple[Obstacle, ...]:
        now = flight.now
        x, y = self.place(now)
        if flight.body.z > 0.15:
            apart = hypot(flight.body.x - x, flight.body.y - y)
            self.closest = min(self.closest, apart - BODY - HULL)
        if round(now * 100) % 4:
            return ()
        walks = self.leaves_at <= now < self.leaves_at + self.walks_for
        velocity = self.velocity if walks else (0.0, 0.0)
        return (
            Obstacle(
                self.name,
                (x, y),
                BODY,
                velocity=velocity,
                seen_at=now,
                source="laser",
                kind=self.kind,
            ),
        )


def hovering(fly: Fly, at: tuple[float, float], **options: Any) -> Any:
    """A flight that hovers at a place [m]."""
    flight = fly(**options)
    flight.hover(at)
    return flight


@pytest.mark.parametrize("bearing", [0.0, 0.3, 0.5, 0.75, 1.0, 1.4])
def test_who_walks_towards_a_hover_is_made_way_for_and_it_comes_back(
    fly: Fly, bearing: float
) -> None:
    flight = hovering(fly, (3.5, 2.5))
    c, s = cos(bearing * pi), sin(bearing * pi)
    away = 4.0 if abs(s) < 0.5 else 2.2
    walker = Person((3.5 + away * c, 2.5 + away * s), (-c, -s), flight.now + 1.0)
    walker.walks_for = 2.0 * away
    flight.around = walker.seen
    flight.run(1.0 + walker.walks_for)
    assert walker.closest > 0.5
    assert flight.told("making_way")
    flight.around = lambda f: ()
    flight.until(lambda o: hypot(flight.body.x - 3.5, flight.body.y - 2.5) < 0.3, 18.0)


def test_what_is_not_known_as_a_person_is_not_made_way_for(fly: Fly) -> None:
    """The negative control."""
    flight = hovering(fly, (3.5, 2.5))
    thing = Person((7.0, 2.5), (-1.0, 0.0), flight.now + 1.0, ObstacleKind.THING)
    flight.around = thing.seen
    flight.run(8.0)
    assert thing.closest < 0.0


def test_somebody_who_runs_head_on_into_a_drone_on_its_way_is_not_touched(fly: Fly) -> None:
    flight = fly()
    flight.run(0.5)
    flight.step(flight.order(OrderKind.GO, goal=(5.0, 3.6)))
    flight.until(lambda o: o.phase is Phase.OUTBOUND)
    flight.run(2.0)
    b = flight.body
    length = hypot(5.0 - b.x, 3.6 - b.y)
    ux, uy = (5.0 - b.x) / length, (3.6 - b.y) / length
    runner = Person((b.x + 4.5 * ux, b.y + 4.5 * uy), (-1.5 * ux, -1.5 * uy), flight.now)
    flight.around = runner.seen
    flight.run(6.0)
    assert runner.closest > 0.0


@pytest.mark.parametrize("later", [0.0, 1.0, 2.0])
def test_somebody_who_crosses_is_waited_for(fly: Fly, later: float) -> None:
    flight = fly()
    flight.run(0.5)
    flight.step(flight.order(OrderKind.GO, goal=(10.75, 3.5)))
    flight.until(lambda o: o.phase is Phase.OUTBOUND)
    walker = Person((5.0, 0.3), (0.0, 0.9), flight.now + later)
    walker.walks_for = 4.5
    flight.around = walker.seen
    flight.run(12.0)
    assert walker.closest > 0.4


def corridor(flight: Any) -> tuple[Obstacle, ...]:
    """Things that leave a way of 1.6 m from x = 6.5 m to the wall at 12.5 m."""
    if round(flight.now * 100) % 20:
        return ()
    sides = (("right", 0.85), ("left", 4.15))
    return tuple(
        Obstacle(name, (9.5, y), size=(6.0, 1.7), seen_at=flight.now, kind=ObstacleKind.THING)
        for name, y in sides
    )


@pytest.mark.parametrize("ahead", [8.0, pytest.param(9.0, marks=pytest.mark.safety)])
def test_who_walks_after_the_drone_into_a_dead_end_finds_it_on_the_floor(
    fly: Fly, ahead: float
) -> None:
    """Nobody is made way for there, so it lands while there is time."""
    flight = fly()
    flight.around = corridor
    flight.run(0.5)
    flight.step(flight.order(OrderKind.GO, goal=(11.0, 2.5)))
    while flight.body.x < ahead and flight.now < 90.0:
        flight.step()
    walker = Person((flight.body.x - 6.5, 2.5), (1.2, 0.0), flight.now)
    flight.around = lambda f: (*corridor(f), *walker.seen(f))
    flight.run(8.0)
    assert flight.told("cornered_landing")
    assert flight.outputs.phase is Phase.IDLE
    assert walker.closest > 0.0


def test_paths_keep_the_comfort_distance_where_there_is_room(fly: Fly) -> None:
    flight = fly()
    person = Person((8.8, 2.7))
    flight.around = person.seen
    flight.depart()
    flight.until(lambda o: o.phase is Phase.HOLDING, 90.0)
    assert person.closest > 0.9


def test_near_somebody_the_drone_is_slow(fly: Fly) -> None:
    flight = fly()
    person = Person((6.0, 4.0))
    flight.around = person.seen
    flight.depart()
    fastest = 0.0
    for _ in range(3000):
        outputs = flight.step()
        x, y = person.place(flight.now)
        if hypot(flight.body.x - x, flight.body.y - y) - BODY - HULL < 1.15:
            fastest = max(fastest, flight.speed)
        if outputs.phase is Phase.HOLDING:
            break
    assert 0.0 < fastest < 0.4


def test_nobody_is_flown_over_however_low_they_are(fly: Fly) -> None:
    flight = fly()
    x, y = 8.5, 2.2
    closest = [9.0]

    def lying(f: Any) -> tuple[Obstacle, ...]:
        closest[0] = min(closest[0], hypot(f.body.x - x, f.body.y - y))
        if round(f.now * 100) % 10:
            return ()
        seen = Obstacle("child", (x, y), BODY, seen_at=f.now, bottom=0.0, top=0.4)
        return (replace(seen, kind=ObstacleKind.PERSON),)

    flight.around = lying
    flight.depart()
    flight.until(lambda o: o.phase is Phase.HOLDING, 90.0)
    assert closest[0] > BODY + HULL + 0.4


def test_a_tracked_person_and_an_unknown_body_are_in_the_way(fly: Fly) -> None:
    for name in ("visitor", "another drone"):
        flight = fly()
        place = (3.6, 1.6)
        see = flight._look

        def look(
            see: Any = see, flight: Any = flight, name: str = name, place: Any = place
        ) -> tuple[Sighting, ...]:
            at = flight.now - 0.02
            return (*see(), Sighting(name, Pose((*place, 0.0)), at, flight.now))

        flight._look = look
        flight.depart()
        closest = 9.0
        while flight.outputs.phase is not Phase.HOLDING and flight.now < 90.0:
            flight.step()
            apart = hypot(flight.body.x - place[0], flight.body.y - place[1])
            closest = min(closest, apart)
        assert flight.outputs.phase is Phase.HOLDING
        assert closest > HULL + 0.25


def homeward(fly: Fly, **site: Any) -> Any:
    """A flight that comes home from nearby."""
    flight = hovering(fly, (4.0, 1.25), **site)
    flight.step(flight.order(OrderKind.HOME))
    return flight


def test_who_stands_on_the_pad_is_not_landed_on(fly: Fly) -> None:
    flight = homeward(fly)
    child = Person((2.0, 1.25))
    flight.around = child.seen
    flight.run(60.0)
    assert child.closest > 0.4
    assert flight.status is not DroneStatus.LANDED or flight.home_error > HULL + BODY


def lowest_of(flight: Any, seconds: float) -> float:
    """Fly on for so long [s] and return the lowest height meanwhile [m]."""
    lowest, until = float("inf"), flight.now + seconds
    while flight.now < until:
        flight.step()
        lowest = min(lowest, flight.body.z)
    return lowest


@pytest.mark.parametrize(("kind", "away"), [(ObstacleKind.PERSON, 0.95), (ObstacleKind.THING, 0.6)])
def test_who_comes_while_the_drone_sinks_makes_it_rise_again(
    fly: Fly, kind: ObstacleKind, away: float
) -> None:
    """They step out from behind something, or put a chair there: that is not made way for."""
    flight = homeward(fly)
    comer = Person((9.0, 4.0), kind=kind)
    flight.around = comer.seen
    flight.until(lambda o: flight.body.z < 0.9, 40.0)
    assert flight.status is DroneStatus.FLYING
    comer.start = (2.0 + away, 1.25)
    assert lowest_of(flight, 1.0) > 0.75
    assert flight.told("landing_blocked")
    flight.run(2.0)
    assert flight.status is DroneStatus.FLYING and flight.body.z > 1.0
    assert comer.closest > 0.0


def test_who_walks_up_while_the_drone_sinks_is_made_way_for(fly: Fly) -> None:
    flight = homeward(fly)
    walker = Person((5.2, 1.25), (-1.0, 0.0), 1e9)
    flight.around = walker.seen
    flight.until(lambda o: flight.body.z < 0.9, 40.0)
    assert flight.status is DroneStatus.FLYING
    walker.leaves_at, walker.walks_for = flight.now, 2.6
    flight.run(5.0)
    assert flight.told("making_way") and flight.status is DroneStatus.FLYING
    assert walker.closest > 0.3


def test_the_pilot_steers_the_drone_down_before_it_lands_by_itself(fly: Fly) -> None:
    flight = homeward(fly)
    flight.until(lambda o: o.command.action is Action.LAND, 40.0)
    assert flight.body.z < LAST_HEIGHT + 0.1
    assert flight.home_error < 0.1


def test_in_mode_paper_the_drone_lands_by_itself_with_nobody_near(fly: Fly) -> None:
    flight = homeward(fly, mode="paper")
    flight.until(lambda o: o.command.action is Action.LAND, 40.0)
    assert flight.body.z > 0.9


def tell_height(flight: Any, height: Callable[[float], float]) -> None:
    """Let the drone's own sensor tell what becomes of its true height [m]."""
    step = flight.pilot.step

    def told_otherwise(now: float, inputs: Any) -> Any:
        heard = replace(inputs.telemetry, height=height(flight.body.z))
        return step(now, replace(inputs, telemetry=heard))

    flight.pilot.step = told_otherwise


def put_on_pad(flight: Any, top: float = 0.6) -> None:
    """Let the drone's own sensor see something as high as this [m] where the pad is."""
    tell_height(flight, lambda z: max(0.0, z - (top if flight.home_error < 0.4 else 0.0)))


def test_something_that_only_the_sonar_shows_is_not_landed_on(fly: Fly) -> None:
    flight = homeward(fly)
    put_on_pad(flight)
    flight.until(lambda o: flight.status is DroneStatus.LANDED, 60.0)
    assert flight.told("landing_blocked") and flight.home_error > 0.5


def test_a_landing_of_the_gate_that_is_steered_leaves_what_only_the_sonar_shows(fly: Fly) -> None:
    flight = homeward(fly)
    flight.until(lambda o: flight.home_error < 0.3, 40.0)
    put_on_pad(flight)
    while flight.step().safety is not SafetyMode.LAND:
        flight.wind = (1.1 * sin(4.0 * flight.now), 0.0)
    assert flight.told("blown_about") and flight.body.z > 0.9 and flight.home_error < 0.4
    flight.wind = (0.0, 0.0)
    while flight.status is not DroneStatus.LANDED:
        flight.step()
        assert flight.body.z > 0.8 or flight.home_error > 0.4
    assert 0.7 < flight.home_error < 1.5


@pytest.mark.parametrize(
    "near",
    [
        pytest.param(lambda now: 0.15, id="what it is"),
        pytest.param(lambda now: 0.23, id="the least that it measures"),
        pytest.param(lambda now: 0.0, id="nothing"),
        pytest.param(lambda now: (0.03, 1.1, 0.19, 4.0)[round(now * 20) % 4], id="garbage"),
    ],
)
def test_who_is_nearer_than_the_sonar_can_measure_is_not_landed_on(
    fly: Fly, near: Callable[[float], float]
) -> None:
    """A child of 0.9 m below a drone at 1.1 m; what a real sonar tells of that is not known."""
    flight = homeward(fly)
    tell_height(flight, lambda z: near(flight.now) if flight.home_error < 0.4 else z)
    above_child = float("inf")
    while flight.status is not DroneStatus.LANDED and flight.now < 90.0:
        flight.step()
        if flight.home_error < 0.4:
            above_child = min(above_child, flight.body.z - 0.9)
    assert above_child > 0.1
    assert flight.told("landing_blocked") and flight.home_error > 0.5


def test_what_comes_below_the_sinking_drone_unseen_makes_it_rise_again(fly: Fly) -> None:
    flight = homeward(fly)
    flight.until(lambda o: flight.body.z < 0.9, 40.0)
    put_on_pad(flight, 0.65)
    assert lowest_of(flight, 2.0) > 0.8
    assert flight.told("landing_blocked")
    assert flight.status is DroneStatus.FLYING and flight.body.z > 1.0


@pytest.mark.parametrize("stuck", [0.0, 0.02, 1.1])
def test_a_sonar_that_has_been_stuck_since_the_floor_or_is_high_keeps_nobody_up(
    fly: Fly, stuck: float
) -> None:
    flight = fly()
    tell_height(flight, lambda z: stuck)
    flight.run(0.5)
    flight.step(flight.order(OrderKind.GO, goal=(4.0, 1.25)))
    flight.until(lambda o: o.phase is Phase.HOLDING, 60.0)
    flight.step(flight.order(OrderKind.HOME))
    flight.until(lambda o: flight.status is DroneStatus.LANDED, 40.0)
    assert flight.home_error < 0.15
    assert not flight.told("landing_blocked")


@pytest.mark.parametrize(
    "told",
    [
        pytest.param(lambda z, now: max(0.0, z - 0.5), id="low, or tracking is high"),
        pytest.param(lambda z, now: max(0.0, z - (0.0, 0.4)[round(50 * now) % 2]), id="noisy"),
    ],
)
def test_where_something_seems_to_stand_below_everywhere_the_sonar_is_not_believed(
    fly: Fly, told: Callable[[float, float], float]
) -> None:
    flight = fly()
    flight.run(0.5)
    flight.step(flight.order(OrderKind.GO, goal=(4.0, 1.25)))
    flight.until(lambda o: o.phase is Phase.HOLDING, 60.0)
    tell_height(flight, lambda z: told(z, flight.now))
    flight.step(flight.order(OrderKind.HOME))
    flight.until(lambda o: flight.status is DroneStatus.LANDED, 40.0)
    assert flight.told("sonar_wrong") and not flight.told("forced_down")


def test_where_no_way_leads_to_the_nearest_places_to_land_the_next_one_is_tried(
    fly: Fly, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[tuple[float, float]] = []
    way = Commander.way

    def first_ones_refused(self: Commander, mission: Mission, vehicle: Any) -> Any:
        if mission.name == LANDING_PLACE and mission.goal not in asked:
            asked.append(mission.goal)
            if len(asked) <= 2:
                return Refused(OrderOutcome.NO_WAY, "no way")
        return way(self, mission, vehicle)

    monkeypatch.setattr(Commander, "way", first_ones_refused)
    flight = homeward(fly)
    put_on_pad(flight)
    flight.until(lambda o: flight.status is DroneStatus.LANDED, 60.0)
    assert len(asked) == 3 and flight.home_error > 0.5
    assert dist(asked[0], asked[1]) > SPOT_APART and dist(asked[1], asked[2]) > SPOT_APART


def test_no_take_off_while_somebody_stands_beside_the_drone(fly: Fly) -> None:
    flight = fly()
    person = Person((2.7, 1.25))
    flight.around = person.seen
    flight.run(0.5)
    outputs = flight.step(flight.order(OrderKind.TAKE_OFF))
    assert outputs.phase is Phase.IDLE
    assert any("somebody is too close" in event.text for event in outputs.events)
    person.start = (5.0, 1.25)
    flight.run(0.2)
    assert flight.step(flight.order(OrderKind.TAKE_OFF)).phase is Phase.TAKING_OFF


def refused_take_off(flight: Any) -> str:
    """Return why a flight's pilot refuses to take off, in words; "" when it takes off."""
    flight.run(0.5)
    outputs = flight.step(flight.order(OrderKind.TAKE_OFF))
    refusals = [event.text for event in outputs.events if event.code == "order_refused"]
    assert (outputs.phase is Phase.IDLE) == bool(refusals)
    assert flight.run(2.0).command.action is (Action.IDLE if refusals else Action.TAKE_OFF)
    return " ".join(refusals)


@pytest.mark.parametrize(("aside", "is_refused"), [(0.0, True), (0.5, False)])
def test_no_take_off_from_inside_a_no_fly_area(fly: Fly, aside: float, is_refused: bool) -> None:
    flight = fly()
    x, y = flight.grid.cell_of((flight.body.x, flight.body.y + aside))
    cells = flight.grid.cells.copy()
    cells[x - 1 : x + 2, y - 1 : y + 2] = Cell.VIRTUAL
    flight.pilot = make_pilot(flight.site, flight.room, replace(flight.grid, cells=cells))
    assert ("no-fly area: carry it out" in refused_take_off(flight)) is is_refused


@pytest.mark.parametrize(
    ("aside", "bottom", "is_refused"),
    [
        (0.0, 0.7, True),
        (0.0, 0.2, True),
        (0.35 + HULL + 0.04, 0.7, True),
        (0.35 + HULL + 0.06, 0.7, False),
        (0.0, 2.2, False),
    ],
    ids=["under a table", "under a bench", "beside one", "free of it", "under a lamp"],
)
def test_no_take_off_from_under_furniture(
    fly: Fly, aside: float, bottom: float, is_refused: bool
) -> None:
    flight = fly()
    middle = (flight.body.x, flight.body.y + aside, bottom + 0.02)
    board = Solid("table top", "table", Shape.BOX, middle, (1.2, 0.7, 0.04))
    room = replace(flight.room, solids=(*flight.room.solids, board))
    flight.pilot = make_pilot(flight.site, room, flight.grid)
    assert ("something hangs over the drone" in refused_take_off(flight)) is is_refused


def test_an_order_to_land_onto_somebody_waits_and_a_second_one_does_not(fly: Fly) -> None:
    flight = hovering(fly, (3.5, 2.5))
    person = Person((3.5, 3.4))
    flight.around = person.seen
    flight.run(0.2)
    outputs = flight.step(flight.order(OrderKind.LAND))
    assert outputs.command.setpoint.vz > -0.2
    flight.run(0.1)
    by_task = replace(flight.order(OrderKind.LAND), source=OrderSource.TASK)
    assert flight.step(by_task).command.setpoint.vz > -0.2  # a task never insists
    flight.run(0.1)
    assert flight.step(flight.order(OrderKind.LAND)).command.setpoint.vz < -0.2


def test_an_order_to_land_onto_what_only_the_sonar_shows_waits(fly: Fly) -> None:
    flight = hovering(fly, (3.5, 2.5))
    tell_height(flight, lambda z: 0.15)
    flight.run(0.1)
    assert flight.step(flight.order(OrderKind.LAND)).command.action is not Action.LAND
    flight.run(1.0)
    assert flight.told("landing_blocked") and flight.body.z > 1.0


def test_a_way_that_closes_again_and_again_is_not_told_every_tick(fly: Fly) -> None:
    flight = fly()
    flight.depart(4.0)
    x, y = flight.body.x + 0.9, flight.body.y + 0.9
    for tick in range(300):
        side = 0.35 if tick // 2 % 2 else -0.35
        flight.around = lambda f, side=side: (
            Obstacle("flicker", (x + side, y - side), 0.3, seen_at=f.now, source="laser"),
        )
        flight.step()
    told = [event for event in flight.events if event.code in ("way_blocked", "detour")]
    assert len(told) < 12
