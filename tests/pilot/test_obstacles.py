"""What stands in the way although no map shows it: the drone stops before it, goes around it, waits
for it, comes home.
"""

from __future__ import annotations

from collections.abc import Callable
from math import hypot
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.geometry import stopping_distance
from housefly.messages import (
    DroneStatus,
    Inputs,
    Obstacle,
    OrderKind,
    Outputs,
    Phase,
    SafetyMode,
)
from housefly.pilot import navigator
from housefly.pilot.assembly import make_pilot, warm_up
from housefly.pilot.behavior import mission_signals
from housefly.pilot.planning import live
from housefly.pilot.planning.obstacles import FREED_AFTER
from housefly.room.distance import half_diagonal

Fly = Callable[..., Any]
HULL = half_diagonal(0.517, 0.451)
PATIENCE = 6.0
"""Shorter than the pilot's own, so that the test is over sooner [s]."""
BRAKING = airframe_named("ardrone").braking
LATENCY = 0.1
"""From a decision of the pilot to the drone's attitude [s]: command delay and tracking latency."""


class Chair:
    """A chair that one sensor sees ten times a second while it stands there."""

    def __init__(self, place: tuple[float, float], radius: float = 0.25) -> None:
        self.place, self.radius = place, radius
        self.stands, self.since, self.velocity = True, None, (0.0, 0.0)
        self.closest = float("inf")

    def seen(self, flight: Any) -> tuple[Obstacle, ...]:
        if not self.stands:
            return ()
        if self.since is None:
            self.since = flight.now
        x, y = self.place
        vx, vy = self.velocity
        age = flight.now - self.since
        here = (x + vx * age, y + vy * age)
        self.closest = min(
            self.closest, hypot(flight.body.x - here[0], flight.body.y - here[1]) - self.radius
        )
        if round(flight.now * 100) % 10:
            return ()
        return (
            Obstacle(
                "chair",
                here,
                self.radius,
                velocity=self.velocity,
                seen_at=flight.now,
                source="laser",
            ),
        )


def ahead(flight: Any, metres: float) -> tuple[float, float]:
    """The place this far ahead of a flying drone."""
    b, speed = flight.body, flight.speed
    return b.x + b.vx / speed * metres, b.y + b.vy / speed * metres


def underway(fly: Fly, seconds: float = 4.0, **options: Any) -> Any:
    flight = fly(**options)
    flight.depart(seconds)
    assert flight.speed > 0.3
    return flight


def arrive(flight: Any, limit: float = 90.0) -> Outputs:
    return flight.until(lambda o: o.phase is Phase.HOLDING, limit)


@pytest.mark.parametrize(
    ("mode", "metres"),
    [
        *(("default", metres) for metres in (1.0, 2.5)),
        *(pytest.param("default", metres, marks=pytest.mark.safety) for metres in (1.2, 1.6)),
        ("paper", 2.5),
    ],
)
def test_a_chair_put_on_the_path_is_never_touched_and_the_drone_arrives(
    fly: Fly, mode: str, metres: float
) -> None:
    flight = underway(fly, mode=mode)
    chair = Chair(ahead(flight, metres))
    flight.around = chair.seen
    arrive(flight)
    assert chair.closest > HULL
    assert hypot(flight.body.x - 10.75, flight.body.y - 1.25) < (0.2 if mode == "default" else 0.6)
    assert flight.told("detour")
    assert flight.told("way_blocked") == (metres < 1.5)


def test_it_stops_within_one_stopping_distance_and_three_tenths_and_soon_has_a_new_way(
    fly: Fly,
) -> None:
    flight = underway(fly)
    chair = Chair(ahead(flight, 1.1))
    flight.around = chair.seen
    flight.until(lambda o: flight.told("way_blocked"), 0.2)
    start, speed, at = (flight.body.x, flight.body.y), flight.speed, flight.now
    flight.until(lambda o: flight.speed < 0.1, 2.0)
    stopped_at = flight.now
    way = hypot(flight.body.x - start[0], flight.body.y - start[1])
    assert way < stopping_distance(speed, BRAKING.deceleration, LATENCY) + 0.3 * speed
    assert stopped_at - at < 2.0 * speed / BRAKING.deceleration + 0.3
    flight.until(lambda o: not o.reason, 0.3)


