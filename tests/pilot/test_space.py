"""Flight in space: the whole pilot on smooth trajectories, scored on the true course."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import dist, hypot
from typing import Any

import pytest

from housefly.messages import (
    Obstacle,
    ObstacleKind,
    OrderKind,
    Outputs,
    Phase,
    SafetyMode,
    Severity,
)
from housefly.pilot.behavior.trajectory_profile import SpacePath

Fly = Callable[..., Any]
SPACE: dict[str, object] = {"map__planner": "space", "limits__speed": 1.0}
STEP = 0.02


def watched(flight: Any, seconds: float, *orders: Any) -> list[Outputs]:
    """Return what the pilot said while it flew for so long."""
    said = [flight.step(*orders)]
    return said + [flight.step() for _ in range(round(seconds / STEP))]


def jumps(said: list[Outputs]) -> tuple[float, float]:
    """Return the largest jumps of the reference: in place, beyond its speed [m]; in speed [m/s]."""
    place, speed = 0.0, 0.0
    for before, after in pairwise(said):
        if before.reference is None or after.reference is None:
            continue
        moved = dist(before.reference.position, after.reference.position)
        fastest = max(hypot(*one.reference.velocity) for one in (before, after))
        place = max(place, moved - fastest * STEP)
        speed = max(speed, dist(before.reference.velocity, after.reference.velocity))
    return place, speed


def test_the_service_is_flown_on_its_curve_and_faster_than_on_corners(fly: Fly) -> None:
    times = {}
    for planner in ("grid", "space"):
        flight = fly(map__planner=planner, limits__speed=1.0)
        score = flight.service()
        assert score.rms < 0.03 and max(score.errors) < 0.1 and flight.home_error < 0.1
        assert all(event.severity is not Severity.FAULT for event in flight.events)
        times[planner] = flight.now
    assert times["space"] < 0.8 * times["grid"]


def test_a_path_in_space_has_heights_times_and_speeds_and_one_in_the_plane_has_none(
    fly: Fly,
) -> None:
    for planner in ("grid", "space"):
        flight = fly(map__planner=planner)
        path = flight.depart().path
        assert isinstance(path, SpacePath) == (planner == "space")
    count = len(path.waypoints)
    assert len(path.heights) == len(path.times) == len(path.speeds) == count
    assert list(path.times) == sorted(path.times) and path.speeds[0] == path.speeds[-1] == 0.0
    gaps = [dist(a, b) for a, b in pairwise(path.waypoints)]
    assert max(gaps) < 0.4 and path.waypoints[-1] == pytest.approx((10.75, 1.25))
    said = flight.until(lambda o: o.phase is Phase.HOLDING)
    assert said.waypoint == len(path.waypoints) - 1


def test_the_heading_never_holds_the_flight_up(fly: Fly) -> None:
    slow, free = ({**SPACE, "control__yaw_gain": gain} for gain in (0.1, 1.5))
    times = []
    for keys in (slow, free):
        flight = fly(**keys)
        flight.depart()
        flight.until(lambda o: o.phase is Phase.HOLDING)
        times.append(flight.now)
    assert times[0] == pytest.approx(times[1], abs=0.3)


def test_a_thing_in_the_way_is_flown_around_without_a_jump_of_the_reference(fly: Fly) -> None:
    flight = fly(**SPACE)
    flight.depart(1.5)
    flight.around = lambda f: (Obstacle("box", (7.2, 3.0), 0.3, seen_at=f.now),)
    said, nearest = [], 9.0
    while flight.outputs.phase is Phase.OUTBOUND and flight.now < 40.0:
        said.append(flight.step())
        nearest = min(nearest, dist((flight.body.x, flight.body.y), (7.2, 3.0)) - 0.3)
    assert flight.outputs.phase is Phase.HOLDING and flight.told("detour")
    assert nearest > 0.4
    place, speed = jumps(said)
    assert place < 0.01 and speed < 0.1
    assert {one.safety for one in said} == {SafetyMode.NOMINAL}


def test_where_there_is_no_way_it_stops_on_its_curve_and_goes_on_when_there_is(fly: Fly) -> None:
    flight = fly(**SPACE)
    flight.depart(1.5)
    flight.around = lambda f: tuple(
        Obstacle(f"box {n}", (6.9, 0.3 + 0.5 * n), 0.3, top=2.6, seen_at=f.now) for n in range(10)
    )
    said = watched(flight, 6.0)
    assert flight.speed < 0.1 and said[-1].reason and flight.outputs.phase is Phase.OUTBOUND
    place, speed = jumps(said)
    assert place < 0.01 and speed < 0.1
    assert flight.body.x + 0.35 < 6.6
    flight.around = lambda f: ()
    flight.until(lambda o: o.phase is Phase.HOLDING, 60.0)
    assert flight.body.x == pytest.approx(10.75, abs=0.15)


def test_a_hold_in_flight_stops_on_the_curve_and_a_new_goal_goes_on_from_there(fly: Fly) -> None:
    flight = fly(**SPACE)
    flight.depart(2.0)
    curve = flight.outputs.path.waypoints
    said = watched(flight, 2.5, flight.order(OrderKind.HOVER))
    assert flight.outputs.phase is Phase.HOLDING and flight.speed < 0.05
    assert min(dist(point, said[-1].reference.position[:2]) for point in curve) < 0.15
    said += watched(flight, 1.0, flight.order(OrderKind.GO, goal=(4.0, 3.5)))
    said += watched(flight, 6.0, flight.order(OrderKind.GO, goal=(2.5, 3.0)))
    place, speed = jumps(said)
    assert place < 0.01 and speed < 0.1
    assert (flight.body.x, flight.body.y) == pytest.approx((2.5, 3.0), abs=0.1)


def test_stop_and_resume_hold_the_drone_and_the_next_order_flies_on(fly: Fly) -> None:
    flight = fly(**SPACE)
    flight.depart(2.0)
    flight.step(flight.order(OrderKind.STOP))
    assert flight.run(2.0).safety is SafetyMode.STOPPED and flight.speed < 0.3
    flight.step(flight.order(OrderKind.RESUME))
    flight.run(2.0)
    flight.step(flight.order(OrderKind.GO, place="entrance"))
    flight.until(lambda o: o.phase is Phase.HOLDING)
    assert flight.body.x == pytest.approx(10.75, abs=0.1)


def test_a_low_wall_is_flown_over_at_the_height_that_is_told_and_watched(fly: Fly) -> None:
    flight = fly(**SPACE)
    flight.around = lambda f: (
        Obstacle(
            *("wall", (8.5, 2.5)),
            size=(0.2, 4.9),
            top=1.2,
            seen_at=f.now,
            kind=ObstacleKind.THING,
        ),
    )
    said = [flight.depart()]
    above = []
    while flight.outputs.phase is Phase.OUTBOUND and flight.now < 60.0:
        said.append(flight.step())
        if abs(flight.body.x - 8.5) < 0.3:
            above.append(flight.body.z)
            assert said[-1].reference.position[2] == pytest.approx(flight.body.z, abs=0.1)
    assert flight.outputs.phase is Phase.HOLDING and min(above) > 1.2 + 0.065 + 0.08
    assert flight.body.z == pytest.approx(1.1, abs=0.1)
    assert max(said[-2].path.heights) > 1.35 and {one.safety for one in said} == {
        SafetyMode.NOMINAL
    }


def test_the_drone_flies_slower_past_somebody_and_on_when_they_are_gone(fly: Fly) -> None:
    flight = fly(**SPACE)
    flight.depart(0.5)
    flight.around = lambda f: (
        Obstacle("somebody", (4.2, 2.9), 0.25, seen_at=f.now, kind=ObstacleKind.PERSON),
    )
    speeds, nearest = [], 9.0
    while flight.outputs.phase is not Phase.HOLDING and flight.now < 60.0:
        flight.step()
        away = dist((flight.body.x, flight.body.y), (4.2, 2.9)) - 0.25
        nearest = min(nearest, away)
        if away < flight.site.people.slow_distance:
            speeds.append(flight.speed)
    config = flight.site.people
    assert nearest > config.min_distance and flight.outputs.phase is Phase.HOLDING
    assert speeds and max(speeds) < 0.9


def test_somebody_who_walks_across_the_way_is_not_touched_and_it_does_not_flap(fly: Fly) -> None:
    flight = fly(**SPACE)
    flight.depart(0.3)
    begun = flight.now

    def walker(f: Any) -> tuple[Obstacle, ...]:
        y = 4.8 - 0.9 * (f.now - begun)
        if y < -0.5:
            return ()
        return (
            Obstacle(
                *("walker", (5.0, y), 0.25),
                velocity=(0.0, -0.9),
                seen_at=f.now,
                kind=ObstacleKind.PERSON,
            ),
        )

    flight.around, nearest = walker, 9.0
    paths: list[Any] = []
    while flight.outputs.phase is not Phase.HOLDING and flight.now < 60.0:
        flight.step()
        for one in walker(flight):
            nearest = min(nearest, dist((flight.body.x, flight.body.y), one.position) - 0.25)
        if not paths or paths[-1] is not flight.outputs.path:
            paths.append(flight.outputs.path)
    assert flight.outputs.phase is Phase.HOLDING and nearest > 0.35
    assert len(paths) < 12
