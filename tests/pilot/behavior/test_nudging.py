"""A drone that is moved by hand: the whole pilot in its loop, scored on the true course."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import dist, hypot
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.bus.codec import from_cdr, to_cdr
from housefly.config.airframe import airframe_named
from housefly.geometry import Vec3
from housefly.messages import (
    Inputs,
    Obstacle,
    ObstacleKind,
    OrderKind,
    Outputs,
    Phase,
    PilotStep,
    SafetyMode,
)
from housefly.pilot.assembly import make_pilot
from housefly.pilot.behavior.nudging import NUDGE_LIFETIME
from housefly.pilot.navigator import RoomNavigator
from housefly.room.distance import half_diagonal

Fly = Callable[..., Any]
BY_HAND: dict[str, object] = {"map__planner": "space", "limits__nudge_speed": 0.5}
HULL = half_diagonal(0.517, 0.451)
EAST, WEST, NORTH, UP = (0.5, 0.0, 0.0), (-0.5, 0.0, 0.0), (0.0, 0.5, 0.0), (0.0, 0.0, 0.5)
BLOCK = 5.75
"""Where the block in the hall begins along x [m], at y below 2 m."""


def hold(
    flight: Any, velocity: Vec3, seconds: float, age: float = 0.0, sender: str = "Ann"
) -> list[float]:
    """Hold a velocity as a page does, ten times a second; return the largest x of each step."""
    xs = []
    each = round(0.1 / flight.tick)
    for n in range(round(seconds / flight.tick)):
        given_at = flight.now - age
        nudge = flight.order(OrderKind.NUDGE, velocity=velocity, sender=sender)
        nudge = type(nudge)(nudge.kind, velocity=velocity, sender=sender, issued_at=given_at)
        flight.step(*((nudge,) if n % each == 0 else ()))
        xs.append(flight.body.x)
    return xs


def here(flight: Any) -> Vec3:
    return flight.body.x, flight.body.y, flight.body.z


def codes(flight: Any) -> list[str]:
    return [event.code for event in flight.events]


def refusals(flight: Any) -> list[str]:
    return [event.text for event in flight.events if event.code == "order_refused"]


@pytest.fixture
def hovering(fly: Fly) -> Any:
    flight = fly(**BY_HAND)
    flight.take_off()
    return flight


def test_it_moves_while_a_key_is_held_and_rests_where_it_is_let_go(hovering: Any) -> None:
    start = here(hovering)
    hold(hovering, EAST, 4.0)
    assert hovering.speed == pytest.approx(0.5, abs=0.06)
    let_go = here(hovering)
    assert let_go[0] - start[0] > 1.4
    said = [hovering.step() for _ in range(300)]
    longest = NUDGE_LIFETIME * 0.5 + airframe_named("ardrone").braking.way_to_rest(0.5)
    assert dist(let_go, here(hovering)) < longest and hovering.speed < 0.03
    assert abs(hovering.body.y - start[1]) < 0.05 and abs(hovering.body.z - start[2]) < 0.05
    assert said[-1].phase is Phase.HOLDING and said[-1].safety is SafetyMode.NOMINAL


def test_the_reference_never_jumps_whatever_is_pressed(hovering: Any) -> None:
    said = []
    for velocity in (EAST, NORTH, WEST, (0.3, -0.3, 0.3), UP, (0.0, -0.5, -0.5)):
        for n in range(70):
            nudge = hovering.order(OrderKind.NUDGE, velocity=velocity)
            said.append(hovering.step(*((nudge,) if n % 5 == 0 else ())))
    for before, after in pairwise(said[1:]):
        moved = dist(before.reference.position, after.reference.position)
        assert moved < hovering.tick * 0.55
        assert dist(before.reference.velocity, after.reference.velocity) < 2.0 * hovering.tick
    assert all(one.safety is SafetyMode.NOMINAL for one in said)


def test_one_line_says_that_it_began_and_one_that_it_ended(hovering: Any) -> None:
    before = len(hovering.events)
    for _ in range(3):
        hold(hovering, EAST, 0.5)
        hovering.run(0.8)
    hovering.run(4.0)
    told = [event.text for event in hovering.events[before:]]
    assert told == ["moved by hand by Ann", "moved by hand no longer"]


def test_who_goes_on_in_anothers_place_is_told(hovering: Any) -> None:
    before = len(hovering.events)
    hold(hovering, EAST, 0.5)
    hold(hovering, EAST, 0.5, sender="Ben")
    told = [event.text for event in hovering.events[before:]]
    assert told == ["moved by hand by Ann", "moved by hand by Ben"]


def test_an_order_that_was_held_up_is_nothing(hovering: Any) -> None:
    start, before = here(hovering), len(hovering.events)
    hold(hovering, EAST, 2.0, age=NUDGE_LIFETIME + 0.02)
    hold(hovering, EAST, 2.0, age=-NUDGE_LIFETIME - 0.05)
    hovering.run(1.0)
    assert dist(start, here(hovering)) < 0.06 and hovering.events[before:] == []


def test_an_order_counts_from_when_it_was_given_not_from_when_it_came(hovering: Any) -> None:
    rests = []
    for age in (0.0, 0.25):
        hold(hovering, EAST, 2.0)
        hovering.run(3.0)
        start = hovering.body.x
        hold(hovering, EAST, hovering.tick, age=age)
        hovering.run(3.0)
        rests.append(hovering.body.x - start)
        hold(hovering, WEST, 2.0)
        hovering.run(3.0)
    assert rests[0] > 0.06 and rests[1] < 0.5 * rests[0]


REFUSED: list[tuple[dict[str, object], Callable[[Any], object], str]] = [
    ({"limits__nudge_speed": 0.0}, lambda f: f.take_off(), "limits.nudge_speed"),
    ({"map__planner": "grid"}, lambda f: f.take_off(), "map.planner"),
    ({"mode": "paper"}, lambda f: f.take_off(), "map.planner"),
    ({}, lambda f: f.run(0.5), "on the ground"),
    ({}, lambda f: rising(f), "taking off"),
    ({}, lambda f: f.depart(1.0), "press Hover first"),
    ({}, lambda f: ordered(f, OrderKind.LAND), "landing"),
    ({}, lambda f: ordered(f, OrderKind.STOP), "resume first"),
    ({}, lambda f: ordered(f, OrderKind.HOME), "press Hover first"),
]


def rising(flight: Any) -> None:
    flight.run(0.5)
    flight.step(flight.order(OrderKind.TAKE_OFF))


def ordered(flight: Any, kind: OrderKind) -> None:
    flight.take_off()
    hold(flight, EAST, 2.0)
    flight.step(flight.order(kind))


@pytest.mark.parametrize(("keys", "before", "words"), REFUSED)
def test_it_is_refused_with_words_where_it_may_not_be(
    fly: Fly, keys: dict[str, object], before: Callable[[Any], object], words: str
) -> None:
    flight = fly(**{**BY_HAND, **keys})
    before(flight)
    assert refusals(flight) == []
    flight.step(flight.order(OrderKind.NUDGE, velocity=EAST))
    assert words in refusals(flight)[-1]
    begun = codes(flight).count("nudge_began")
    flight.run(0.5)
    assert codes(flight).count("nudge_began") == begun


@pytest.mark.parametrize("velocity", [None, (float("nan"), 0.0, 0.0), (1e9, 0.0, 0.0)])
def test_a_velocity_that_is_none_is_refused(hovering: Any, velocity: Any) -> None:
    start = here(hovering)
    hovering.step(hovering.order(OrderKind.NUDGE, velocity=velocity))
    hovering.run(1.0)
    assert "velocity is wrong" in refusals(hovering)[-1]
    assert dist(start, here(hovering)) < 0.05


def test_another_order_ends_it_at_once(hovering: Any) -> None:
    hold(hovering, EAST, 2.0)
    hovering.step(hovering.order(OrderKind.HOVER))
    hovering.run(3.0)
    assert codes(hovering)[-1] == "nudge_ended" and hovering.speed < 0.03
    hold(hovering, WEST, 1.0)
    hovering.step(hovering.order(OrderKind.GO, place="entrance"))
    assert hovering.run(0.3).phase is Phase.OUTBOUND
    assert codes(hovering)[-1] == "nudge_ended"


def test_who_moves_it_by_hand_keeps_it_from_coming_home_and_no_longer(fly: Fly) -> None:
    flight = fly(**BY_HAND, limits__hold_timeout=5.0)
    flight.take_off()
    for _ in range(4):
        hold(flight, EAST, 1.0)
        hold(flight, WEST, 1.0)
    assert flight.outputs.phase is Phase.HOLDING
    assert flight.until(lambda o: o.phase is not Phase.HOLDING, 7.0).phase is Phase.RETURNING


def test_a_held_key_stops_before_a_wall_and_without_the_look_it_strikes(
    fly: Fly, monkeypatch: pytest.MonkeyPatch
) -> None:
    nearest = []
    for looks in (True, False):
        if not looks:
            monkeypatch.setattr(RoomNavigator, "closed", lambda *_: "")
        flight = fly(**BY_HAND)
        flight.take_off()
        xs = hold(flight, EAST, 8.0)
        nearest.append(BLOCK - HULL - max(xs))
        if looks:
            limited = [e.text for e in flight.events if e.code == "nudge_limited"]
            assert limited == ["moved by hand: a wall or furniture is ahead"]
            assert flight.speed < 0.06
    assert nearest[0] > 0.1
    assert nearest[1] < 0.0


def test_along_a_wall_it_slides(hovering: Any) -> None:
    hold(hovering, EAST, 8.0)
    y = hovering.body.y
    hold(hovering, (0.35, 0.35, 0.0), 2.0)
    assert hovering.body.y > y + 0.3 and hovering.body.x < BLOCK - HULL - 0.1


def test_it_climbs_and_sinks_within_the_heights_that_are_planned_at(hovering: Any) -> None:
    limits = hovering.site.limits
    hold(hovering, UP, 6.0)
    assert limits.height_max - 0.3 < hovering.body.z < limits.height_max
    hold(hovering, (0.0, 0.0, -0.5), 8.0)
    assert limits.height_min < hovering.body.z < limits.height_min + 0.3
    assert hovering.outputs.safety is SafetyMode.NOMINAL


def test_it_enters_no_volume_to_keep_out_of(fly: Fly) -> None:
    zone = {"kind": "keep_out", "polygon": [[3, 0], [4, 0], [4, 5], [3, 5]]}
    flight = fly(**BY_HAND, volumes=[zone])
    flight.take_off()
    assert max(hold(flight, EAST, 6.0)) < 3.0 + 0.06  # half a voxel, as ways
    assert "nudge_limited" in codes(flight)


def test_in_a_slow_volume_it_is_slow(fly: Fly) -> None:
    zone = {"kind": "slow", "speed": 0.2, "polygon": [[2.8, 0], [9, 0], [9, 5], [2.8, 5]]}
    flight = fly(**BY_HAND, volumes=[zone])
    flight.take_off()
    speeds = []
    for _ in range(40):
        hold(flight, EAST, 0.2)
        speeds.append((flight.body.x, flight.speed))
    assert max(speed for x, speed in speeds if x < 2.5) > 0.3
    assert max(speed for x, speed in speeds if x > 2.9) < 0.26
    assert flight.body.x > 3.5


def test_what_is_recorded_of_it_is_replayed_bit_for_bit(fly: Fly) -> None:
    flight = fly(**BY_HAND)
    taken: list[bytes] = []
    step = flight.pilot.step

    def recorded(now: float, inputs: Inputs) -> Outputs:
        outputs: Outputs = step(now, inputs)
        taken.append(to_cdr(PilotStep(len(taken), now, inputs, outputs)))
        return outputs

    flight.pilot.step = recorded
    flight.take_off()
    hold(flight, EAST, 2.0)
    flight.run(1.0)
    again = make_pilot(flight.site, flight.room, flight.grid)
    for data in taken:
        was = from_cdr(PilotStep, data)
        assert again.step(was.now, was.inputs) == was.outputs


def somebody(place: tuple[float, float], velocity: tuple[float, float] = (0.0, 0.0)) -> Any:
    def around(flight: Any) -> tuple[Obstacle, ...]:
        at = (place[0] + velocity[0] * flight.now, place[1] + velocity[1] * flight.now)
        flight.nearest = min(
            getattr(flight, "nearest", 9.0), dist(at, (flight.body.x, flight.body.y)) - 0.25 - HULL
        )
        person = ObstacleKind.PERSON
        return (Obstacle("Eve", at, 0.25, velocity=velocity, seen_at=flight.now, kind=person),)

    return around


def test_it_is_not_pushed_nearer_to_somebody_than_the_comfort_distance(fly: Fly) -> None:
    flight = fly(**BY_HAND)
    flight.take_off()
    flight.around = somebody((4.6, 1.25))
    hold(flight, EAST, 8.0)
    assert flight.nearest > flight.site.people.comfort_distance - 0.06
    assert "moved by hand: Eve is near" in [event.text for event in flight.events]
    x = flight.body.x
    hold(flight, WEST, 1.5)
    assert flight.body.x < x - 0.1  # away from her it goes


def test_somebody_who_comes_is_made_way_for_whatever_is_held(fly: Fly) -> None:
    flight = fly(**BY_HAND)
    flight.take_off()
    flight.around = somebody((12.0, 2.6), (-0.9, 0.0))
    hold(flight, (0.4, 0.15, 0.0), 10.0)
    assert "making_way" in codes(flight)
    assert flight.nearest > 0.1


def test_while_the_gate_holds_it_nothing_moves(fly: Fly) -> None:
    flight = fly(**BY_HAND, tracking={"gaps": ((9.0, 10.2),)})
    flight.take_off()
    hold(flight, EAST, 9.8 - flight.now)
    reference = flight.outputs.reference.position
    hold(flight, EAST, 0.3)
    assert flight.outputs.safety is SafetyMode.HOLD
    assert dist(reference, flight.outputs.reference.position) < 0.005
    hold(flight, EAST, 1.5)
    assert flight.speed > 0.3


def test_a_gate_that_holds_it_for_another_reason_is_obeyed_too(hovering: Any) -> None:
    hold(hovering, EAST, 2.0)
    hovering.late = 0.3
    hovering.step()
    hovering.late = 0.0
    hold(hovering, EAST, 0.9)
    assert hovering.outputs.safety is SafetyMode.HOLD
    assert hypot(*hovering.outputs.reference.velocity) < 0.01


@settings(max_examples=8, deadline=None, suppress_health_check=list(HealthCheck))
@given(
    keys=st.lists(
        st.tuples(*[st.sampled_from((-0.5, 0.0, 0.5))] * 3, st.sampled_from((0.2, 0.7, 1.5, 3.0))),
        min_size=3,
        max_size=7,
    )
)
def test_whatever_is_held_the_hull_touches_nothing(
    fly: Fly, keys: list[tuple[float, float, float, float]]
) -> None:
    flight = fly(**BY_HAND)
    flight.take_off()
    for vx, vy, vz, seconds in keys:
        hold(flight, (vx, vy, vz), seconds)
        x, y = flight.body.x, flight.body.y
        block = hypot(max(abs(x - 6.0) - 0.25, 0.0), max(y - 2.0, 0.0))
        walls = min(x, 12.5 - x, y, 5.0 - y)
        assert min(block, walls) - HULL > 0.05
        assert flight.outputs.safety is SafetyMode.NOMINAL
