"""People who walk, and ways that open, on a trajectory in space; scored on the truth."""

from __future__ import annotations

import sys
from collections.abc import Callable
from itertools import pairwise
from math import dist, hypot
from typing import Any

import pytest
from numba.core.dispatcher import Dispatcher

from housefly.messages import Obstacle, ObstacleKind, Outputs, Phase
from housefly.pilot.assembly import warm_up
from housefly.pilot.behavior.trajectory_profile import SpacePath
from housefly.room.distance import half_diagonal

Fly = Callable[..., Any]
SPACE: dict[str, object] = {"map__planner": "space", "limits__speed": 1.0}
HULL, BODY = half_diagonal(0.517, 0.451), 0.25
ENTRANCE = (10.75, 1.25)
STEP = 0.02


class Walker:
    """Somebody who walks straight on from a place, from a time on and for so long."""

    def __init__(
        self,
        place: tuple[float, float],
        velocity: tuple[float, float],
        begin: float,
        duration: float = 1e9,
    ) -> None:
        self.place, self.velocity, self.begin, self.duration = place, velocity, begin, duration
        self.closest = 9.0

    def seen(self, flight: Any) -> tuple[Obstacle, ...]:
        since = flight.now - self.begin
        walked = min(max(since, 0.0), self.duration)
        (x, y), (vx, vy) = self.place, self.velocity
        at = (x + walked * vx, y + walked * vy)
        apart = dist((flight.body.x, flight.body.y), at) - BODY - HULL
        if at[1] < -0.5:
            return ()  # gone through the door
        self.closest = min(self.closest, apart)
        velocity = self.velocity if 0.0 <= since < self.duration else (0.0, 0.0)
        return (
            Obstacle(
                "walker",
                at,
                BODY,
                velocity=velocity,
                seen_at=flight.now,
                kind=ObstacleKind.PERSON,
            ),
        )


def arrived(flight: Any, limit: float = 60.0) -> list[Outputs]:
    """Return what the pilot said until it held its place at the goal."""
    said = []
    while flight.outputs.phase is not Phase.HOLDING and len(said) * STEP < limit:
        said.append(flight.step())
    assert flight.outputs.phase is Phase.HOLDING
    assert dist((flight.body.x, flight.body.y), ENTRANCE) < 0.2
    return said


def curves(said: list[Outputs]) -> int:
    """Return how many different ways were shown."""
    return len({one.path.waypoints for one in said if one.path is not None})


def smooth(said: list[Outputs]) -> bool:
    """Return whether the reference never jumped."""
    for before, after in pairwise(said):
        if before.reference is None or after.reference is None:
            continue
        fastest = max(hypot(*one.reference.velocity) for one in (before, after))
        moved = dist(before.reference.position, after.reference.position)
        changed = dist(before.reference.velocity, after.reference.velocity)
        if moved > fastest * STEP + 0.01 or changed > 0.1:
            return False
    return True


def test_who_crosses_is_waited_for_on_the_curve_that_was_planned(fly: Fly) -> None:
    flight = fly(**SPACE)
    flight.depart(0.3)
    walker = Walker((8.6, 4.8), (0.0, -0.8), flight.now + 2.9)
    flight.around = walker.seen
    said = arrived(flight)
    assert curves(said) == 1 and smooth(said)
    assert walker.closest > flight.site.people.min_distance
    held = [one for one in said if "walks into the way" in one.reason]
    assert held and flight.told("going_on") and not flight.told("making_way")
    assert 0.3 < len(held) * STEP < 6.0


def test_who_is_gone_before_the_drone_comes_does_not_change_its_way(fly: Fly) -> None:
    """On the ground that they cover within a second they would be in the way."""
    flight = fly(**SPACE)
    flight.depart(0.3)
    free = fly(**SPACE)
    free.depart(0.3)
    walker = Walker((9.5, 4.9), (0.0, -1.2), flight.now)
    flight.around = walker.seen
    said = arrived(flight)
    assert curves(said) == 1 and walker.closest > 1.0
    assert flight.now < len(arrived(free)) * STEP + free.now + 1.5
    assert not flight.told("way_blocked") and not flight.told("detour")


def test_the_times_of_the_path_that_is_shown_are_those_that_are_flown(fly: Fly) -> None:
    flight = fly(**SPACE)
    flight.depart(0.3)
    planned = flight.outputs.path.times[-1]
    walker = Walker((8.6, 4.8), (0.0, -0.8), flight.now + 2.9)
    flight.around = walker.seen
    said = arrived(flight)
    shown = said[-1].path
    assert isinstance(shown, SpacePath) and shown.waypoints == said[0].path.waypoints
    assert list(shown.times) == sorted(shown.times)
    assert shown.times[-1] > planned + 0.3
    last = next(n for n, one in enumerate(said) if one.waypoint == len(shown.waypoints) - 1)
    assert 0.3 + last * STEP == pytest.approx(shown.times[-2], abs=1.2)


def test_a_way_that_becomes_free_is_taken_in_flight_when_it_is_clearly_faster(fly: Fly) -> None:
    wall = tuple(Obstacle(f"box {n}", (8.6, 0.2 + 0.5 * n), 0.3, top=2.6) for n in range(6))

    def flown(goes: bool) -> tuple[Any, list[Outputs]]:
        flight = fly(**SPACE)
        flight.around = lambda f: tuple(
            Obstacle(one.id, one.position, one.radius, top=2.6, seen_at=f.now) for one in wall
        )
        flight.depart(3.0)
        if goes:
            flight.around = lambda f: ()
        return flight, arrived(flight)

    stayed, _ = flown(goes=False)
    flight, said = flown(goes=True)
    assert any("has become free" in event.text for event in flight.events)
    assert flight.now < stayed.now - 0.8
    assert curves(said) <= 3 and smooth(said)


def compiled_kinds() -> dict[str, int]:
    """Return for each compiled function of the pilot for how many kinds of arguments it is."""
    return {
        f"{module.__name__}.{name}": len(function.signatures)
        for module in tuple(sys.modules.values())
        if module is not None and module.__name__.startswith("housefly.pilot")
        for name, function in vars(module).items()
        if isinstance(function, Dispatcher)
    }


def test_after_warming_up_nothing_is_compiled_in_flight(fly: Fly) -> None:
    """It would stop the pilot for seconds."""
    flight = fly(**SPACE)
    warm_up(flight.site, flight.room, flight.grid)
    before = compiled_kinds()
    flight.depart(0.3)
    walker = Walker((8.6, 4.8), (0.0, -0.8), flight.now + 2.9)
    flight.around = lambda f: (
        *walker.seen(f),
        Obstacle("box", (7.6, 2.4), 0.3, seen_at=f.now),
    )
    arrived(flight)
    assert flight.told("detour")
    assert compiled_kinds() == before
