from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.app.order_inbox import (
    ORDERS_MAX,
    ORDERS_PER_STEP,
    SENDER_ORDERS_MAX,
    STOPPING_ORDERS,
    OrderInbox,
)
from housefly.clock import SteppedClock
from housefly.messages import Order, OrderKind

ALWAYS = {OrderKind.STOP, OrderKind.LAND, OrderKind.CUT, OrderKind.NUDGE}


def order(kind: OrderKind, sender: str = "person") -> Order:
    return Order(kind, sender=sender)


def drained(inbox: OrderInbox) -> list[Order]:
    """Return what all further steps take."""
    taken: list[Order] = []
    while inbox.waiting:
        step = inbox.drain()
        assert len([o for o in step if o.kind not in ALWAYS]) <= ORDERS_PER_STEP
        taken.extend(step)
    return taken


def test_orders_are_taken_in_the_order_in_which_they_came() -> None:
    inbox = OrderInbox(SteppedClock(10.0))
    given = [order(kind) for kind in (OrderKind.GO, OrderKind.HOME, OrderKind.RESUME)]
    for one in given:
        inbox.add(one)
    assert inbox.waiting == tuple(given)
    assert drained(inbox) == given and inbox.told() == ()


def test_who_gives_too_many_is_named_and_a_person_is_heard_all_the_same() -> None:
    clock = SteppedClock(10.0)
    inbox = OrderInbox(clock)
    for _ in range(1000):
        inbox.add(order(OrderKind.GO, "loop"))
    inbox.add(order(OrderKind.HOME))
    taken = drained(inbox)
    assert len(taken) == SENDER_ORDERS_MAX + 1 and taken[-1] == order(OrderKind.HOME)
    assert inbox.told() == ()
    clock.advance(1.0)
    (event,) = inbox.told()
    assert event.text.startswith("'loop' gives too many orders: 980 were refused")
    assert inbox.told() == ()
    inbox.add(order(OrderKind.GO, "loop"))
    assert len(drained(inbox)) == 1


def test_who_waits_for_an_answer_hears_that_an_order_was_left_out() -> None:
    inbox = OrderInbox(SteppedClock(10.0))
    for number in range(1000):
        inbox.add(Order(OrderKind.GO, sender="loop", id=str(number)))
    given, answers = inbox.waiting, inbox.answers()
    assert [one.order_id for one in answers[:2]] == ["20", "21"] and len(answers) <= ORDERS_MAX
    inbox.add(order(OrderKind.STOP))
    taken = inbox.drain()
    left_out = [one.id for one in given if one not in taken]
    assert left_out and [one.order_id for one in inbox.answers()] == left_out
    assert inbox.answers() == ()


def test_a_thousand_names_are_no_way_around_it() -> None:
    clock = SteppedClock(10.0)
    inbox = OrderInbox(clock)
    for number in range(1000):
        inbox.add(order(OrderKind.GO, f"loop {number}"))
    assert len(drained(inbox)) == ORDERS_MAX
    clock.advance(1.0)
    assert len(inbox.told()) == 1


def test_of_motions_by_hand_the_newest_passes_however_many_there_are() -> None:
    clock = SteppedClock(10.0)
    inbox = OrderInbox(clock)
    for number in range(1000):
        inbox.add(Order(OrderKind.NUDGE, velocity=(0.0, 0.0, 0.001 * number), sender="stick"))
        if number % 10 == 9:
            assert [one.velocity for one in inbox.drain()] == [(0.0, 0.0, 0.001 * number)]
    clock.advance(1.0)
    assert inbox.told() == ()


@given(
    st.lists(st.sampled_from(OrderKind), max_size=60),
    st.sampled_from([OrderKind.STOP, OrderKind.LAND, OrderKind.CUT]),
)
def test_what_stops_the_drone_always_passes_and_has_the_last_word(
    before: list[OrderKind], stopping: OrderKind
) -> None:
    inbox = OrderInbox(SteppedClock(10.0))
    for kind in before:
        inbox.add(order(kind, "loop"))
    for _ in range(100):
        inbox.add(order(stopping))
    taken = inbox.drain()
    assert taken.count(order(stopping)) == 1
    assert taken[-1].kind in STOPPING_ORDERS and inbox.waiting == ()
