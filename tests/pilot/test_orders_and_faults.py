"""Any orders in any order, while tracking, drone and loop fail at any moment.

A state machine plays people, tasks and bad luck against the pure step, and scores every step on
the truth. `make test` plays a few short stories, `make safety` many long ones.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import inf, isfinite, nan, pi
from typing import Any, ClassVar

import pytest
from hypothesis import HealthCheck, settings
from hypothesis import Phase as Phases
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    precondition,
    rule,
    run_state_machine_as_test,
)

from housefly.geometry import quaternion_from_euler
from housefly.messages import (
    Action,
    DroneFault,
    DroneStatus,
    Obstacle,
    Order,
    OrderKind,
    Outputs,
    Phase,
    SafetyMode,
    Sighting,
)

Fly = Callable[..., Any]
MOVING_ORDERS = (OrderKind.TAKE_OFF, OrderKind.GO, OrderKind.SERVICE, OrderKind.HOME)
ODD_NUMBERS = st.sampled_from([nan, inf, -inf, 1e308, -1e308, 5e-324, -0.0, 1e4, 2.0, 6.0])
PLACES = st.sampled_from(["entrance", "home", "nowhere", "", "\0", "x" * 500, "../.."])
GOALS = st.none() | st.tuples(ODD_NUMBERS, ODD_NUMBERS) | st.just((4.0, 3.5))
PAUSES = st.sampled_from([0.02, 0.1, 0.5, 1.0, 2.5, 5.0])
ODD_REPORTS: tuple[dict[str, Any], ...] = (
    {"battery": nan},
    {"battery": 0.05},
    {"battery": -3.0},
    {"height": nan},
    {"height": 1e9},
    {"velocity": (inf, nan, 0.0)},
    {"phi": nan, "theta": inf},
    {"phi": pi},
    {"acceleration": (1e308, 0.0, nan)},
    {"faults": (DroneFault.MOTORS_PROBLEM,)},
    {"notes": ("ultrasound deaf",)},
    {"configured": False},
    {"received_at": inf},
    {"received_at": nan},
    {"status": DroneStatus.LANDED},
    {"status": DroneStatus.FLYING},
    {"status": DroneStatus.EMERGENCY},
)
ODD_SIGHTINGS: dict[str, Callable[[Sighting], Sighting]] = {
    "nan": lambda s: replace(s, pose=replace(s.pose, position=(nan, 0.0, 1.0))),
    "far": lambda s: replace(s, pose=replace(s.pose, position=(1e308, -1e308, 1.0))),
    "jump": lambda s: _moved(s, 1.0, 0.0),
    "high": lambda s: _moved(s, 0.0, 0.6),
    "turned": lambda s: replace(
        s, pose=replace(s.pose, orientation=quaternion_from_euler(0.0, 0.0, 2.5))
    ),
    "no rotation": lambda s: replace(s, pose=replace(s.pose, orientation=(0.0,) * 4)),
    "future": lambda s: replace(s, captured_at=s.captured_at + 1e6),
    "past": lambda s: replace(s, captured_at=-1e6),
    "no time": lambda s: replace(s, captured_at=nan, received_at=nan),
    "other body": lambda s: replace(s, body="chair"),
}


def _moved(sighting: Sighting, aside: float, up: float) -> Sighting:
    x, y, z = sighting.pose.position
    return replace(sighting, pose=replace(sighting.pose, position=(x + aside, y, z + up)))


RESCUES = {SafetyMode.STOPPED, SafetyMode.LAND, SafetyMode.DESCEND}
"""In these our setpoint keeps the place, or sinks."""


class OrdersAndFaults(RuleBasedStateMachine):
    """A flight, and what must hold of it whatever happens."""

    fly: ClassVar[Fly]

    @initialize(mode=st.sampled_from(["default", "default", "paper"]), seed=st.integers(1, 99))
    def begin(self, mode: str, seed: int) -> None:
        """Switch everything on."""
        self.flight = type(self).fly(mode=mode, seed=seed)
        self.limits = self.flight.site.limits
        self.ordered = self.cut = self.was_cut = self.stopped = False
        self.odd_sighting = self.odd_report = None
        look, report = self.flight._look, self.flight.report
        self.flight._look = lambda: tuple(map(self.odd_sighting or _same, look()))
        self.flight.report = lambda: replace(report(), **(self.odd_report or {}))
        self.wait(0.5)

    # --- what people and tasks do

    @rule(kind=st.sampled_from(OrderKind), pause=PAUSES)
    def order_plainly(self, kind: OrderKind, pause: float) -> None:
        """Order something that makes sense."""
        place = "entrance" if kind in (OrderKind.GO, OrderKind.SERVICE) else ""
        self.give(self.flight.order(kind, place=place, look_s=0.5))
        self.wait(pause)

    @rule(
        kind=st.sampled_from(OrderKind), place=PLACES, goal=GOALS, look=ODD_NUMBERS, at=ODD_NUMBERS
    )
    def order_nastily(self, kind: OrderKind, place: str, goal: Any, look: float, at: float) -> None:
        """Order something that makes none, or too late."""
        self.give(Order(kind, place, goal, None, look, at, place), self.flight.order(kind))

    @rule(kinds=st.lists(st.sampled_from(OrderKind), min_size=2, max_size=6))
    def order_all_at_once(self, kinds: list[OrderKind]) -> None:
        """Several people order at the same instant."""
        self.give(*(self.flight.order(kind, place="entrance") for kind in kinds))

    @rule(pause=PAUSES)
    def let_it_fly(self, pause: float) -> None:
        """Do nothing."""
        self.wait(pause)

    # --- what fails

    @rule(seconds=st.sampled_from([0.2, 1.0, 3.0, 1e9]))
    def tracking_goes(self, seconds: float) -> None:
        """Tracking is gone for a while, or for good."""
        self.flight.tracking.gaps = ((self.flight.now, self.flight.now + seconds),)

    @rule(how=st.sampled_from(sorted(ODD_SIGHTINGS)), pause=PAUSES)
    def tracking_lies(self, how: str, pause: float) -> None:
        """Tracking says what cannot be."""
        self.odd_sighting = ODD_SIGHTINGS[how]
        self.wait(min(pause, 1.0))

    @rule(report=st.sampled_from(ODD_REPORTS), pause=PAUSES)
    def drone_reports_oddly(self, report: dict[str, Any], pause: float) -> None:
        """The drone says what cannot be, or what is not so."""
        self.odd_report = report
        self.wait(min(pause, 1.0))

    @rule()
    def drone_falls_silent(self) -> None:
        """The drone is not heard any more."""
        self.flight.talks = False

    @rule(late=st.sampled_from([0.02, 0.3, 1.5, nan, -1.0, inf]))
    def loop_is_late(self, late: float) -> None:
        """One step comes late."""
        self.flight.late = late
        self.wait(0.02)
        self.flight.late = 0.0

    @rule(distance=st.floats(0.3, 2.0), speed=st.floats(-1.5, 1.5))
    def somebody_comes(self, distance: float, speed: float) -> None:
        """Somebody or something stands or walks near the drone."""
        x, y, begun = self.flight.body.x + distance, self.flight.body.y, self.flight.now

        def around(flight: Any) -> tuple[Obstacle, ...]:
            at = x + speed * (flight.now - begun)
            return (
                Obstacle("1", (at, y), 0.3, velocity=(speed, 0.0), seen_at=flight.now, source="a"),
            )

        self.flight.around = around

    @rule(force=st.floats(-2.0, 2.0))
    def wind_blows(self, force: float) -> None:
        """A fan is switched on or off [m/s^2]."""
        self.flight.wind = (force, 0.0)

    @precondition(lambda self: self.odd_sighting or self.odd_report or not self.flight.talks)
    @rule()
    def all_is_well_again(self) -> None:
        """Every fault ends."""
        self.mend()

    # --- what holds

    def give(self, *orders: Order) -> None:
        """Give orders in one step."""
        self.was_cut |= any(order.kind is OrderKind.CUT for order in orders)
        self.ordered |= any(order.kind in MOVING_ORDERS for order in orders)
        self.check(self.flight.step(*orders), orders)

    def wait(self, seconds: float) -> None:
        """Run on without an order."""
        for _ in range(round(seconds / self.flight.tick)):
            self.check(self.flight.step())

    def check(self, outputs: Outputs, orders: tuple[Order, ...] = ()) -> None:
        """Compare one step with the invariants."""
        command, s = outputs.command, outputs.command.setpoint
        numbers = (s.theta, s.phi, s.vz, s.yaw_rate)
        tilt = self.limits.tilt_max + 1e-9
        bounds = (tilt, tilt, self.limits.full_climb, self.limits.yaw_rate_max)
        assert all(isfinite(n) and abs(n) <= b + 1e-9 for n, b in zip(numbers, bounds, strict=True))
        for order in orders:
            # A cut that the drone does not confirm is given up after a while, and told; a landing
            # may follow, but nothing that moves without a fresh order.
            self.cut = self.cut and order.kind not in (OrderKind.RESET, *MOVING_ORDERS)
            self.cut = self.cut or order.kind is OrderKind.CUT
            self.stopped = self.stopped and order.kind is not OrderKind.RESUME
            self.stopped = self.stopped or order.kind is OrderKind.STOP
        if outputs.safety is SafetyMode.CUT:
            assert command.action in (Action.CUT, Action.RESET, Action.IDLE), command
        if self.cut or self.stopped or outputs.safety is SafetyMode.STOPPED:
            assert command.action is not Action.TAKE_OFF
            assert command.action is not Action.FLY or outputs.safety in RESCUES, outputs.reason
        if command.action is Action.TAKE_OFF:
            assert self.ordered, "took off without an order"
        if command.action is Action.CUT and self.flight.body.z > 0.3:
            told = self.flight.heard.status is DroneStatus.EMERGENCY
            assert self.was_cut or told, outputs.reason
        landed = self.flight.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY)
        if landed and outputs.phase is Phase.IDLE and not orders:
            self.ordered = False

    def mend(self) -> None:
        """End every fault."""
        self.odd_sighting = self.odd_report = None
        self.flight.talks, self.flight.tracking.gaps = True, ()
        self.flight.wind, self.flight.around = (0.0, 0.0), lambda flight: ()

    def teardown(self) -> None:
        """Whatever the story was, somebody who orders a landing has the drone on the floor."""
        if not hasattr(self, "flight"):
            return
        self.mend()
        # Until its next report a drone that was silent counts as standing where it stood.
        self.wait(0.2)
        self.give(self.flight.order(OrderKind.LAND))
        self.give(self.flight.order(OrderKind.LAND))
        for _ in range(60):
            if self.flight.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY):
                break
            self.wait(0.5)
        assert self.flight.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY)
        self.wait(0.2)
        assert self.flight.outputs.command.action is not Action.FLY


def _same(sighting: Sighting) -> Sighting:
    return sighting


def play(fly: Fly, stories: int, steps: int) -> None:
    OrdersAndFaults.fly = fly
    run_state_machine_as_test(
        OrdersAndFaults,
        settings=settings(
            max_examples=stories,
            stateful_step_count=steps,
            deadline=None,
            # Making a story shorter takes minutes: it is short enough to read.
            phases=(Phases.generate,),
            suppress_health_check=list(HealthCheck),
        ),
    )


def test_no_order_and_no_fault_breaks_what_must_always_hold(fly: Fly) -> None:
    play(fly, stories=25, steps=15)


@pytest.mark.safety
@pytest.mark.timeout(3600)
def test_no_order_and_no_fault_breaks_what_must_always_hold_in_many_long_stories(fly: Fly) -> None:
    play(fly, stories=300, steps=40)