def test_without_looking_it_flies_through_the_place_of_the_chair(fly: Fly) -> None:
    flight = underway(fly)
    chair = Chair(ahead(flight, 1.2))

    def unseen(flight: Any) -> tuple[Obstacle, ...]:
        chair.seen(flight)
        return ()

    flight.around = unseen
    arrive(flight)
    assert chair.closest < 0.0


def test_a_chair_that_fills_the_only_way_is_waited_for_in_words_and_flown_past_when_taken_away(
    fly: Fly,
) -> None:
    flight = underway(fly)
    chair = Chair((6.0, 3.5), radius=1.2)
    flight.around = chair.seen
    flight.until(lambda o: flight.told("no_way"), 10.0)
    place = (flight.body.x, flight.body.y)
    waiting = flight.run(8.0)
    assert waiting.phase is Phase.OUTBOUND
    assert "chair is in the way" in waiting.reason
    assert hypot(flight.body.x - place[0], flight.body.y - place[1]) < 0.3
    assert sum(event.code == "no_way" for event in flight.events) == 1
    chair.stands = False
    taken = flight.now
    flight.until(lambda o: not o.reason, FREED_AFTER + 0.5)
    assert flight.now - taken > 1.0
    arrive(flight)
    assert chair.closest > HULL


def test_a_source_that_says_that_a_thing_is_gone_frees_its_place_at_once(fly: Fly) -> None:
    flight = underway(fly)
    flight.around = Chair((6.0, 3.5), radius=1.2).seen
    flight.until(lambda o: flight.told("no_way"), 10.0)
    flight.around = lambda f: (
        Obstacle("chair", (6.0, 3.5), 1.2, confidence=0.0, seen_at=f.now, source="laser"),
    )
    flight.until(lambda o: not o.reason, 0.6)  # once it stands


def test_a_way_that_stays_blocked_is_given_up_for_home_and_a_way_home_for_landing(fly: Fly) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(mission_signals, "WAITING_TIMEOUT", PATIENCE)
        give_up_twice(underway(fly))


def give_up_twice(flight: Any) -> None:
    """Block a flight's way, and then its way home."""
    flight.around = Chair((6.0, 3.5), radius=1.2).seen
    flight.until(lambda o: flight.told("no_way"), 10.0)
    began = flight.now
    flight.until(lambda o: o.phase is Phase.RETURNING, PATIENCE + 15.0)
    assert flight.now - began > 0.8 * PATIENCE
    assert any("coming home" in event.text for event in flight.events)
    around = Chair((3.6, 2.5), radius=3.0)
    around.place = (flight.room.home[0] - 0.4, flight.room.home[1])
    around.radius = 1.0
    flight.around = around.seen
    flight.until(lambda o: o.phase is Phase.LANDING, PATIENCE + 25.0)
    flight.until(lambda o: flight.status is DroneStatus.LANDED, 10.0)
    assert around.closest > HULL


@pytest.mark.interop
def test_a_way_home_that_is_blocked_after_looking_is_waited_for(fly: Fly) -> None:
    flight = fly()
    flight.run(0.5)
    flight.step(flight.order(OrderKind.SERVICE, place="entrance", look_s=2.0))
    flight.until(lambda o: o.phase is Phase.LOOKING, 60.0)
    chair = Chair((6.0, 3.5), radius=1.2)
    flight.around = chair.seen
    flight.until(lambda o: flight.told("way_blocked"), 10.0)
    outputs = flight.run(5.0)
    assert outputs.phase is Phase.RETURNING and outputs.reason
    chair.stands = False
    flight.until(lambda o: o.phase is Phase.IDLE and flight.status is DroneStatus.LANDED, 60.0)
    assert flight.home_error < 0.2


def test_an_order_to_a_place_where_a_chair_stands_is_refused_in_words(fly: Fly) -> None:
    flight = fly()
    flight.around = Chair((10.75, 1.25)).seen
    flight.run(0.5)
    outputs = flight.step(flight.order(OrderKind.GO, place="entrance"))
    assert outputs.phase is Phase.IDLE
    assert any("obstacle" in event.text for event in outputs.events)


def test_somebody_who_crosses_the_path_is_let_past(fly: Fly) -> None:
    flight = underway(fly)
    x, y = ahead(flight, 2.2)
    walker = Chair((x, y - 1.5), radius=0.3)
    walker.velocity = (0.0, 0.6)
    flight.around = walker.seen
    arrive(flight)
    assert walker.closest > HULL


