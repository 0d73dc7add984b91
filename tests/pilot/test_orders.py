from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import product
from typing import Any

import pytest

from housefly.geometry import distance
from housefly.messages import (
    Action,
    DroneStatus,
    Order,
    OrderKind,
    Phase,
    SafetyMode,
    Severity,
    Telemetry,
)

Fly = Callable[..., Any]


def refused(flight: Any) -> str:
    return next(
        (event.text for event in reversed(flight.events) if event.code == "order_refused"), ""
    )


def test_take_off_is_asked_until_the_drone_says_that_it_flies_then_it_holds(fly: Fly) -> None:
    flight = fly()
    flight.run(0.5)
    outputs = flight.step(flight.order(OrderKind.TAKE_OFF))
    while outputs.phase is Phase.TAKING_OFF:
        assert outputs.command.action is Action.TAKE_OFF
        outputs = flight.step()
    assert outputs.phase is Phase.HOLDING and flight.heard.status is DroneStatus.FLYING
    here = (flight.body.x, flight.body.y)
    flight.run(5.0)
    assert distance((flight.body.x, flight.body.y), here) < 0.1
    assert abs(flight.body.z - flight.site.map.flight_height) < 0.05


def test_a_drone_that_never_takes_off_is_given_up_in_time(fly: Fly) -> None:
    flight = fly(delay=1e9)
    flight.run(0.5)
    flight.step(flight.order(OrderKind.TAKE_OFF))
    flight.until(
        lambda o: o.phase is not Phase.TAKING_OFF, flight.site.limits.take_off_timeout + 0.5
    )
    assert flight.told("overdue")
    assert flight.run(0.1).phase is Phase.IDLE


