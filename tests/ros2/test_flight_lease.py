"""Who has a drone that flies, from the steps of its pilot."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Inputs,
    Order,
    OrderAnswer,
    OrderKind,
    OrderOutcome,
    OrderSource,
    Outputs,
    Phase,
    PilotStep,
    Telemetry,
)
from housefly.ros2.flight_lease import FlightLease


def step(
    status: DroneStatus, *orders: Order, refused: bool = False, sequence: int = 0
) -> PilotStep:
    answers = tuple(OrderAnswer(one.id, OrderOutcome.WRONG_PHASE) for one in orders if refused)
    inputs = Inputs(telemetry=Telemetry(1.0, status, 0.9), orders=orders)
    return PilotStep(sequence, 1.0, inputs, Outputs(Command(Action.IDLE), answers=answers))


def order(kind: OrderKind, sender: str, source: OrderSource = OrderSource.PERSON) -> Order:
    return Order(kind, sender=sender, source=source, id=f"{kind}-{sender}")


def test_who_ordered_the_flight_has_it_until_it_stands() -> None:
    lease = FlightLease()
    lease.add(step(DroneStatus.LANDED, order(OrderKind.GO, "Anna")))
    lease.add(step(DroneStatus.FLYING))
    assert lease.objection("ROS 2") == "Anna flies it"
    assert lease.objection("Anna") == ""
    lease.add(step(DroneStatus.LANDED))
    assert lease.objection("ROS 2") == ""


def test_a_task_and_a_stop_are_said_to_be_what_they_are() -> None:
    lease = FlightLease()
    lease.add(step(DroneStatus.FLYING, order(OrderKind.GO, "visitor", OrderSource.TASK)))
    assert lease.objection("ROS 2") == "a task flies it: cancel that first"
    lease.add(step(DroneStatus.FLYING, order(OrderKind.STOP, "Anna")))
    assert "Resume is a person's" in lease.objection("ROS 2")


def test_an_order_that_was_refused_takes_nothing() -> None:
    lease = FlightLease()
    lease.add(step(DroneStatus.FLYING, order(OrderKind.GO, "ROS 2")))
    lease.add(step(DroneStatus.FLYING, order(OrderKind.HOME, "Anna"), refused=True))
    assert lease.objection("ROS 2") == ""


@given(st.lists(st.tuples(st.sampled_from(DroneStatus), st.sampled_from(OrderKind))))
def test_nobody_is_refused_a_drone_that_stands(flown: list[tuple[DroneStatus, OrderKind]]) -> None:
    lease = FlightLease()
    for status, kind in flown:
        lease.add(step(status, order(kind, "Anna")))
    lease.add(step(DroneStatus.LANDED))
    assert lease.objection("anybody") == ""


def test_a_flight_that_was_ordered_has_its_owner_before_the_propellers_turn() -> None:
    lease = FlightLease()
    takes_off = Outputs(Command(Action.TAKE_OFF), phase=Phase.TAKING_OFF)
    ordered = step(DroneStatus.LANDED, order(OrderKind.GO, "Anna"))
    lease.add(replace(ordered, outputs=takes_off))
    lease.add(replace(step(DroneStatus.LANDED), outputs=takes_off))
    lease.add(step(DroneStatus.TAKING_OFF))
    assert lease.objection("ROS 2") == "Anna flies it"


def test_who_gives_the_drone_back_flies_it_no_longer() -> None:
    lease = FlightLease()
    lease.add(step(DroneStatus.FLYING, order(OrderKind.GO, "ROS 2")))
    lease.give_back("another")
    assert lease.holder is not None
    lease.give_back(lease.holder.id)
    assert lease.objection("anybody") == ""
