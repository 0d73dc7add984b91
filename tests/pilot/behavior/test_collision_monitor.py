"""When the collision monitor brakes, asks for another way, waits, and what it says, step by step.

Whole flights among obstacles: ``pilot/test_obstacles.py``.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any, cast

import pytest

from housefly.config.airframe import airframe_named
from housefly.messages import DroneStatus, Estimate, Event, OrderOutcome, Path, Phase
from housefly.messages.flight import OrderKind
from housefly.messages.words import Words
from housefly.pilot.behavior.collision_monitor import CollisionMonitor, braking_distance
from housefly.pilot.behavior.mission import (
    Mission,
    MissionState,
    Refused,
    TrackingTask,
    VehicleStatus,
)
from housefly.pilot.behavior.navigator import PathBlock
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.behavior.proposal import Look, MissionChange, Proposal

PATH = Path(((0.0, 0.0), (4.0, 0.0), (4.0, 3.0)), 7.0, 0.5)
FOLLOWING = TrackingTask(profile=cast(Any, object()), path=PATH)
PATIENCES = (0.0, 0.5, 1.0, 2.0, 4.0, 4.0)
BRAKING = airframe_named("ardrone").braking
TICK = 1 / 64


class ScriptedWays:
    """A mission and its navigator whose way is blocked where, and free again when, it is told."""

    def __init__(self) -> None:
        self.state, self.task = MissionState(phase=Phase.OUTBOUND), FOLLOWING
        self.blocked_at: float | None = None
        self.refusal: Refused | None = Refused(OrderOutcome.NO_WAY, "none")
        self.asked: list[float] = []
        self.looked_from: list[int] = []

    def other_way(self, vehicle: VehicleStatus) -> TrackingTask | Refused:
        self.asked.append(vehicle.now)
        return replace(FOLLOWING) if self.refusal is None else self.refusal

    def halted(self, vehicle: VehicleStatus) -> TrackingTask:
        return TrackingTask()

    def block(self, place: object, path: Path, waypoint: int) -> PathBlock | None:
        self.looked_from.append(waypoint)
        return None if self.blocked_at is None else PathBlock(self.blocked_at, "chair")

    def is_passing(self, place: object, goal: object) -> bool:
        return self.refusal is not None

    def home(self) -> Mission:
        return Mission(OrderKind.HOME, goal=(0.0, 0.0))


class Watch:
    """A monitor over scripted ways, and what it said."""

    def __init__(self) -> None:
        self.ways, self.now, self.said = ScriptedWays(), 10.0, list[Event]()
        both = cast(Any, self.ways)
        self.monitor = CollisionMonitor(both, both, BRAKING)

    def vehicle(self, speed: float = 0.0, climb: float = 0.0) -> VehicleStatus:
        estimate = Estimate(self.now, (1.0, 0.0, 1.0), (speed, 0.0, climb), 0.0, 0.0, 0.01)
        return VehicleStatus(self.now, DroneStatus.FLYING, 0.9, 0.0, estimate, False)

    def fly(self, seconds: float = TICK, speed: float = 0.0, climb: float = 0.0) -> list[Event]:
        """Return what is said in so many seconds."""
        said = []
        for _ in range(round(seconds / TICK)):
            self.now += TICK
            said += self.look(self.vehicle(speed, climb))
        return said

    def look(
        self,
        vehicle: VehicleStatus,
        target: TrajectorySetpoint | None = None,
        *,
        silent: bool = False,
    ) -> tuple[Event, ...]:
        """Do what the monitor proposes, and return what is said."""
        return self.done(self.monitor.propose(Look(vehicle, target, silent)))

    def done(self, proposal: Proposal) -> tuple[Event, ...]:
        self.ways.task = proposal.task or self.ways.task
        self.ways.state = proposal.state or self.ways.state
        return proposal.events

    def waits_instead(self, vehicle: VehicleStatus) -> bool:
        proposal = self.monitor.waiting_instead(Words("closed"), vehicle)
        self.done(proposal)
        return proposal.change is MissionChange.HOLD


@pytest.fixture
def watch() -> Watch:
    return Watch()


def test_it_brakes_at_its_stopping_distance_and_three_tenths() -> None:
    assert [braking_distance(speed, BRAKING) for speed in (0.0, 1.0, 2.0)] == pytest.approx(
        [0.3, 1.1, 2.9]
    )


def test_a_block_far_ahead_is_gone_around_and_told_once_in_two_seconds(watch: Watch) -> None:
    watch.ways.blocked_at, watch.ways.refusal = 3.0, None
    first = watch.fly()
    assert [(event.code, event.text) for event in first] == [
        ("detour", "chair is in the way: going around")
    ]
    assert watch.fly(1.5) == [] and len(watch.ways.asked) == 1 + round(1.5 / 0.25)
    apart = [late - early for early, late in pairwise(watch.ways.asked)]
    assert apart == pytest.approx([0.25] * len(apart))
    watch.ways.blocked_at = None
    assert watch.fly(2.0) == []
    watch.ways.blocked_at = 3.0
    assert [event.code for event in watch.fly()] == ["detour"]


def test_one_at_its_braking_distance_stops_it_at_once_and_so_does_one_without_a_way_around(
    watch: Watch,
) -> None:
    watch.ways.blocked_at, watch.ways.refusal = braking_distance(1.0, BRAKING), None
    assert [event.text for event in watch.fly(speed=1.0)] == [
        "chair is in the way, 1.1 m ahead: stopping"
    ]
    assert watch.ways.task.waiting and not watch.ways.asked
    other = Watch()
    other.ways.blocked_at = 3.0
    assert [event.code for event in other.fly(speed=1.0)] == ["way_blocked"]
    assert other.ways.asked and other.ways.task.waiting


def test_it_asks_for_another_way_once_it_stands_by_its_speed_in_the_plane(watch: Watch) -> None:
    watch.ways.blocked_at = 0.2
    watch.fly(speed=0.5)
    stopped = watch.now
    assert watch.fly(1.0, speed=0.1) == [] and not watch.ways.asked
    (told,) = watch.fly(0.1, speed=0.09, climb=0.6)
    assert told.code == "no_way" and "no way on, waiting here: none" in told.text
    assert watch.fly(1.0) == []
    waits = [late - early for early, late in pairwise(watch.ways.asked)]
    assert watch.ways.asked[0] > stopped + 0.9 and waits == pytest.approx([0.25] * len(waits))


def test_one_that_never_seems_to_stand_is_taken_to_after_one_and_a_half_seconds(
    watch: Watch,
) -> None:
    watch.ways.blocked_at = 0.2
    watch.fly(speed=0.5)
    stopped = watch.now
    watch.fly(1.5, speed=0.3)
    assert not watch.ways.asked
    watch.fly(speed=0.3)
    assert watch.ways.asked == [pytest.approx(stopped + 1.5 + TICK)]


def test_ways_that_are_blocked_again_at_once_are_waited_for_longer_each_time(
    watch: Watch,
) -> None:
    for patience in PATIENCES:
        watch.ways.blocked_at, watch.ways.refusal = 0.2, None
        assert [event.code for event in watch.fly()] == ["way_blocked"]
        stopped, before = watch.now, len(watch.ways.asked)
        while len(watch.ways.asked) == before:
            told = watch.fly()
        assert watch.now - stopped == pytest.approx(max(patience, TICK), abs=TICK)
        assert [(event.code, event.text) for event in told] == [
            ("detour", "there is a way: going on")
        ]
    watch.ways.blocked_at = None
    watch.fly(2.0)
    watch.ways.blocked_at = 0.2
    watch.fly()
    before = len(watch.ways.asked)
    watch.fly(2 * TICK)
    assert len(watch.ways.asked) > before


@pytest.mark.parametrize(
    "changes", [{"phase": Phase.LOOKING}, {"stopped": True}, {"phase": Phase.HOLDING}]
)
def test_it_looks_on_the_way_only(watch: Watch, changes: dict[str, Any]) -> None:
    watch.ways.blocked_at = 0.2
    watch.ways.state = replace(watch.ways.state, **changes)
    assert watch.fly(1.0) == [] and not watch.ways.looked_from


def test_it_looks_from_the_waypoint_that_is_flown_to_and_not_while_it_makes_way(
    watch: Watch,
) -> None:
    for waypoint in (1, 7):
        target = cast(TrajectorySetpoint, type("At", (), {"waypoint": waypoint}))
        watch.look(watch.vehicle(), target)
        watch.look(watch.vehicle(), target, silent=True)
    watch.ways.task = replace(FOLLOWING, profile=cast(Any, object()))
    watch.look(watch.vehicle(), target)
    watch.ways.task = replace(watch.ways.task)
    watch.look(watch.vehicle(), target)
    assert watch.ways.looked_from == [1, 2, 0, 2]
    watch.ways.task = TrackingTask()
    assert watch.fly() == [] and len(watch.ways.looked_from) == 4


def test_a_new_phase_waits_for_a_way_only_where_what_is_there_now_closes_it(watch: Watch) -> None:
    assert not watch.waits_instead(watch.vehicle())  # nowhere to go
    watch.ways.state = replace(watch.ways.state, phase=Phase.RETURNING)
    assert watch.waits_instead(watch.vehicle())
    assert watch.ways.task.waiting == "closed"
    assert watch.fly(1.0) == []  # the reason was told with the phase
    assert watch.ways.asked[0] - 10.0 == pytest.approx(0.25)
    watch.ways.refusal = None  # a wall, not somebody
    assert not watch.waits_instead(watch.vehicle())
    nowhere = replace(watch.vehicle(), estimate=None)
    assert not watch.waits_instead(nowhere)
    assert watch.look(nowhere) == ()