def test_a_landing_that_is_not_acknowledged_is_told_and_still_asked(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    flight.talks = False
    flight.step(flight.order(OrderKind.LAND))
    outputs = flight.run(flight.site.limits.landing_timeout + 1.0)
    assert flight.told("landing_late")
    assert outputs.command.action is Action.LAND


def test_land_comes_down_where_the_drone_is(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    flight.step(flight.order(OrderKind.LAND))
    outputs = flight.until(lambda o: o.phase is Phase.IDLE, 10.0)
    assert flight.status is DroneStatus.LANDED and outputs.command.action is Action.IDLE


def test_hover_ends_the_mission_and_holds_here(fly: Fly) -> None:
    flight = fly()
    flight.depart(6.0)
    outputs = flight.step(flight.order(OrderKind.HOVER))
    here = (flight.body.x, flight.body.y)
    assert outputs.phase is Phase.HOLDING
    flight.run(8.0)
    assert distance((flight.body.x, flight.body.y), here) < 0.5 and flight.speed < 0.05


def test_home_brings_the_drone_back_onto_its_pad(fly: Fly) -> None:
    flight = fly()
    flight.run(0.5)
    flight.step(flight.order(OrderKind.GO, goal=(4.0, 3.0)))
    flight.until(lambda o: o.phase is Phase.HOLDING)
    flight.step(flight.order(OrderKind.HOME))
    flight.until(lambda o: o.phase is Phase.IDLE)
    assert flight.home_error < 0.1


def test_a_second_goal_on_the_way_takes_over(fly: Fly) -> None:
    flight = fly()
    flight.depart(4.0)
    flight.step(flight.order(OrderKind.GO, goal=(3.0, 3.5)))
    flight.until(lambda o: o.phase is Phase.HOLDING)
    assert distance((flight.body.x, flight.body.y), (3.0, 3.5)) < 0.2


def test_stop_brakes_at_once_latches_and_needs_resume_and_a_fresh_order(fly: Fly) -> None:
    flight = fly()
    flight.depart(3.0)
    begun = flight.body
    outputs = flight.step(flight.order(OrderKind.STOP))
    assert outputs.command.setpoint.theta < -0.05 and outputs.safety is SafetyMode.STOPPED
    flight.step(flight.order(OrderKind.GO, place="entrance"))
    assert "STOP is latched" in refused(flight)
    assert flight.run(3.0).safety is SafetyMode.STOPPED
    assert distance((flight.body.x, flight.body.y), (begun.x, begun.y)) < 0.4
    flight.step(flight.order(OrderKind.RESUME))
    outputs = flight.run(5.0)
    assert outputs.phase is Phase.HOLDING and outputs.safety is SafetyMode.NOMINAL
    flight.step(flight.order(OrderKind.HOME))
    flight.until(lambda o: o.phase is Phase.IDLE)
    assert flight.home_error < 0.1


def test_resume_without_stop_disturbs_nothing(fly: Fly) -> None:
    flight = fly()
    flight.depart()
    assert flight.step(flight.order(OrderKind.RESUME)).phase is Phase.OUTBOUND
    assert flight.until(lambda o: o.phase is Phase.HOLDING).goal_name == "entrance"


def test_the_motors_are_cut_once_and_only_reset_leaves_the_emergency(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    outputs = flight.step(flight.order(OrderKind.CUT))
    assert outputs.command.action is Action.CUT and outputs.safety is SafetyMode.CUT
    outputs = flight.until(lambda o: flight.heard.status is DroneStatus.EMERGENCY, 1.0)
    assert outputs.command.action is Action.IDLE and outputs.phase is Phase.IDLE
    outputs = flight.step(flight.order(OrderKind.CUT))
    assert outputs.command.action is Action.IDLE
    flight.run(1.0)
    flight.step(flight.order(OrderKind.TAKE_OFF))
    assert "emergency" in refused(flight)
    outputs = flight.step(flight.order(OrderKind.RESET))
    assert outputs.command.action is Action.RESET
    outputs = flight.until(lambda o: flight.heard.status is DroneStatus.LANDED, 1.0)
    assert outputs.command.action is Action.IDLE
    flight.step(flight.order(OrderKind.RESET))
    assert "no emergency" in refused(flight)


@pytest.mark.parametrize(
    ("order", "word"),
    [
        (Order(OrderKind.GO, place="moon"), "known places"),
        (Order(OrderKind.GO), "neither a place nor a goal"),
        (Order(OrderKind.GO, goal=(6.0, 1.0)), "nearest free place"),
        (Order(OrderKind.SERVICE, goal=(99.0, 1.0)), "outside"),
        (Order(OrderKind.GO, goal=(float("nan"), 1.0)), "not a position"),
        (Order(OrderKind.HOME), "on the ground"),
        (Order(OrderKind.HOVER), "on the ground"),
    ],
)
def test_an_order_that_cannot_be_done_is_refused_in_words_and_nothing_moves(
    fly: Fly, order: Order, word: str
) -> None:
    flight = fly()
    flight.run(0.5)
    outputs = flight.step(Order(order.kind, order.place, order.goal, issued_at=flight.now))
    assert word in refused(flight)
    assert outputs.phase is Phase.IDLE and outputs.command.action is Action.IDLE


def test_an_old_order_a_weak_battery_and_missing_tracking_keep_the_drone_down(fly: Fly) -> None:
    flight = fly()
    flight.run(2.0)
    flight.step(Order(OrderKind.TAKE_OFF, issued_at=flight.now - 0.6))
    assert "expire" in refused(flight)
    flight.battery = 0.18
    flight.run(0.2)
    flight.step(flight.order(OrderKind.TAKE_OFF))
    assert "battery" in refused(flight)
    blind = fly(tracking={"gaps": ((0.0, 99.0),)})
    blind.run(0.5)
    assert blind.step(blind.order(OrderKind.TAKE_OFF)).phase is Phase.IDLE
    assert "tracking" in refused(blind)


def test_nothing_moves_before_the_drone_and_the_tracking_were_heard(fly: Fly) -> None:
    flight = fly()
    flight.heard, flight.talks = None, False
    flight.run(0.2)
    assert (
        flight.step(flight.order(OrderKind.SERVICE, place="entrance")).command.action is Action.IDLE
    )
    assert "does not answer" in refused(flight)


def test_a_drone_that_flies_after_its_motors_were_cut_is_landed(fly: Fly) -> None:
    flight = fly()
    flight.run(0.5)
    flight.report = _with_status(flight.report, DroneStatus.LANDED)
    flight.step(flight.order(OrderKind.CUT))
    flight.until(lambda _: flight.told("not_acknowledged"), 20.0)
    flight.report = _with_status(flight.report, DroneStatus.FLYING)
    flight.run(0.5)
    actions = {flight.step().command.action for _ in range(150)}
    assert actions == {Action.LAND}
    assert flight.outputs.phase is Phase.LANDING and flight.told("flies_after_cut")


def test_a_drone_in_the_air_that_does_not_obey_a_cut_is_landed(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    become = flight._become
    flight._become = lambda status: status is DroneStatus.EMERGENCY or become(status)
    flight.step(flight.order(OrderKind.CUT))
    flight.until(lambda _: flight.told("not_acknowledged"), 20.0)
    flight.until(lambda o: o.phase is Phase.IDLE, 15.0)
    assert flight.status is DroneStatus.LANDED


def test_a_fresh_order_after_a_cut_flies_as_ever(fly: Fly) -> None:
    flight = fly()
    flight.run(0.5)
    flight.step(flight.order(OrderKind.CUT))
    flight.run(1.0)
    flight.step(flight.order(OrderKind.RESET))
    flight.run(1.0)
    assert flight.status is DroneStatus.LANDED
    flight.take_off()
    assert flight.run(2.0).phase is Phase.HOLDING and not flight.told("flies_after_cut")


def test_a_pilot_that_starts_with_the_drone_in_the_air_holds_it_and_says_so(fly: Fly) -> None:
    flight = fly()
    flight.status, flight.body = DroneStatus.FLYING, flight.body._replace(z=1.1)
    outputs = flight.run(0.5)
    assert outputs.phase is Phase.HOLDING
    assert any("without an order" in event.text for event in flight.events)
    flight.step(flight.order(OrderKind.LAND))
    flight.until(lambda o: o.phase is Phase.IDLE, 10.0)


@pytest.mark.parametrize(("kind", "phase"), list(product(OrderKind, Phase)))
def test_every_order_in_every_phase_leaves_the_pilot_sane(
    fly: Fly, kind: OrderKind, phase: Phase
) -> None:
    flight = fly()

    def begun() -> Any:
        if phase is Phase.IDLE:
            return flight.run(0.5)
        flight.run(0.5)
        going = OrderKind.GO if phase is Phase.HOLDING else OrderKind.SERVICE
        flight.step(flight.order(going, goal=(3.0, 2.5), look_s=3.0))
        return flight.until(lambda o: o.phase is phase)

    flight.begin(f"until {phase}", begun)
    answered = flight.step(flight.order(kind, goal=(3.5, 3.0), id="mine"))
    (answer,) = answered.answers
    assert answer.order_id == "mine"
    assert answer.is_taken is not any(e.code == "order_refused" for e in answered.events)
    assert flight.step(flight.order(OrderKind.RESUME)).answers == (), "nobody waits for one"
    flight.run(1.0)
    flight.step(flight.order(OrderKind.LAND))
    outputs = flight.until(lambda o: o.phase is Phase.IDLE, 15.0)
    assert outputs.command.action in (Action.IDLE, Action.CUT)
    assert kind is OrderKind.CUT or not any(
        event.severity is Severity.FAULT for event in flight.events
    )


def _with_status(report: Callable[[], Telemetry], status: DroneStatus) -> Callable[[], Telemetry]:
    return lambda: replace(report(), status=status)
