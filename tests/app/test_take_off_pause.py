"""The pilot gives its word only while the drone stands, and then takes no order to fly."""

from __future__ import annotations

import pytest

from housefly.app.take_off_pause import RISING_ORDERS, TAKE_OFF_PAUSE_TIME, TakeOffPause
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Order,
    OrderKind,
    Outputs,
    Phase,
    Telemetry,
)

NOW = 100.0
IDLE = Outputs(Command(Action.IDLE))


def drone(status: DroneStatus = DroneStatus.LANDED, age: float = 0.05) -> Telemetry:
    return Telemetry(NOW - age, status, 0.9)


def order(kind: OrderKind) -> Order:
    return Order(kind, issued_at=NOW, sender="test")


def test_while_it_stands_down_it_takes_every_order_but_those_that_fly() -> None:
    word = TakeOffPause()
    every = tuple(order(kind) for kind in OrderKind)
    assert word.allowed(every, NOW) == (every, ())
    assert word.begin(NOW, drone(), IDLE, (order(OrderKind.STOP),)) == ""
    passed, told = word.allowed(every, NOW + TAKE_OFF_PAUSE_TIME - 0.1)
    assert {one.kind for one in every} - {one.kind for one in passed} == RISING_ORDERS
    assert OrderKind.STOP in {one.kind for one in passed}
    assert len(told) == len(RISING_ORDERS)
    assert all("refused: the pilot starts again" in one.event(NOW).text for one in told)


def test_after_a_while_that_nobody_ended_it_flies_again() -> None:
    word = TakeOffPause()
    word.begin(NOW, drone(), IDLE, ())
    every = (order(OrderKind.TAKE_OFF),)
    assert word.allowed(every, NOW + TAKE_OFF_PAUSE_TIME) == (every, ())


@pytest.mark.parametrize(
    ("telemetry", "outputs", "waiting", "why"),
    [
        (None, IDLE, (), "not heard"),
        (drone(age=2.0), IDLE, (), "not heard"),
        *(
            (drone(status), IDLE, (), "does not stand")
            for status in DroneStatus
            if status is not DroneStatus.LANDED
        ),
        (drone(), None, (), "about to fly"),
        (drone(), Outputs(Command(Action.TAKE_OFF), phase=Phase.TAKING_OFF), (), "about to fly"),
        *(
            (drone(), IDLE, (order(kind),), "has just come")
            for kind in sorted(RISING_ORDERS, key=str)
        ),
    ],
)
def test_in_doubt_it_gives_no_word_and_flies_on(
    telemetry: Telemetry | None, outputs: Outputs | None, waiting: tuple[Order, ...], why: str
) -> None:
    word = TakeOffPause()
    assert why in word.begin(NOW, telemetry, outputs, waiting)
    every = (order(OrderKind.TAKE_OFF),)
    assert word.allowed(every, NOW + 0.1) == (every, ())
