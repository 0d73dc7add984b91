"""What a tick is told: everything since the last one, once, and only what people ordered."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import (
    Action,
    Command,
    Estimate,
    Event,
    EventCode,
    Inputs,
    Order,
    OrderKind,
    OrderSource,
    Outputs,
    PilotStep,
    Severity,
)
from housefly.tasks.execution.step_inbox import StepInbox, task_sender

OF_TASKS = (OrderSource.TASK, OrderSource.RULE, OrderSource.ASSISTANT)


def step(sequence: int, order: Order | None = None) -> PilotStep:
    orders = () if order is None else (order,)
    event = Event(float(sequence), Severity.INFO, EventCode.GOING_ON, str(sequence))
    return PilotStep(
        sequence,
        float(sequence),
        Inputs(orders=orders),
        Outputs(Command(Action.HOVER), events=(event,)),
    )


@given(st.lists(st.booleans(), max_size=60))
def test_each_event_is_told_once_whenever_the_ticks_come(ticks: list[bool]) -> None:
    inbox, told = StepInbox(), []
    for number, is_tick in enumerate(ticks):
        inbox.add(step(number))
        if is_tick:
            told += [event.text for event in inbox.drain(float(number), 0.0).events]
    told += [event.text for event in inbox.drain(99.0, 0.0).events]
    assert told == [str(number) for number in range(len(ticks))]


@given(st.integers(1, 10**6), st.text(max_size=200), st.sampled_from(OF_TASKS))
def test_an_order_of_a_task_is_known_as_such_and_a_persons_is_told(
    task: int, service: str, source: OrderSource
) -> None:
    ours = Order(OrderKind.GO, sender=task_sender(task, service), source=source)
    assert len(ours.sender) <= 100
    inbox = StepInbox()
    inbox.add(step(1, ours))
    assert inbox.is_flown_by_task
    theirs = Order(OrderKind.HOVER, sender="task 12: look")
    inbox.add(step(2, theirs))
    assert not inbox.is_flown_by_task, "what gave an order decides, and no name"
    assert inbox.drain(2.0, 0.0).orders == (theirs,)


@pytest.mark.parametrize("source", OrderSource)
def test_a_stop_takes_the_drone_from_a_task_whoever_gives_it(source: OrderSource) -> None:
    inbox = StepInbox()
    inbox.add(step(1, Order(OrderKind.STOP, source=source)))
    assert not inbox.is_flown_by_task and len(inbox.drain(1.0, 0.0).orders) == 1


def test_a_tick_knows_how_old_the_place_of_the_drone_is() -> None:
    inbox, estimate = StepInbox(), Estimate(1.0, (1.0, 2.0, 0.6), (0.0, 0.0, 0.0), 0.0, 0.7, 0.01)
    inbox.add(PilotStep(1, 1.0, Inputs(), Outputs(Command(Action.HOVER), estimate)))
    told = inbox.drain(1.0, 0.0)
    assert (told.position, told.pose_age) == (estimate.position, 0.7)


def test_a_pilot_that_begins_to_count_anew_is_another_run() -> None:
    inbox = StepInbox()
    assert inbox.age(5.0) == float("inf")
    for number in (5, 6, 7):
        inbox.add(step(number))
    assert inbox.run == 0
    inbox.add(step(0))
    assert (inbox.run, inbox.steps) == (1, 4)