def test_stop_and_land_pass_while_it_waits(fly: Fly) -> None:
    for kind, sinks in ((OrderKind.STOP, False), (OrderKind.LAND, True)):
        flight = underway(fly)
        flight.around = Chair((6.0, 3.5), radius=1.2).seen
        flight.until(lambda o, flight=flight: flight.told("no_way"), 10.0)
        outputs = flight.step(flight.order(kind))
        assert (outputs.command.setpoint.vz < -0.2) is sinks
        assert sinks or outputs.safety is SafetyMode.STOPPED


def test_what_is_not_believable_is_refused_once_and_changes_nothing(fly: Fly) -> None:
    quiet, noisy = underway(fly), underway(fly)
    bad = (
        Obstacle("a", (float("nan"), 1.0), 0.3, source="x"),
        Obstacle("b", (3.0, 1.0), 99.0, source="x"),
        Obstacle("c", (3.0, 1.0), 0.3, confidence=7.0, source="x"),
        Obstacle("d", (3.0, 1.0), 0.3, velocity=(50.0, 0.0), source="x"),
        Obstacle("e", (3.0, 1.0), 0.3, seen_at=1e9, source="x"),
        Obstacle("f", (1e6, 1.0), 0.3, source="x"),
    )
    noisy.around = lambda f: bad
    for _ in range(150):
        assert noisy.step().command == quiet.step().command
    assert sum(event.code == "obstacle_refused" for event in noisy.events) == len(bad)


def test_warming_up_makes_a_map_with_obstacles_and_looks_along_a_path(
    fly: Fly, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiled = set()
    for function in (live.live_grid, live.first_block):

        def noted(*arguments: Any, function: Any = function) -> Any:
            compiled.update(
                {function.__name__}
                if any(isinstance(a, np.ndarray) and len(a) for a in arguments)
                else ()
            )
            return function(*arguments)

        monkeypatch.setattr(navigator, function.__name__, noted)
    flight = fly(map__planner="grid")
    warm_up(flight.site, flight.room, flight.grid)
    assert compiled == {"live_grid", "first_block"}


numbers = st.floats() | st.floats(-2.0, 14.0)
places = st.tuples(numbers, numbers)
obstacles = st.builds(
    Obstacle,
    id=st.sampled_from("abc"),
    position=places,
    radius=numbers,
    size=places,
    yaw=numbers,
    bottom=numbers,
    top=numbers,
    velocity=places,
    confidence=st.floats() | st.floats(0.0, 1.0),
    seen_at=numbers,
    source=st.sampled_from("xy"),
)


@settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(series=st.lists(st.lists(obstacles, max_size=3), min_size=1, max_size=10))
def test_any_obstacles_give_the_same_outputs_twice_and_never_an_error(
    fly: Fly, series: list[list[Obstacle]]
) -> None:
    flight = fly()
    flight.depart()
    one, two = (make_pilot(flight.site, flight.room, flight.grid) for _ in range(2))
    for tick, heard in enumerate(series):
        sightings = flight._look() if tick == 0 else ()
        orders = (flight.order(OrderKind.GO, place="entrance"),) if tick == 1 else ()
        now = flight.now + 0.05 * tick
        inputs = Inputs(sightings, flight.heard, orders, tuple(heard))
        assert one.step(now, inputs) == two.step(now, inputs)


put = st.tuples(
    st.floats(1.0, 20.0), st.floats(0.5, 12.0), st.floats(0.5, 4.5), st.floats(0.1, 0.5)
)


@pytest.mark.slow
@settings(max_examples=5, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(put, min_size=1, max_size=4))
def test_whatever_is_put_down_wherever_a_standing_thing_is_never_touched(
    fly: Fly, places: list[tuple[float, float, float, float]]
) -> None:
    flight = fly()
    flight.depart()
    start, chairs = flight.now, []
    flight.around = lambda f: tuple(
        Obstacle(str(n), seen.position, seen.radius, seen_at=seen.seen_at)
        for n, chair in enumerate(chairs)
        for seen in chair.seen(f)
    )
    waiting = sorted(places)
    while flight.now - start < 60.0 and flight.step().phase is not Phase.HOLDING:
        if waiting and flight.now - start > waiting[0][0]:
            _, x, y, radius = waiting.pop(0)
            if hypot(x - flight.body.x, y - flight.body.y) - radius > 0.8:
                chairs.append(Chair((x, y), radius))
    assert all(chair.closest > HULL for chair in chairs)
