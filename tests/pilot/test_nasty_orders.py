"""Orders with nasty values are refused in words at every edge; no step of the pilot raises."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import inf, nan
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.errors import WireError
from housefly.messages import Action, Order, OrderKind, Phase
from housefly.messages.order_fault import CALMING_ORDERS, order_fault

TOPICS = DroneTopics()

Fly = Callable[..., Any]
NUMBERS = st.floats() | st.sampled_from(
    [1e308, -1e308, 1.7e308, 1e300, 1e18, 2.0**63, 1e4, -0.0, 5e-324, inf, -inf, nan]
)
WORDS = st.sampled_from(["", "entrance", "\0", "\n[x]", "x" * 5000, "\ud800", "../..", "é" * 61])
ORDERS = st.builds(
    Order,
    st.sampled_from(OrderKind),
    WORDS,
    st.none() | st.tuples(NUMBERS, NUMBERS),
    st.none() | st.tuples(NUMBERS, NUMBERS, NUMBERS),
    NUMBERS,
    NUMBERS,
    WORDS,
)
NASTY = [
    Order(OrderKind.GO, goal=(1e308, 1e308)),
    Order(OrderKind.GO, goal=(-1e308, 1.0)),
    Order(OrderKind.GO, goal=(nan, 1.0)),
    Order(OrderKind.GO, goal=(1.0, inf)),
    Order(OrderKind.SERVICE, goal=(1e6, 1e6)),
    Order(OrderKind.SERVICE, "entrance", look_s=nan),
    Order(OrderKind.SERVICE, "entrance", look_s=-1.0),
    Order(OrderKind.SERVICE, "entrance", look_s=1e9),
    Order(OrderKind.GO, "entrance", look_at=(1e308, 0.0, 0.0)),
    Order(OrderKind.GO, "x" * 5000),
    Order(OrderKind.GO, "a\nb"),
    Order(OrderKind.GO, "entrance", sender="x" * 500),
    Order(OrderKind.GO, "entrance", sender="a\x1b[2Jb"),
]


@pytest.mark.parametrize("order", NASTY, ids=lambda order: repr(order)[:60])
def test_a_nasty_order_is_refused_in_flight_in_words_and_the_drone_stays(
    fly: Fly, order: Order
) -> None:
    flight = fly()
    flight.take_off()
    values = {name: getattr(order, name) for name in ("place", "goal", "look_at", "look_s")}
    outputs = flight.step(flight.order(order.kind, sender=order.sender, **values))
    assert [event.code for event in outputs.events] == ["order_refused"]
    assert outputs.phase is Phase.HOLDING
    assert outputs.command.action in (Action.FLY, Action.HOVER)
    assert len(outputs.events[0].text) < 300


def test_no_step_raises_whatever_the_order(fly: Fly) -> None:
    flight = fly()
    flight.take_off()

    @settings(max_examples=100)
    @given(order=ORDERS, kind=st.sampled_from([OrderKind.GO, OrderKind.SERVICE, OrderKind.HOVER]))
    def step(order: Order, kind: OrderKind) -> None:
        fresh = replace(order, kind=kind, issued_at=flight.now + flight.tick)
        flight.step(fresh, replace(fresh, place=""))

    step()


@pytest.mark.parametrize("order", NASTY, ids=lambda order: repr(order)[:60])
def test_the_bus_neither_sends_nor_delivers_it(order: Order) -> None:
    heard: list[Order] = []
    with LocalBus() as bus:
        bus.subscribe(TOPICS.order, heard.append)
        with pytest.raises(WireError, match="order"):
            bus.publish(TOPICS.order, order)
    assert heard == []


@given(st.sampled_from(sorted(CALMING_ORDERS, key=str)), ORDERS)
def test_what_makes_things_safer_always_passes(kind: OrderKind, order: Order) -> None:
    assert order_fault(Order(kind, order.place, order.goal, order.look_at, order.look_s)) == ""
